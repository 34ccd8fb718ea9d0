// Opens the pages that `lcpush play` writes in headless Chromium: their solver answers as the tool
// does, bit for bit; what is dragged, typed, undone, linked and played shows; nothing complains or
// is fetched.
//
//     node playground.mjs TOOL OUTPUT_FOLDER [NAME..]
//
// Exit 0: all held. chromium.mjs says where the browser and its driver come from.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { check_all, open, phone, wide } from './chromium.mjs';
import { root } from './engine.mjs';
import { contrast_faults, covered_words, layout_faults } from './page_faults.mjs';
import { agrees, fixture, middle_of, native, native_answers, played, settled,
  state } from './play_page.mjs';
import { chosen, out, tool } from './tool.mjs';

async function random_scenes(browser) {
  const script = join(root, 'tests', 'support');
  const count = 1000;
  const texts = JSON.parse(execFileSync('python3', ['-c', `import json, sys
sys.path.insert(0, ${JSON.stringify(script)})
from random_scenes import random_scene
print(json.dumps([random_scene(seed) for seed in range(${count})]))`], { encoding: 'utf8',
    maxBuffer: 1 << 26 }));
  const { page, end } = await played(browser, fixture('pivot'));
  let solved = 0;
  const expected_of = native_answers(texts);
  for (const [seed, text] of texts.entries()) {
    const expected = expected_of(seed);
    const answer = await page.evaluate((scene) => {
      const reply = window.lcpush.app.solver.ask('solve', scene);
      return reply.slice(reply.indexOf('{', 1), reply.indexOf('\n, "sentence": ') + 1);
    }, text);
    assert.equal(answer, await expected, `random scene ${seed}`);
    if (JSON.parse(answer).status === 'solved') solved += 1;
  }
  assert.ok(solved > 0.9 * count, `only ${solved} are solved`);
  for (const name of ['pivot', 'coin', 'jam', 'rolling', 'lever'])
    for (const [command, question] of [['break', 'break'], ['move', 'move 0 101']]) {
      const answer = await page.evaluate(([asked, scene]) => {
        try {
          const reply = window.lcpush.app.solver.ask(asked, scene);
          return reply.slice(reply.indexOf('{', 1), reply.indexOf('\n, "sentence": ') + 1);
        } catch {
          return '';
        }
      }, [question, readFileSync(fixture(name), 'utf8')]);
      // Angles of turns come from the machine's arcus functions: their last digit may differ.
      const rounded = (text) => text.replace(/-?\d\.\d{15,}/g, (digits) => Number(digits).toPrecision(14));
      assert.equal(rounded(answer), rounded(native(command, fixture(name))), `${command} ${name}`);
    }
  await end();
}

async function dragging(browser) {
  const { page, end } = await played(browser, fixture('pivot'));
  await settled(page);
  const before = await state(page);
  const [x, y] = await middle_of(page, 'edge');
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 20; k += 1) await page.mouse.move(x + 5 * k, y);
  await page.waitForFunction(() => document.querySelectorAll('#picture .dot').length > 10);
  assert.match(await page.locator('#dot-key').textContent(), /With edge there/);
  await page.mouse.up();
  assert.equal(await page.locator('#picture .dot').count(), 0, 'dots of a held body alone');
  await settled(page);
  const after = await state(page);
  const place = (text) => {
    const [, x, unit] = /"edge"[\s\S]*?center = \[\s*"?(-?[\d.]+)( mm)?/.exec(text);
    return unit ? x / 1000 : Number(x);
  };
  assert.ok(place(after.text) > place(before.text) + 0.01, 'the pusher went right');
  assert.notEqual(after.answer, before.answer);
  await agrees(page);
  await page.click('#undo');
  assert.equal((await state(page)).text, before.text, 'undo');
  await page.click('#redo');
  assert.equal((await state(page)).text, after.text, 'redo');
  await page.keyboard.press('Control+z');
  assert.equal((await state(page)).answer, before.answer, 'undo by keys');
  await end();
}

async function touching(browser) {
  const { page, end } = await played(browser, fixture('pivot'), phone);
  await settled(page);
  const before = await state(page);
  const devtools = await page.context().newCDPSession(page);
  const swipe = async ([x, y], by) => {
    const touch = (type, ...touchPoints) =>
      devtools.send('Input.dispatchTouchEvent', { type, touchPoints });
    await touch('touchStart', { x, y });
    for (let k = 1; k <= 10; k += 1) await touch('touchMove', { x: x + by * k / 10, y });
    await touch('touchEnd');
  };
  await swipe(await middle_of(page, 'edge'), 40);
  await page.waitForFunction((text) => window.lcpush.app.state.text !== text, before.text);
  await settled(page);
  await agrees(page);
  assert.equal(await page.evaluate(() => window.scrollY), 0, 'the page stays');
  await page.tap('#undo');
  await page.waitForFunction((text) => window.lcpush.app.state.text === text, before.text);
  const seen_from = () => page.evaluate(() => window.lcpush.app.view.right.join());
  const front = await seen_from();
  const [left, top] = await page.evaluate(() => {
    const box = document.getElementById('picture').getBoundingClientRect();
    return [box.x, box.y];
  });
  await swipe([left + 12, top + 12], 60);
  assert.notEqual(await seen_from(), front, 'the view turns');
  assert.equal((await state(page)).text, before.text, 'and nothing else');
  await end();
}

async function keyboard(browser) {
  const { page, end } = await played(browser, fixture('pivot'));
  await settled(page);
  const before = await state(page);
  await page.locator('[data-body="edge"]').focus();
  for (let k = 0; k < 3; k += 1) await page.keyboard.press('ArrowRight');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.body), 'edge',
    'the focus stays on the body');
  await settled(page);
  await agrees(page);
  assert.notEqual((await state(page)).text, before.text);
  const slider = page.getByRole('slider', { name: 'edge: friction', exact: true });
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  assert.match((await state(page)).text, /friction = 0\.31/);
  await page.waitForSelector('.region:not([hidden]) i');
  assert.match(await slider.getAttribute('aria-description'), /pusher/);
  await page.getByRole('spinbutton', { name: 'object: mass, kg, as a number' }).fill('0.4');
  await page.keyboard.press('Enter');
  assert.match((await state(page)).text, /mass = 0\.4/);
  const mass = page.getByRole('spinbutton', { name: 'object: mass, kg, as a number' });
  await mass.fill('');
  await page.keyboard.press('Enter');
  assert.equal(await mass.inputValue(), '0.4', 'an empty field is as it was');
  assert.match(await page.locator('#sentence').textContent(), /Push with/);
  await page.evaluate((text) => window.lcpush.app.replace(text),
    readFileSync(fixture('rolling'), 'utf8'));
  await settled(page);
  const rim = (text) => [/cylinder_radius = ([\d.]+)/, /ends = \[\[(-?[\d.]+)/]
    .map((pattern) => Math.abs(pattern.exec(text)[1]));
  const [radius, place] = rim((await state(page)).text);
  await page.getByRole('spinbutton', { name: 'object: radius, mm, as a number' })
    .fill(String(2000 * radius));
  await page.keyboard.press('Enter');
  assert.equal((await state(page)).failure, '');
  assert.deepEqual(rim((await state(page)).text), [2 * radius, 2 * place],
    'the finger stays on the rim');
  await agrees(page);
  await end();
}

async function errors(browser) {
  const { page, end } = await played(browser, fixture('pivot'));
  await settled(page);
  const before = await state(page);
  const type = async (text) => {
    await page.evaluate((scene) => {
      const box = document.getElementById('text');
      box.closest('details').open = true;
      box.value = scene;
      box.dispatchEvent(new Event('change'));
    }, text);
  };
  await type(before.text.replace('mass = 0.2', 'mass = -0.2'));
  assert.match((await state(page)).failure, /scene:\d+: .*mass/);
  assert.equal(await page.locator('#sentence.stale').count(), 1, 'the sentence is another scene\'s');
  assert.ok(await page.locator('#save-answer').isDisabled(), 'and so is the answer');
  assert.ok(await page.evaluate(() => window.lcpush.app.pixels_per_meter() > 0), 'can be dragged');
  await page.click('[data-view="isometric"]');
  assert.ok(await page.locator('#picture .face').count() > 1, 'can be looked at from elsewhere');
  await type(before.text.replace('mass = 0.2', 'mass = 0.3'));
  assert.equal((await state(page)).failure, '');
  await agrees(page);
  await type(readFileSync(fixture('jam'), 'utf8'));
  await settled(page);
  assert.match((await state(page)).sentence, /No answer/);
  assert.match(await page.locator('#facts').textContent(), /Why it jams/);
  await page.click('#undo');
  await page.click('#undo');
  await page.click('#undo');
  assert.equal((await state(page)).answer, before.answer);
  await end();
}

async function links(browser) {
  const { page, end } = await played(browser, fixture('coin'));
  await page.click('#link');
  await page.waitForFunction(() => /link/.test(document.getElementById('done').textContent));
  const hash = await page.evaluate(() => location.hash);
  const { text } = await state(page);
  await end();
  const other = await played(browser, fixture('pivot'), wide, hash);
  assert.equal((await state(other.page)).text, text);
  await other.end();
  // A link that was cut, and one whose scene is none.
  for (const [bad, words] of [[hash.slice(0, -9), /cut short/], ['#text=hello', /scene:1: /]]) {
    const cut = await played(browser, fixture('pivot'), wide, bad);
    const seen = await state(cut.page);
    assert.match(seen.failure, words);
    assert.match(seen.sentence, /pivots/, 'the page shows its own scene');
    await cut.end();
  }
}

async function playing(browser) {
  const { page, end } = await played(browser, fixture('pivot'));
  await page.click('#play');
  await page.waitForFunction(() => Number(document.getElementById('time').value) > 50);
  await page.click('#play');
  assert.ok(await page.locator('#picture .force').count() >= 3, 'forces of the moment');
  const at = await page.inputValue('#time');
  await page.waitForTimeout(300);
  assert.equal(await page.inputValue('#time'), at, 'paused');
  assert.match(await page.locator('#motion').textContent(), /pivots/);
  const frame = page.frameLocator('#frame');
  const close = async () => {
    await page.click('#close');
    await frame.locator('h1').waitFor({ state: 'detached' }); // the next page is not this one
  };
  await page.click('#pivots');
  assert.match(await frame.locator('h1').textContent(), /, after 0\.\d+ s/, 'of this moment');
  await close();
  await page.click('#reset');
  assert.equal(await page.inputValue('#time'), '0');
  await page.click('#pivots');
  assert.doesNotMatch(await frame.locator('h1').textContent(), /after/);
  await frame.locator('#forward').click();
  assert.match(await frame.locator('#step').textContent(), /Pivot 1 of/);
  // The explorer takes its palette and what it draws with from this page.
  assert.match(await frame.locator('html').evaluate((root_there) =>
    getComputedStyle(root_there).getPropertyValue('--paper')), /#/);
  assert.ok(await frame.locator('#scene .drawing .head').count() > 0, 'arrows');
  await close();
  // A motion that ends soon, asked for at a moment that it does not reach.
  await page.evaluate((text) => window.lcpush.app.replace(text),
    readFileSync(fixture('lever'), 'utf8'));
  await page.locator('#time').fill('200');
  await page.waitForFunction(() => /0\.\d+ s/.test(document.getElementById('clock').textContent));
  await end();
}

/// A page of its own: textbook problems, other languages' brackets; lecture.mjs follows its links.
async function typed(browser) {
  const file = join(out, 'lcp.html');
  execFileSync(tool, ['play', '--lcp', '-o', file]);
  const { page, faults, close } = await open(browser, file, { ...phone, colorScheme: 'dark' });
  const frame = page.frameLocator('#frame');
  await frame.locator('#cones svg').waitFor(); // the first example's
  assert.equal(await page.locator('#examples option:not([hidden])').count(), 12);
  await page.selectOption('#examples', 'infeasible_psd');
  await frame.locator('#summary', { hasText: 'ray' }).waitFor();
  // As other languages write it; a number beyond decimals leaves its cone in the picture.
  for (const [M, q] of [['[[1e400, 0],\n [0, 1],]', '[-1; 2];'], ['[2 1; 1 2]', '-5\t-6'],
    ['np.array([[2, 1], [1, 2]], dtype=float)', '-5, -6'], ['2,5;1\n1;2', '-5;-6'], ['[2,1;1,2]', '-5\n-6']]) {
    await page.fill('#M', M);
    await page.fill('#q', q);
    await page.click('#raw-pivots');
    await page.waitForFunction(() => !document.getElementById('raw-said').textContent);
    await frame.locator('#cones svg').waitFor();
  }
  await page.fill('#q', '1 2 3');
  await page.click('#raw-pivots');
  await page.waitForFunction(() => /square/.test(document.getElementById('raw-said').textContent));
  assert.deepEqual(faults, [], 'complaints and requests');
  await close();
}

/// What the tool says that is odd, and one grip for both jaws.
async function telling(browser) {
  const { page, end } = await played(browser, fixture('pivot'));
  assert.equal(await page.locator('#checks li').count(), 0);
  await page.getByLabel('jaw: grip, N, as a number').fill('7');
  await page.keyboard.press('Tab');
  const { text, answer } = await state(page);
  assert.equal(text.match(/grip_force = 7\b/g).length, 2);
  assert.equal(JSON.parse(answer).hand, 'parallel');
  await page.evaluate((scene) => window.lcpush.app.replace(scene), text.replace(/mass = [0-9.]+/,
    'mass = 120'));
  assert.match(await page.locator('#checks li').first().textContent(), /^Check line \d+: /);
  await end();
}

/// Nothing runs over the edge of a screen, light and dark; every shipped scene is drawn.
async function looks(browser) {
  const listed = execFileSync(tool, ['example'], { encoding: 'utf8' }).matchAll(/^ {2}(\S+)/gm);
  const names = [...listed].map((line) => line[1]);
  assert.ok(names.length > 15);
  for (const [size, scheme] of [[wide, 'light'], [phone, 'dark'],
    [{ ...phone, viewport: { width: 390, height: 844 } }, 'light']]) {
    const { page, end } = await played(browser, fixture('pivot'), { ...size, colorScheme: scheme });
    await page.evaluate(() => document.querySelectorAll('details')
      .forEach((part) => part.setAttribute('open', '')));
    for (const name of size === wide ? names : ['pivot', 'jam', 'rolling']) {
      await page.evaluate((text) => window.lcpush.app.replace(text),
        readFileSync(fixture(name), 'utf8'));
      const seen = await page.evaluate(() => ({
        wide: document.documentElement.scrollWidth - window.innerWidth,
        bodies: document.querySelectorAll('#picture [data-body] polygon').length,
        broken: [...document.querySelectorAll('#picture [points]')].filter((shape) =>
          /NaN|Infinity/.test(shape.getAttribute('points'))).length,
        failure: document.getElementById('failure').textContent,
      }));
      assert.ok(seen.wide <= 0, `${name}: ${seen.wide} px too wide`);
      assert.ok(seen.bodies > 0 && seen.broken === 0, `${name}: ${JSON.stringify(seen)}`);
      const layout = { viewport: size.viewport.width, least: 10.4 };
      const { found, texts, lines } = await page.evaluate(contrast_faults);
      assert.ok(texts > 40 && lines > 2, `${name}: ${texts} texts, ${lines} lines`);
      assert.deepEqual([...await page.evaluate(layout_faults, layout),
        ...await page.evaluate(covered_words), ...found], [], `${name}, ${scheme}`);
    }
    const small = await page.evaluate(() => [...document.querySelectorAll('button, select, input')]
      .filter((part) => part.getClientRects().length > 0
        && part.getBoundingClientRect().height < 40).map((part) => part.id || part.type));
    if (size.hasTouch) assert.deepEqual(small, [], 'large enough to touch');
    await end();
  }
}

const tests = { random_scenes, dragging, touching, keyboard, errors, links, playing, typed, telling, looks };
await check_all(Object.keys(tests).map((name) => ({ name })), chosen, out,
  async (browser, { name }) => {
    await tests[name](browser);
    console.log(`${name}: all held`);
  });
