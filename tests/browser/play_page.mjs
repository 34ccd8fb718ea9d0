// A playground in headless Chromium, and what the tool says of its scene: for playground.mjs, whose
// arguments these are.
import assert from 'node:assert/strict';
import { execFile, execFileSync, spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { open, wide } from './chromium.mjs';
import { root } from './engine.mjs';
import { out, tool } from './tool.mjs';

export const fixture = (name) => join(root, 'fixtures', 'scenes', `${name}.toml`);
export const native = (command, path) =>
  spawnSync(tool, [command, path, '--json'], { encoding: 'utf8' }).stdout;

/// The tool's answers to scenes, made while the page makes its own: from(k) is a promise of the k-th's.
export function native_answers(texts) {
  const most_ahead = 4, promises = [];
  const begin = (k) => {
    const path = join(out, `random.${k % (2 * most_ahead)}.toml`);
    writeFileSync(path, texts[k]);
    // It ends with 1 where there is no answer, and says so.
    promises[k] = new Promise((done) => {
      execFile(tool, ['solve', path, '--json', '--seconds', '600'], { maxBuffer: 1 << 26 }, (_, said) => done(said));
    });
  };
  return (k) => {
    while (promises.length < Math.min(k + most_ahead, texts.length)) begin(promises.length);
    return promises[k];
  };
}

/// A page of the scene at `path`, ready.
export async function played(browser, path, options = wide, hash = '') {
  const file = join(out, 'play.html');
  execFileSync(tool, ['play', path, '-o', file]);
  const { page, faults, close } = await open(browser, file, options);
  if (hash) {
    await page.goto(`file://${file}${hash}`);
    await page.reload();
  }
  await page.waitForFunction(() => window.lcpush);
  const end = async () => {
    assert.deepEqual(faults, [], 'complaints and requests');
    await close();
  };
  return { page, end };
}

export const state = (page) => page.evaluate(() => {
  const { app } = window.lcpush;
  return { text: app.state.text, answer: app.state.written, sentence: app.state.sentence,
    failure: document.getElementById('failure').hidden ? ''
      : document.getElementById('failure').textContent };
});
export const settled = (page) => page.waitForFunction(() => window.lcpush.app.breaking?.text
  === window.lcpush.app.state.text);
/// What the tool says of the page's scene now.
export async function agrees(page) {
  const { text, answer } = await state(page);
  const path = join(out, 'now.toml');
  writeFileSync(path, text);
  assert.equal(answer, native('solve', path));
}

/// Where on the screen a body is.
export const middle_of = (page, name) => page.evaluate((body) => {
  const box = document.querySelector(`[data-body="${body}"]`).getBoundingClientRect();
  return [box.x + box.width / 2, box.y + box.height / 2];
}, name);
