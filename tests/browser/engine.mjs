// Loads the explorer's engine (the files before anything touches the page) into node, and joins
// the page as the tool does.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
export const root = join(here, '..', '..');
const folder = join(root, 'src', 'pivots', 'explorer');
const read = (name) => readFileSync(join(folder, name), 'utf8');

export const scripts = read('scripts.txt').split('\n').filter(Boolean);

/// The engine; `change` may spoil its text, to prove that a test notices.
export function load_engine(change = (text) => text) {
  const names = scripts.slice(0, scripts.indexOf('number_text.js') + 1);
  const text = change(names.map(read).join('\n'));
  return new Function(`${text}\nreturn explorer;`)();
}

/// What `explorer_page` of the library makes of a trace.
export function assemble_page(trace) {
  const embedded = { ...trace, pivots: trace.pivots.map((pivot) => ({ ...pivot, tableau: null })) };
  const json = JSON.stringify(embedded).replace(/</g, '\\u003c');
  return read('explorer.html')
    .replace('/*STYLE*/', () => read('explorer.css'))
    .replace('/*SCRIPT*/', () => scripts.map(read).join('\n'))
    .replace('/*TRACE*/', () => json);
}
