// Runs the tool for the tests of pages.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { basename, resolve } from 'node:path';
import { root } from './engine.mjs';

export const [tool, folder, ...chosen] = process.argv.slice(2);
if (!tool || !folder) {
  console.error(`usage: node ${basename(process.argv[1])} TOOL OUTPUT_FOLDER [NAME..]`);
  process.exit(2);
}
export const out = resolve(folder);
mkdirSync(out, { recursive: true });

/// Writes what `words` ask for to `file`. Without an answer the tool exits with 1 and still writes:
/// `fails` says whether it should, null that either is fine.
export function run_tool(words, file, fails = null) {
  const call = [...words, '-o', file];
  let code = 0;
  try {
    execFileSync(tool, call, { cwd: root, stdio: ['ignore', 'ignore', 'pipe'] });
  } catch (failure) {
    code = failure.status;
    if (code !== 1 || !existsSync(file))
      throw new Error(`${tool} ${call.join(' ')}: ${failure.stderr}`);
  }
  if (fails !== null) assert.equal(code, fails ? 1 : 0, `${call.join(' ')}: exit`);
  return file;
}
