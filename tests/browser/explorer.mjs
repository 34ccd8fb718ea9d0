// Drives the pages that `lcpush pivots --format html` writes in headless Chromium and compares
// every step with `--format json`.
//
//     node explorer.mjs TOOL OUTPUT_FOLDER [NAME..]
//
// Exit 0: all held. chromium.mjs says where the browser and its driver come from.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { check_after, check_marks, check_picture, check_pivot } from './checks.mjs';
import { check_all, open, phone, photograph, wide } from './chromium.mjs';
import { problems } from './problems.mjs';
import { chosen, out, run_tool } from './tool.mjs';

const written = (name, words, format) =>
  run_tool(['pivots', ...words, '--format', format], join(out, `${name}.${format}`));

/// Runs in the page: what is compared with the trace, numbers as the trace writes them.
function offer_state() {
  const { app } = window.lcpush;
  const { number_text, words, lemke, view_scene_text } = explorer; // the page's
  const { problem } = app;
  const name = (variable) => problem.names[variable];
  const value = (levels) => number_text.full_value(problem, levels);
  const values = (ratios) => ratios.map((x) => (x === null ? null : value(x)));
  const state = () => {
    const { path, frame } = app;
    const dictionary = path.dictionary(frame);
    const { pivot, run } = path.frames[frame];
    const step = path.step(frame);
    const [row, column] = step ? [dictionary.rows.indexOf(step.leaving),
      dictionary.columns.indexOf(step.entering)] : [-1, -1];
    const scene = view_scene_text.now(app);
    return {
      step: frame, last: path.last, pivot, run, status: path.outcome.status,
      branch: path.branch !== null, row, column,
      entering: step ? name(step.entering) : null, leaving: step ? name(step.leaving) : null,
      ties: step ? step.ties.map(name) : [], tie_break: step ? step.tie_break : 'none',
      ratios: step && step.ratios ? values(step.ratios) : [],
      basis: dictionary.rows.map(name), nonbasic: dictionary.columns.map(name),
      z0: value(path.z0(frame)),
      entries: () => dictionary.rows.map((_, r) => dictionary.columns.map((__, c) =>
        number_text.full_scalar(problem, dictionary.entry(r, c)))),
      values: () => dictionary.rows.map((_, r) => value(dictionary.value(r))),
      own_ratios: () => (step ? values(lemke.ratio_test(dictionary, column, 'lexicographic',
        step.entering === problem.artificial).ratios) : []),
      picture: scene && { ...scene.shown.finite, modes: scene.shown.modes,
        large: scene.shown.large, z: scene.z, w: scene.w },
    };
  };
  Object.assign(window.lcpush, { state, path: () => app.path,
    goto: (step) => { app.controls.stop(); app.go(step); },
    sentence_of: (path, frame) => words.meant_sentence(path, frame, path.step(frame)) });
}

const state_of = (page) => page.evaluate(() => {
  const state = window.lcpush.state();
  return { ...state, entries: state.entries(), values: state.values(),
    own_ratios: state.own_ratios() };
});

const marks_of = (page) => page.evaluate(() => {
  const names = (selector) => [...document.querySelectorAll(selector)]
    .map((cell) => cell.querySelector('.name').textContent);
  const cells = [...document.querySelectorAll('#tableau td.pivot')];
  return { entering: names('#tableau thead th.entering'),
    leaving: names('#tableau tr.leaving > th'), tied: names('#tableau tr.tied > th'),
    rows: names('#tableau tbody th'), pivot_cells: cells.length,
    pivot: cells.map((cell) => [Number(cell.dataset.row), Number(cell.dataset.column)]) };
});

const step_of = (page) => page.evaluate(() => window.lcpush.state().step);
const go = (page, step) => page.evaluate((k) => window.lcpush.goto(k), step);

/// Every step, or `most` of them spread evenly with the first and the last.
function steps_to_check(last, most) {
  const all = [...Array(last + 1).keys()];
  if (!most || all.length <= most) return all;
  return [...new Set(Array.from({ length: most }, (_, k) => Math.round(last * k / (most - 1))))];
}

async function check_steps(page, trace, { most_steps: most, rigid = false }) {
  const { last } = await page.evaluate(() => window.lcpush.state());
  assert.equal(last + 1, trace.pivots.length + trace.runs.length,
    'one frame a pivot, one a run end');
  for (const step of steps_to_check(last, most)) {
    await go(page, step);
    const state = await state_of(page);
    assert.equal(state.step, step);
    if (state.pivot !== null) check_pivot(trace, state.pivot, state);
    const done = state.pivot === null ? trace.pivots.length : state.pivot;
    const first = trace.runs[state.run].first_pivot;
    if (state.pivot !== null && done > first) check_after(trace, done - 1, state);
    if (step === last && trace.pivots.length > first) check_after(trace, done - 1, state);
    check_marks(state, await marks_of(page));
    if (trace.scene) check_picture(trace.scene, state.picture, rigid);
  }
}

async function check_controls(page) {
  const { last } = await page.evaluate(() => window.lcpush.state());
  const expect_step = async (step, what) => assert.equal(await step_of(page), step, what);
  if (last === 0) return;
  await go(page, 0);
  await page.click('#forward');
  await expect_step(1, 'forward');
  if (last > 1) await page.click('#last');
  await expect_step(last, 'last');
  await page.click('#back');
  await expect_step(last - 1, 'back');
  if (last > 1) await page.click('#first');
  await expect_step(0, 'first');
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('ArrowRight');
  await expect_step(1, 'right arrow');
  await page.keyboard.press('End');
  await expect_step(last, 'End');
  await page.keyboard.press('ArrowLeft');
  await expect_step(last - 1, 'left arrow');
  await page.keyboard.press('Home');
  await expect_step(0, 'Home');
  await page.locator('#slider').fill(String(last));
  await expect_step(last, 'slider');
  await page.locator('#jump').fill('1');
  await page.locator('#jump').press('Enter');
  await expect_step(1, 'jump');
  await page.locator('#jump').press('ArrowLeft');
  await expect_step(1, 'an arrow typed into the input is not a step');
  assert.equal(new URL(page.url()).hash, '#step=1');
  await page.evaluate(() => { location.hash = '#step=0'; });
  await page.waitForFunction(() => window.lcpush.state().step === 0);
  await page.locator('#speed').selectOption('fast');
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press(' ');
  await page.waitForFunction(() => window.lcpush.state().step >= 1);
  // At once: a short path may end, and would be played anew, between the look and the click.
  const here = await page.evaluate(() => {
    const play = document.getElementById('play');
    if (play.getAttribute('aria-pressed') === 'true') play.click();
    return window.lcpush.state().step;
  });
  await page.waitForTimeout(500);
  if (here < last) await expect_step(here, 'a pause stops');
  const chart = await page.locator('#chart svg').boundingBox();
  await page.locator('#chart svg').click({ position: { x: chart.width - 13, y: 60 } });
  assert.ok(await step_of(page) >= last - Math.ceil(last / 100),
    'a click at the right end of the chart');
}

/// A branch is told in the words of the recorded path: the page's own of a pivot are C++'s.
async function check_sentences(page, name) {
  const different = await page.evaluate(() => {
    const path = window.lcpush.path();
    return [...path.frames.keys()].filter((k) => path.step(k)).map((k) =>
      [path.step(k).sentence, window.lcpush.sentence_of(path, k)])
      .filter(([recorded, told]) => told !== null && told !== recorded);
  });
  assert.deepEqual(different.slice(0, 3), [], `${name}: sentences`);
}

/// Pivots count from 0, in words and in the plot, whose first point is z0 as pivot 0 lets it in.
async function check_numbering(page, trace) {
  const count = trace.pivots.length;
  if (count === 0 || trace.runs.length > 1) return;
  const step = () => page.locator('#step').textContent();
  const point = () => page.locator('#chart .here').allTextContents();
  await go(page, 0);
  assert.equal(await step(), `Pivot 0 of 0..${count - 1}`);
  assert.deepEqual(await point(), [], 'no z0 before pivot 0');
  await go(page, 1);
  assert.ok((await point()).every((text) => text !== '0'), 'z0 after pivot 0');
  await go(page, count);
  assert.equal(await step(), `After pivot ${count - 1} of 0..${count - 1}`);
  const panels = await page.locator('#chart .line').count();
  if (count < 60) assert.equal(await page.locator('#chart .dot').count(), panels * count);
}

/// Every row can be tried: the one that leaves goes on, one that may not says why.
async function check_tries(page) {
  await go(page, 0);
  const { last } = await page.evaluate(() => window.lcpush.state());
  if (last === 0) return;
  // Not by the mouse: it would scroll, and rows out of sight are not there.
  const press = (rows) => page.evaluate((selector) => {
    const button = document.querySelector(selector);
    if (button) button.click();
    return Boolean(button);
  }, `#tableau tr${rows} .ratio button`);
  if (await press(':not(.leaving):not(.tied)')) {
    assert.match(await page.locator('#tried').textContent(), /^Not .*\.$/);
    assert.equal(await step_of(page), 0, 'a wrong row changes nothing');
  }
  assert.ok(await press('.leaving'), 'ratios are buttons');
  assert.equal(await step_of(page), 1, 'the row that leaves goes on');
  assert.equal(await page.locator('#tried').textContent(), '');
}

/// The point of a problem with two pairs stands at q + z0 d.
async function check_cones(page, trace) {
  const shown = await page.locator('#cones-panel').isVisible();
  assert.equal(shown, trace.size === 2, 'cones for two pairs alone');
  if (!shown) return;
  const { last } = await page.evaluate(() => window.lcpush.state());
  const places = [];
  for (let step = 1; step <= last; ++step) {
    await go(page, step);
    places.push(await page.evaluate(() => {
      const of = (kind) => { const { cx, cy } = document.querySelector(`#cones circle.${kind}`);
        return [cx.baseVal.value, cy.baseVal.value]; };
      const [q, now] = [of('q'), of('now')];
      return { z0: Number(window.lcpush.state().z0.split('/').reduce((a, b) => a / b)),
        far: Math.hypot(q[0] - now[0], q[1] - now[1]) };
    }));
  }
  const { z0, far } = places.find((place) => place.z0 > 0);
  for (const place of places)
    assert.ok(Math.abs(place.far - far * place.z0 / z0) < 0.5, 'q + z0 d is in proportion to z0');
  const home = await page.locator('#cones .sector.basic').count();
  if (trace.status === 'solved') assert.equal(home, 1, 'one cone holds q');
}

/// Takes another tied row where there is one, follows the branch, and comes back.
async function check_branch(page, trace) {
  const k = trace.pivots.findIndex(({ ties }) => ties.length > 1);
  if (k < 0) return 0;
  const { last } = await page.evaluate(() => window.lcpush.state());
  let step = 0;
  for (; step <= last; ++step) {
    await go(page, step);
    if (await page.evaluate((pivot) => window.lcpush.state().pivot === pivot, k)) break;
  }
  const other = trace.pivots[k].ties.find((name) => name !== trace.pivots[k].leaving);
  await page.locator(`#choices button[data-variable="${other}"]`).click();
  const state = await state_of(page);
  assert.ok(state.branch);
  assert.equal(state.step, step + 1);
  assert.ok(state.basis.includes(trace.pivots[k].entering));
  assert.ok(!state.basis.includes(other));
  assert.ok(await page.locator('#branch').isVisible());
  assert.ok(['solved', 'ray', 'cycle', 'pivot_limit'].includes(state.status));
  if (state.step < state.last) await page.click('#last');
  const end = await state_of(page);
  if (end.status === 'solved') assert.ok(!end.basis.includes('z0'));
  await page.click('#return');
  const back = await state_of(page);
  assert.ok(!back.branch);
  assert.equal(back.step, step);
  check_pivot(trace, k, back);
  return 1;
}

/// Large, on a projector of 1280 x 720: the tableau ends above the buttons, a small one is seen whole, and one
/// that scrolls says so.
async function check_room(page, size) {
  await page.setViewportSize({ width: 1280, height: 720 });
  await go(page, 1);
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.keyboard.press('l');
  const seen = await page.evaluate(() => {
    const box = document.getElementById('tableau');
    return { more: document.getElementById('more').textContent,
      hides: box.scrollWidth > box.clientWidth + 1 || box.scrollHeight > box.clientHeight + 1,
      under: box.getBoundingClientRect().bottom > document.querySelector('.controls').getBoundingClientRect().top };
  });
  assert.ok(!seen.under, 'rows under the buttons');
  assert.equal(seen.hides, seen.more !== '', 'says that it scrolls');
  if (size <= 5) assert.ok(!seen.hides, 'a small tableau is seen whole');
  await page.keyboard.press('l');
  await page.setViewportSize(wide.viewport);
}

async function check_layout(page, where, width) {
  const faults = await page.evaluate((viewport) => {
    const found = [];
    // Not innerWidth: a phone widens that to what it has to show.
    if (document.documentElement.scrollWidth > viewport) found.push('scrolls sideways');
    for (const button of document.querySelectorAll('.buttons button')) {
      const { width, height } = button.getBoundingClientRect();
      if (width < 44 || height < 44) found.push(`${button.id} is too small to touch`);
    }
    for (const text of document.querySelectorAll('svg text')) {
      const drawing = text.ownerSVGElement;
      const factor = drawing.getBoundingClientRect().width / drawing.viewBox.baseVal.width;
      if (parseFloat(getComputedStyle(text).fontSize) * factor < 10.5)
        found.push(`small text in a drawing: ${text.textContent}`);
      const [inner, outer] = [text.getBoundingClientRect(), drawing.getBoundingClientRect()];
      if (inner.width > 0 && (inner.left < outer.left - 2 || inner.right > outer.right + 2
        || inner.top < outer.top - 3 || inner.bottom > outer.bottom + 3))
        found.push(`cut text in a drawing: ${text.textContent}`);
    }
    const labels = (view) => [...view.querySelectorAll('.label')]
      .map((label) => label.getBoundingClientRect());
    for (const view of document.querySelectorAll('.view')) {
      labels(view).forEach((a, i) => labels(view).slice(i + 1).forEach((b) => {
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (across > 0 && down > 0) found.push('labels of the picture touch');
      }));
      const { left, right, top, bottom } = view.getBoundingClientRect();
      if (labels(view).some((a) => a.left < left + 2 || a.right > right - 2
        || a.top < top + 2 || a.bottom > bottom - 2))
        found.push("a label touches the picture's edge");
    }
    return found;
  }, width);
  assert.deepEqual(faults, [], where);
}

async function check_problem(browser, problem) {
  const { name } = problem;
  const json = written(name, problem.arguments, 'json');
  const html = written(name, problem.arguments, 'html');
  const trace = JSON.parse(readFileSync(json, 'utf8'));
  if (problem.status) assert.equal(trace.status, problem.status, `${name}: status`);
  let branches = 0;
  for (const [label, device, colorScheme] of [['wide_light', wide, 'light'],
    ['phone_dark', phone, 'dark']]) {
    const { page, faults, close } = await open(browser, html, { ...device, colorScheme,
      reducedMotion: colorScheme === 'dark' ? 'reduce' : 'no-preference' });
    await page.evaluate(offer_state);
    if (device === wide) {
      await check_steps(page, trace, problem);
      await check_controls(page);
      await check_sentences(page, name);
      await check_numbering(page, trace);
      await check_tries(page);
      await check_cones(page, trace);
      branches = await check_branch(page, trace);
      await check_room(page, trace.size);
    }
    const { last } = await page.evaluate(() => window.lcpush.state());
    for (const step of new Set([0, Math.floor(last / 2), last])) {
      await go(page, step);
      await check_layout(page, `${name}_${label}, step ${step}`, device.viewport.width);
      await page.evaluate(() => window.scrollTo(0, 0));
      await photograph(page, join(out, `${name}_${label}_${step}.png`));
    }
    assert.deepEqual(faults, [], label);
    await close();
  }
  console.log(`${name}: ${trace.pivots.length} pivots, ${trace.status}${
    branches ? ', branch' : ''}`);
}

await check_all(problems, chosen, out, check_problem);
