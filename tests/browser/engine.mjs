// Loads the explorer's engine (the files before anything touches the page) into node.
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
  const names = scripts.slice(0, scripts.indexOf('words.js') + 1);
  const text = change(names.map(read).join('\n'));
  return new Function(`${text}\nreturn explorer;`)();
}
