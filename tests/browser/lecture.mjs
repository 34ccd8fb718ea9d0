// The folder of docs/teach/make_lecture.py in headless Chromium: every live link opens at its pivot,
// rows are guessed before they are shown, slides and handout are read and printed.
//
//     node lecture.mjs TOOL OUTPUT_FOLDER
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { check_all, open, wide } from './chromium.mjs';
import { root } from './engine.mjs';

const [tool, folder] = process.argv.slice(2);
const out = resolve(folder);
execFileSync('python3', [join(root, 'docs/teach/make_lecture.py'), resolve(tool), out]);
const room = { viewport: { width: 1920, height: 1080 } };

/// Of the lecture and the exercises, each address once.
async function live(browser) {
  const links = new Set(['index', 'exercises', 'lecture_plan'].flatMap((name) =>
    [...readFileSync(join(out, `${name}.html`), 'utf8').matchAll(/class="live" href="(.*?)"/g)]
      .map(([, href]) => href.replaceAll('&amp;', '&'))));
  assert.ok(links.size >= 40);
  const { page, faults, close } = await open(browser, join(out, 'index.html'), wide);
  for (const link of links) {
    await page.goto('about:blank');
    await page.goto(`file://${out}/${link}`);
    const explorer = link.startsWith('lcp.html') ? page.frameLocator('#frame') : page;
    const step = Number(/step=(\d+)/.exec(link)[1]);
    await explorer.locator('#step', { hasText: new RegExp(`^(Pivot ${step}|After pivot ${step - 1}) of`) }).waitFor();
    assert.equal(await explorer.locator('#guess').isChecked(), link.endsWith('&guess'), link);
    if (link.endsWith('&guess'))
      await explorer.locator('#sentence', { hasText: /Which row leaves/ }).waitFor();
  }
  // The page on view follows another link, and says where it stands.
  await page.goto(`file://${out}/lcp.html`);
  await page.frameLocator('#frame').locator('#step').waitFor();
  await page.evaluate(() => { location.hash = '#problem=4 1; 2 3|-2 -7&step=1'; });
  await page.frameLocator('#frame').locator('#step', { hasText: 'Pivot 1 of 0..1' }).waitFor();
  assert.equal(await page.inputValue('#q'), '-2 -7');
  assert.equal(await page.inputValue('#examples'), '', 'no textbook problem');
  await page.waitForFunction(() => document.activeElement.id === 'frame');
  await page.keyboard.press('ArrowLeft');
  await page.frameLocator('#frame').locator('#step', { hasText: 'Pivot 0 of 0..1' }).waitFor();
  await page.keyboard.press('ArrowRight');
  await page.click('#raw-link');
  await page.waitForFunction(() => /^#lcp=.*&step=1$/.test(location.hash));
  assert.deepEqual(faults, []);
  await close();
}

/// By keys alone: wrong rows are told why, first guesses are counted, and nothing is shown before.
async function guess(browser) {
  const { page, faults, close } = await open(browser, join(out, 'coin.html'), room);
  const text = (id) => page.locator(`#${id}`).textContent();
  await page.keyboard.press('g');
  assert.equal(await page.locator('#tableau .leaving, #tableau .tied, #moves dd:nth-of-type(2)').count(), 0);
  assert.deepEqual(new Set(await page.locator('#tableau td.ratio').allTextContents()), new Set(['?']));
  await page.keyboard.press('5');
  assert.match(await text('tried'), /^Not w5: it is lifted to 0 at z0 = 1 already, while another row/);
  await page.keyboard.press('1');
  assert.equal(await text('tried'), 'Right.');
  assert.equal(await text('tally'), '0 of 1 right at the first guess');
  assert.equal(await page.locator('#tableau .leaving').count(), 1);
  await page.keyboard.press('ArrowRight');
  await page.locator('#tableau tr').nth(5).locator('button').focus();
  await page.keyboard.press('Enter');
  assert.equal(await text('tally'), '1 of 2 right at the first guess');
  await page.keyboard.press('Enter'); // the focus has stayed in its row
  assert.match(await text('step'), /Pivot 2 of/);
  await page.keyboard.press('l');
  assert.deepEqual(await page.locator('.tableau').evaluate((table) => [getComputedStyle(table).fontSize,
    table.clientWidth <= table.parentElement.clientWidth]), ['20px', true], 'large, and nothing cut');
  assert.deepEqual(faults, []);
  await close();
}

const pages_of = async (page) => (await page.pdf({ preferCSSPageSize: true })).toString('latin1')
  .match(/\/Type\s*\/Page\b/g).length;

async function printed(browser) {
  const deck = await open(browser, join(out, 'slides.html'), room);
  const { page } = deck;
  const shown = () => page.locator('.slide:not([hidden])').getAttribute('aria-label');
  const count = await page.locator('.slide').count();
  for (const [key, number] of [['ArrowRight', 2], [' ', 3], ['ArrowLeft', 2], ['End', count], ['Home', 1]]) {
    await page.keyboard.press(key);
    assert.equal(await shown(), `Slide ${number} of ${count}`);
  }
  const cut = await page.evaluate(() => [...document.querySelectorAll('.slide')].filter((slide) => {
    slide.hidden = false;
    return slide.scrollHeight > 720 || [slide, ...slide.querySelectorAll('pre')].some((x) => x.scrollWidth > x.clientWidth);
  }).map((slide) => slide.textContent.slice(0, 60)));
  assert.deepEqual(cut, []);
  assert.equal(await pages_of(page), count - await page.locator('.slide.ask').count());
  await page.goto(`file://${out}/handout.html`);
  assert.equal(await pages_of(page), 2);
  assert.deepEqual(deck.faults, []);
  await deck.close();
}

await check_all([{ name: 'live', run: live }, { name: 'guess', run: guess }, { name: 'printed', run: printed }], [],
  out, (browser, { run }) => run(browser));
