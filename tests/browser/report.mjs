// Opens the pages and pictures that `lcpush report` writes in headless Chromium: nothing complains
// or is fetched, nothing runs over the edge of a screen or a picture, labels stay apart, and text
// and lines stand out from what is behind them, on a desktop and a phone, in light and in dark.
//
//     node report.mjs TOOL OUTPUT_FOLDER [NAME..]
//
// Exit 0: all held. chromium.mjs says where the browser and its driver come from.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { check_all, phone, photograph, reopen, wide } from './chromium.mjs';
import { root } from './engine.mjs';
import { contrast_faults, covered_words, layout_faults } from './page_faults.mjs';
import { chosen, out, run_tool } from './tool.mjs';

const scene = (name, ...more) => ({ name, arguments: [`fixtures/scenes/${name}.toml`, ...more] });
/// A fixture with other words in it.
function changed(name, file, changes) {
  let text = readFileSync(join(root, 'fixtures', 'scenes', `${file}.toml`), 'utf8');
  for (const [from, to] of changes) {
    assert.ok(text.includes(from), from);
    text = text.replaceAll(from, to);
  }
  const path = join(out, `${name}.toml`);
  writeFileSync(path, text);
  return { name, arguments: [path] };
}
const regression = (name) => ({ name, arguments: [`fixtures/regressions/${name}.toml`] });
/// Shipped scenes with more than their file says; the others are reported as they are.
const special = [
  scene('straight_slide', '--pressure', 'rigid', '--vary', '*.grip_force=2:30', '--vary',
    'object.mass=0.1:0.5', '--steps', '5'),
  scene('pivot', '--vary', 'edge.shift[0]=0:0.03', '--steps', '5'),
  scene('two_pushers', '--pusher', 'upper'),
  scene('rotating_pusher', '--facets', '8'), // round friction's label finds no place off the axis
  { ...scene('dropped'), failure: 'The grasp does not hold' }, { ...scene('jam'), failure: 'NOT SOLVED' },
];
const shipped = readdirSync(join(root, 'fixtures', 'scenes')).sort()
  .map((file) => file.replace('.toml', ''))
  .map((name) => special.find((problem) => problem.name === name) || scene(name));
const problems = [
  ...shipped,
  { name: 'runaway', arguments: ['fixtures/rays/runaway.toml'], failure: 'NOT SOLVED' },
  regression('lost_warm_rounds'), regression('almost_feasible_basis'),
  regression('forces_of_the_push_alone'),
  changed('names', 'straight_slide', [
    ['"wall"', `"the_wall_with_${'a_name_that_does_not_end_'.repeat(6)}"`],
    ['"left"', '"Zeigefinger \u00e4\u00f6\u00fc <links> & \\"vorn\\" \u6f22\u5b57"'],
    ['title = "', `title = "${'Verylongword'.repeat(8)} `]]),
  changed('many_points', 'ground', [['points = 6', 'points = 30']]),
];

const written = ({ arguments: words, failure }, file, ...more) =>
  run_tool(['report', ...words, ...more], file, Boolean(failure));

/// Runs in the page: labels in drawings of the grasp that touch something, as sentences. A label is
/// a group of lines; what it must not touch are the picture's border, other words and outlines.
function label_faults() {
  const found = [];
  const overlap = (a, b, room) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > -room
    && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > -room;
  const on_screen = (shape) => {
    const to_screen = shape.getScreenCTM();
    const length = shape.getTotalLength();
    const count = Math.max(60, Math.ceil(length));
    return Array.from({ length: count }, (_, k) =>
      shape.getPointAtLength(length * k / count).matrixTransform(to_screen));
  };
  let labels = 0;
  for (const drawing of document.querySelectorAll('svg[role=img]')) {
    const border = drawing.getBoundingClientRect();
    const factor = border.width / drawing.viewBox.baseVal.width;
    const groups = [...drawing.querySelectorAll('.words')];
    labels += groups.length;
    const boxes = groups.map((group) => group.getBoundingClientRect());
    const others = [...drawing.querySelectorAll('text')]
      .filter((text) => !text.closest('.words'));
    const outlines = [...drawing.querySelectorAll('.object, .pad, .thing, .ghost:not(.inner), .screw')]
      .map((outline) => [outline.getAttribute('class'), on_screen(outline)]);
    groups.forEach((group, i) => {
      const box = boxes[i];
      const words = `${drawing.querySelector('title').textContent}: "${group.textContent}"`
        .replaceAll('\n', ' ');
      const margin = 3 * factor;
      if (box.left < border.left + margin || box.right > border.right - margin
        || box.top < border.top + margin || box.bottom > border.bottom - margin)
        found.push(`${words} touches the picture's edge`);
      boxes.slice(i + 1).forEach((other, k) => {
        if (overlap(box, other, 0)) found.push(`${words} touches "${groups[i + 1 + k].textContent}"`);
      });
      for (const text of others)
        if (overlap(box, text.getBoundingClientRect(), 0))
          found.push(`${words} touches "${text.textContent}"`);
      for (const [kind, points] of outlines)
        if (points.some((at) => at.x > box.left && at.x < box.right
          && at.y > box.top + 2 * factor && at.y < box.bottom - 2 * factor))
          found.push(`${words} touches an outline of class ${kind}`);
    });
  }
  return { found, labels };
}

/// The page as it opens: everything in its place, no label on another thing.
async function check_layout(page, where, layout) {
  assert.deepEqual(await page.evaluate(layout_faults, layout), [], where);
  const { found: touching, labels } = await page.evaluate(label_faults);
  assert.deepEqual(touching, [], where);
  assert.ok(labels > 6, `${where}: ${labels} labels`);
  assert.deepEqual(await page.evaluate(covered_words), [], where);
}

const unfold = (page) => page.evaluate(() => document.querySelectorAll('details')
  .forEach((details) => { details.open = true; }));

/// The page with all that folds opened.
async function check_unfolded(page, problem, where, layout, scheme) {
  assert.deepEqual(await page.evaluate(layout_faults, layout), [], `${where}, all opened`);
  const { found, texts, lines, paper } = await page.evaluate(contrast_faults);
  assert.deepEqual(found, [], where);
  assert.ok(texts > 25 && lines > 3, `${where}: ${texts} texts, ${lines} lines`);
  assert.ok(scheme === 'dark' ? paper < 0.05 : paper > 0.8, `${where}: the paper is ${paper}`);
  const boxes = await page.evaluate(() => [...document.querySelectorAll('*')]
    .filter((e) => e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).overflowX === 'auto'
      && e.tabIndex < 0).length);
  assert.equal(boxes, 0, `${where}: a box that scrolls is reached by the keyboard`);
  const broken = await page.evaluate(() => [...document.images]
    .filter((image) => !image.complete || image.naturalWidth === 0).length);
  assert.equal(broken, 0, `${where}: images`);
  const failures = await page.locator('.failure').allTextContents();
  assert.equal(failures.length > 0, Boolean(problem.failure), where);
  if (problem.failure) assert.ok(failures[0].includes(problem.failure), where);
}

/// What a screen reader is told: every picture by name, and with a description.
async function check_names(page, where) {
  const devtools = await page.context().newCDPSession(page);
  const { nodes } = await devtools.send('Accessibility.getFullAXTree');
  const images = nodes.filter(({ ignored, role }) =>
    !ignored && role && ['image', 'img'].includes(role.value));
  assert.ok(images.length >= 2, `${where}: ${images.length} pictures`);
  for (const image of images)
    assert.ok(image.name && image.name.value, `${where}: a picture without a name`);
  const described = images.filter(({ description }) => description && description.value).length;
  const drawn = await page.locator('svg[role=img]').count();
  assert.equal(described, drawn, `${where}: every drawing has a description`);
  assert.equal(images.length, drawn + await page.locator('img').count(), where);
  for (const role of ['banner', 'navigation', 'main', 'contentinfo'])
    assert.equal(nodes.filter((node) => node.role && node.role.value === role).length, 1,
      `${where}: ${role}`);
}

/// On paper the page is light, whatever the screen is.
async function check_print(page, where) {
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  const { found, paper } = await page.evaluate(contrast_faults);
  assert.deepEqual(found, [], `${where}, printed`);
  assert.ok(paper > 0.8, `${where}: paper is light`);
  assert.ok(await page.locator('nav').isHidden(), `${where}: no links on paper`);
}

/// In a page that is open, `check(scheme)` under a light and a dark screen.
async function under_both(page, check) {
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    await check(colorScheme);
  }
}

/// A sweep's plot, which stands on the page as an image of its own.
async function check_plot(browser, problem) {
  const file = written(problem, join(out, `${problem.name}_sweep.svg`), '--format', 'svg',
    '--picture', 'sweep1');
  const { page, faults } = await reopen(browser, file, wide);
  await under_both(page, async (scheme) => {
    const { found, texts } = await page.evaluate(contrast_faults);
    assert.deepEqual([...found, ...faults], [], `${problem.name}_sweep.svg, ${scheme}`);
    assert.ok(texts > 10);
  });
}

/// The picture alone, which brings its own paper.
async function check_svg(browser, problem) {
  const file = written(problem, join(out, `${problem.name}.svg`), '--format', 'svg');
  const { page, faults } = await reopen(browser, file, wide);
  await under_both(page, async (scheme) => {
    const paper = await page.evaluate(() =>
      getComputedStyle(document.documentElement).backgroundColor);
    assert.equal(paper, scheme === 'dark' ? 'rgb(31, 33, 36)' : 'rgb(255, 255, 255)',
      `${problem.name}.svg, ${scheme}`);
  });
  assert.deepEqual(faults, [], `${problem.name}.svg`);
}

async function check_problem(browser, problem) {
  const { name } = problem;
  const html = written(problem, join(out, `${name}.html`));
  for (const [size, device] of [['wide', wide], ['phone', phone]]) {
    const { page, faults } = await reopen(browser, html, device);
    const layout = { viewport: device.viewport.width, least: 10.4 };
    await under_both(page, async (scheme) => {
      await photograph(page, join(out, `${name}_${size}_${scheme}.png`));
      await check_layout(page, `${name}_${size}_${scheme}`, layout);
    });
    await unfold(page);
    await under_both(page, (scheme) =>
      check_unfolded(page, problem, `${name}_${size}_${scheme}`, layout, scheme));
    if (device === wide) {
      await check_names(page, `${name}_${size}`);
      await check_print(page, `${name}_${size}`);
    }
    assert.deepEqual(faults, [], `${name}_${size}`);
  }
  if (problem.arguments.includes('--vary')) await check_plot(browser, problem);
  await check_svg(browser, problem);
  console.log(`${name}: ok`);
}

await check_all(problems, chosen, out, check_problem);
