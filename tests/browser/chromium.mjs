// Headless Chromium for the tests of pages. playwright-core comes from LCPUSH_NODE_MODULES (a folder
// in which `npm install` was run) or from here; the browser from CHROMIUM or /usr/bin/chromium.
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const modules = process.env.LCPUSH_NODE_MODULES || dirname(fileURLToPath(import.meta.url));
const { chromium } = createRequire(join(resolve(modules), 'package.json'))('playwright-core');

const launch = () => chromium.launch({
  executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});

export const wide = { viewport: { width: 1280, height: 900 } };
export const phone = { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true,
  deviceScaleFactor: 2 };

/// A page whose complaints and requests are collected in `faults`.
export async function open(browser, file, options) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  page.setDefaultTimeout(10000);
  const faults = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(error.stack));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url()))
      faults.push(`request of ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href);
  return { page, faults, close: () => context.close() };
}

const kept = new Map();

/// As open(), in the page that the last call with these very options left: a new one starts a process,
/// which takes longer than most checks. For pages that keep nothing themselves; close nothing.
export async function reopen(browser, file, options) {
  const last = kept.get(options);
  if (!last || last.page.isClosed()) {
    kept.set(options, await open(browser, file, options));
    return kept.get(options);
  }
  last.faults.length = 0;
  await last.page.emulateMedia({ media: null, colorScheme: null });
  await last.page.goto(pathToFileURL(file).href);
  return last;
}

/// A picture of the page for a person's eyes, where LCPUSH_PHOTOGRAPHS is set: no check reads it, and
/// drawing them takes half of the time.
export async function photograph(page, path) {
  if (process.env.LCPUSH_PHOTOGRAPHS) await page.screenshot({ path, fullPage: true });
}

/// Closes what a failed check left open, and keeps in `out` how it looked.
async function put_away(browser, out, name) {
  for (const context of browser.contexts()) {
    for (const [k, page] of context.pages().entries())
      await page.screenshot({ path: join(out, `${name}_failed_${k}.png`) }).catch(() => {});
    await context.close();
  }
}

/// check(browser, problem) for each problem, or for those whose names are `chosen`. One that fails
/// is told, with a picture in `out`, and does not keep the others from being checked.
export async function check_all(problems, chosen, out, check) {
  const browser = await launch();
  for (const problem of problems) {
    if (chosen.length > 0 && !chosen.includes(problem.name)) continue;
    try {
      await check(browser, problem);
    } catch (failure) {
      process.exitCode = 1;
      console.error(`${problem.name}: ${failure.stack}`);
      await put_away(browser, out, problem.name);
    }
  }
  await browser.close();
}
