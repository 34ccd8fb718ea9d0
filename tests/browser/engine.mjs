// Loads the pages' engines (the scripts before anything touches the page) into node.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
export const root = join(here, '..', '..');
const read = (folder) => (name) => readFileSync(join(root, 'src', folder, name), 'utf8');
const listed = (folder) => read(folder)('scripts.txt').split('\n').filter(Boolean);

/// The scripts of `folder` up to `last`, behind those that all pages draw with.
export function script_of(folder, last) {
  const names = listed(folder);
  return [...listed('draw/script').map(read('draw/script')),
    ...names.slice(0, names.indexOf(last) + 1).map(read(folder))].join('\n');
}

/// The explorer's engine; `change` may spoil its text, to prove that a test notices.
export function load_engine(change = (text) => text) {
  const text = change(script_of('pivots/explorer', 'words.js'));
  return new Function(`${text}\nreturn explorer;`)();
}
