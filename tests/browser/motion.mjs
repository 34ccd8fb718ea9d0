// Opens the pages that `lcpush move --format html` writes in headless Chromium: the motion plays,
// steps and is scrubbed, what stands beside it is what `--json` says, and nothing complains, is
// fetched, runs over the edge of a screen or is hard to read.
//
//     node motion.mjs TOOL OUTPUT_FOLDER [NAME..]
//
// Exit 0: all held. chromium.mjs says where the browser and its driver come from.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { check_all, open, phone, photograph, wide } from './chromium.mjs';
import { contrast_faults, covered_words, layout_faults } from './page_faults.mjs';
import { chosen, out, run_tool } from './tool.mjs';

const scene = (name, ...more) => ({ name, arguments: [`fixtures/scenes/${name}.toml`, ...more] });
const problems = [
  scene('pivot'), scene('straight_slide', '--frames', '12'), scene('rolling', '--time', '0.5'),
  { name: 'two_strokes', arguments: ['docs/guide/two_strokes.toml', '--frames', '400'] },
  { ...scene('tipping'), ends_early: true }, { ...scene('jam'), ends_early: true },
];
const most_moments = 151; // drawn on a page

const written = ({ name, arguments: words, ends_early }, format) => run_tool(
  ['move', ...words, '--format', format], join(out, `${name}.${format}`), Boolean(ends_early));

/// What the page shows now.
const shown = (page) => page.evaluate(() => {
  const moments = [...document.querySelectorAll('.moment')];
  const visible = moments.filter((moment) => getComputedStyle(moment).display !== 'none');
  const cursor = document.getElementById('cursor');
  return { count: moments.length, drawn: visible.map((moment) => moments.indexOf(moment)),
    slider: Number(document.getElementById('time').value),
    heard: document.getElementById('time').getAttribute('aria-valuetext'),
    clock: document.getElementById('clock').textContent,
    button: document.getElementById('play').textContent,
    cursor: cursor ? parseFloat(cursor.style.left) : null,
    rows: [...document.querySelectorAll('#now tbody tr')].map((row) =>
      [...row.children].map((cell) => cell.textContent)) };
});

async function expect_moment(page, k, what) {
  const now = await shown(page);
  assert.deepEqual(now.drawn, [k], `${what}: one moment is drawn`);
  assert.equal(now.slider, k, `${what}: the slider`);
  return now;
}

async function scrub(page, k) {
  await page.locator('#time').fill(String(k));
}

/// Beside each moment stands what the frame says that it draws.
async function check_moments(page, frames, where) {
  const { count } = await shown(page);
  assert.equal(count, Math.min(frames.length, most_moments), `${where}: moments`);
  let cursor = -1;
  for (const k of new Set([0, 1, Math.floor(count / 3), count - 2, count - 1])) {
    if (k < 0 || k >= count) continue;
    await scrub(page, k);
    const now = await expect_moment(page, k, `${where}, scrubbed to ${k}`);
    const frame = frames[frames.length <= most_moments ? k
      : Math.floor(k * (frames.length - 1) / (most_moments - 1))];
    assert.equal(now.clock, `${frame.time.toFixed(3)} s`, `${where}: the clock`);
    assert.ok(now.heard.startsWith(now.clock), `${where}: the slider says its time`);
    assert.ok(now.cursor === null || now.cursor > cursor, `${where}: the cursor goes on`);
    cursor = now.cursor === null ? cursor : now.cursor;
    frame.bodies.forEach((body, b) => {
      const [name, normal, , points] = now.rows[b];
      assert.equal(name, body.name, where);
      if (frames.length === 1) return assert.equal(normal, '-', where);
      if (frame.step === 0) { // what acts once it has begun: nearly the next frame's
        const force = frames[1].bodies[b].normal_force;
        return assert.ok(Math.abs(Number(normal) - force) <= 0.05 * force + 1e-9,
          `${where}: ${name} begins with ${normal}, not about ${force}`);
      }
      assert.ok(Math.abs(Number(normal) - body.normal_force) <= 0.006 * body.normal_force + 1e-9,
        `${where}: ${name} presses with ${normal}, not ${body.normal_force}`);
      const contacts = frame.contacts.filter((contact) =>
        contact.name === name || contact.name.startsWith(`${name}.`));
      for (const [mode, verb] of [['stick', 'stick'], ['slide', 'slip'], ['beside', 'are beside']]) {
        const number = contacts.filter((contact) => contact.mode === mode).length;
        assert.equal(number > 0, points.includes(`${number} ${verb}`), `${where}: ${points}`);
      }
    });
  }
}

async function check_keys(page, where) {
  const { count } = await shown(page);
  await page.evaluate(() => document.activeElement.blur());
  const press = async (key, k) => {
    await page.keyboard.press(key);
    await expect_moment(page, Math.max(0, Math.min(count - 1, k)), `${where}, ${key}`);
  };
  await press('Home', 0);
  await press('ArrowLeft', 0);
  await press('ArrowRight', 1);
  await press('PageDown', 11);
  await press('PageUp', Math.max(0, Math.min(11, count - 1) - 10));
  await press('End', count - 1);
  await press('ArrowRight', count - 1);
  // A slider under focus has its own keys: they must not count twice.
  await page.locator('#time').focus();
  await page.keyboard.press('Home');
  await expect_moment(page, 0, `${where}, Home on the slider`);
  await page.keyboard.press('ArrowRight');
  await expect_moment(page, Math.min(1, count - 1), `${where}, right on the slider`);
}

/// Played to its end it stops there; played again it begins anew; a pause holds.
async function check_play(page, where) {
  const { count } = await shown(page);
  await scrub(page, Math.max(0, count - 4));
  await page.locator('#play').click();
  await page.waitForFunction((last) => Number(document.getElementById('time').value) === last
    && document.getElementById('play').textContent === 'Play', count - 1);
  if (count < 8) return;
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press(' ');
  // Paused where it is seen to play: a short motion may end between a look and a click.
  await page.waitForFunction(() => {
    const play = document.getElementById('play');
    const plays = Number(document.getElementById('time').value) >= 2 && play.textContent === 'Pause';
    if (plays) play.click();
    return plays;
  });
  const held = await shown(page);
  assert.equal(held.button, 'Play', where);
  assert.ok(held.slider < count - 1, `${where}: it began anew`);
  await page.waitForTimeout(250);
  assert.equal((await shown(page)).slider, held.slider, `${where}: a pause stops`);
  await page.locator('#play').focus();
  await page.keyboard.press(' ');
  await page.waitForFunction((k) => Number(document.getElementById('time').value) > k, held.slider);
  await page.locator('#play').click();
}

/// It plays by itself, but not for somebody who wants no motion.
async function check_begin(browser, file) {
  const { page, close } = await open(browser, file, { ...wide, reducedMotion: 'no-preference' });
  await page.waitForFunction(() => Number(document.getElementById('time').value) >= 2);
  await close();
}

/// What a screen reader is told, and that everything is reached by the keyboard.
async function check_names(page, where) {
  const devtools = await page.context().newCDPSession(page);
  const { nodes } = await devtools.send('Accessibility.getFullAXTree');
  const of_role = (role) => nodes.filter((node) => !node.ignored && node.role
    && node.role.value === role);
  for (const role of ['button', 'slider', 'image', 'table'])
    for (const node of of_role(role))
      if (role !== 'table') assert.ok(node.name && node.name.value, `${where}: a ${role} has no name`);
  assert.equal(of_role('slider').length, 1, `${where}: one slider`);
  assert.equal(of_role('button').length, 1, `${where}: one button`);
  assert.ok(of_role('image').length + of_role('img').length >= 1, `${where}: a picture`);
  for (const role of ['banner', 'main', 'contentinfo'])
    assert.equal(nodes.filter((node) => node.role && node.role.value === role).length, 1,
      `${where}: ${role}`);
  const small = await page.evaluate(() => [...document.querySelectorAll('.player button, .player input')]
    .filter((part) => part.getBoundingClientRect().height < 44).map((part) => part.id));
  assert.deepEqual(small, [], `${where}: large enough to touch`);
}

async function check_looks(page, where, device, scheme) {
  const layout = { viewport: device.viewport.width, least: 10.4 };
  assert.deepEqual(await page.evaluate(layout_faults, layout), [], where);
  const { found, texts, lines, paper } = await page.evaluate(contrast_faults);
  assert.deepEqual(found, [], where);
  assert.ok(texts > 12 && lines >= 1, `${where}: ${texts} texts, ${lines} lines`);
  assert.ok(scheme === 'dark' ? paper < 0.05 : paper > 0.8, `${where}: the paper is ${paper}`);
}

async function check_problem(browser, problem) {
  const { name } = problem;
  const html = written(problem, 'html');
  const { frames } = JSON.parse(readFileSync(written(problem, 'json'), 'utf8'));
  if (name === 'pivot') await check_begin(browser, html);
  for (const [size, device] of [['wide', wide], ['phone', phone]]) {
    for (const colorScheme of ['light', 'dark']) {
      const label = `${name}_${size}_${colorScheme}`;
      const { page, faults, close } = await open(browser, html,
        { ...device, colorScheme, reducedMotion: 'reduce' });
      const { count } = await shown(page);
      if (label.endsWith('wide_light')) {
        await check_moments(page, frames, label);
        await check_keys(page, label);
        await check_play(page, label);
        await check_names(page, label);
      }
      for (const k of new Set([0, Math.floor(count / 2), count - 1])) {
        await scrub(page, k);
        await check_looks(page, `${label}, moment ${k}`, device, colorScheme);
        assert.deepEqual(await page.evaluate(covered_words), [], `${label}, moment ${k}`);
        await photograph(page, join(out, `${label}_${k}.png`));
      }
      assert.deepEqual(faults, [], label);
      await close();
    }
  }
  console.log(`${name}: ${frames.length} frames`);
}

await check_all(problems, chosen, out, check_problem);
