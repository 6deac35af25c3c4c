// node viewer_browser_test.mjs FOLDER BROWSER: what a person does with FOLDER/fishhead.html, and whether the page follows.
import { readFileSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { chromium } from 'playwright-core';

const [folder, executablePath] = process.argv.slice(2).map(argument => resolve(argument));
const file = folder + '/fishhead.html', axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
let failed = 0;
function check(right, what) {
  console.log((right ? 'ok      ' : 'FAILED  ') + what);
  if (!right) ++failed;
}

const browser = await chromium.launch({ executablePath, args: ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'] });

async function open(width, height, colorScheme, hash = '') {
  const page = await browser.newPage({ viewport: { width, height }, colorScheme, reducedMotion: 'reduce' });
  page.on('pageerror', error => check(false, 'no error: ' + error.message));
  page.on('console', message => { if (message.type() === 'error') check(false, 'no console error: ' + message.text()); });
  page.on('request', request => { if (!request.url().startsWith('file://')) check(false, 'no network: ' + request.url()); });
  await page.goto('file://' + file + hash, { timeout: 120000 });
  return page;
}

const selectedLine = page => page.$eval('#program [aria-selected=true]', row => Number(row.dataset.line)).catch(() => 0);
const evaluate = (page, code) => page.evaluate(code);

async function plays(page) {
  await page.keyboard.press(' ');
  await page.waitForFunction('at.time > 0', null, { timeout: 60000 });
  await page.keyboard.press(' ');
  check(await page.textContent('#play') === 'Play', 'space plays and stops');
  await page.keyboard.press('Home');
  for (let k = 0; k < 3; ++k) await page.keyboard.press('ArrowRight');
  check(await evaluate(page, 'shownMove()') === 2, 'three arrows are three moves');
  await page.keyboard.press('ArrowLeft');
  check(await evaluate(page, 'shownMove()') === 1, 'left arrow goes back');
}

async function clicks(page) {
  await page.selectOption('#path', 'all');
  const i = await evaluate(page, 'moves.kind.findIndex((kind, i) => kind === 4 && moves.x1[i] - moves.x0[i] > 60)');
  const point = await evaluate(page, `(() => { const s = toScreen(pointAt(${i}, 0.4)), box = overlay.getBoundingClientRect(); return { x: s.x + box.left, y: s.y + box.top }; })()`);
  await page.mouse.click(point.x, point.y);
  const clicked = await evaluate(page, 'selected');
  check(clicked >= 0 && await selectedLine(page) === await evaluate(page, `moves.line[${clicked}]`), 'a click on a move selects its line');
  await page.$eval('#program', box => { box.scrollTop = 24 * 20; });
  await page.click('#program [data-line="30"]');
  check(await evaluate(page, 'selected === moveOfLine[30] && at.time === moves.t[selected + 1]'), 'a click on a line brings the cutter there');
  const before = await evaluate(page, 'view.k');
  await page.mouse.move(point.x, point.y);
  await page.mouse.wheel(0, -400);
  await page.waitForFunction(`view.k > ${before}`);
  await page.click('#fit');
  check(await evaluate(page, 'fitted'), 'wheel zooms, the button fits');
}

async function chooses(page) {
  for (const name of await evaluate(page, 'Object.keys(COLORINGS)')) {
    await page.selectOption('#color-by', name);
    await page.screenshot({ path: `${folder}/pictures/color-${name}.png` });
  }
  check(await evaluate(page, 'Object.keys(COLORINGS).length') === 5, 'five ways to colour');
  await page.selectOption('#unit', 'inch');
  check((await page.textContent('#tiles')).includes(' in') || (await page.textContent('#tiles')).includes('\u00a0in'), 'inches');
  await page.click('#measure');
  const box = await (await page.$('#overlay')).boundingBox();
  await page.mouse.click(box.x + 300, box.y + 200);
  await page.mouse.click(box.x + 400, box.y + 200);
  const inches = parseFloat(await page.textContent('#measured')), wanted = await evaluate(page, '100 / view.k / 25.4');
  check(Math.abs(inches - wanted) < 0.001, 'a distance is measured');
}

/** Going back gives the heights of a fresh page at that time, but for soft edges where a move was cut in pieces. */
async function scrubs(page) {
  const heights = 'Array.from(heightContext.getImageData(0, 0, width, height).data.filter((v, k) => k % 4 === 0))';
  await evaluate(page, 'show(total * 0.9); show(total * 0.4)');
  const back = await evaluate(page, heights), fresh = await open(1366, 768, 'light');
  await evaluate(fresh, 'show(total * 0.4)');
  const wanted = await evaluate(fresh, heights), off = back.filter((v, k) => Math.abs(v - wanted[k]) > 2).length;
  check(off <= back.length * 1e-4, `scrubbing back shows what a fresh replay shows (${off} of ${back.length} pixels differ)`);
  await fresh.close();
}

async function looks(width, height, scheme) {
  const page = await open(width, height, scheme, '#t=3000'), name = `${width} ${scheme}`;
  await page.screenshot({ path: `${folder}/pictures/${width}-${scheme}.png`, fullPage: width < 500 });
  check(await evaluate(page, 'document.documentElement.scrollWidth <= innerWidth'), name + ': nothing overflows sideways');
  if (width >= 1366) {
    const seen = await evaluate(page, `['overlay', 'play', 'verdict', 'reason', 'plot'].every(id => {
      const box = by(id).getBoundingClientRect(); return box.height > 0 && box.top >= 0 && box.bottom <= innerHeight; })`);
    check(seen, name + ': part, play and verdict without scrolling');
  }
  const small = await evaluate(page, `[...document.querySelectorAll('body *')].filter(e => e.textContent.trim() && parseFloat(getComputedStyle(e).fontSize) < 12).length`);
  check(small === 0, name + ': no text under 12 px');
  await page.evaluate(axe);
  const { violations } = await page.evaluate('axe.run()');
  const serious = violations.filter(one => ['serious', 'critical'].includes(one.impact));
  check(serious.length === 0, name + ': axe ' + serious.map(one => one.id + ' ' + one.nodes[0].html.slice(0, 120)).join('; '));
  await page.close();
}

const page = await open(1366, 768, 'light');
check(statSync(file).size < 10e6, `the page has ${statSync(file).size} bytes`);
console.log('opened in', await evaluate(page, 'Math.round(performance.timing.loadEventEnd - performance.timing.navigationStart)'), 'ms');
for (const part of [plays, clicks, chooses, scrubs]) await part(page);
for (const [width, height] of [[390, 844], [1366, 768], [1920, 1080]]) for (const scheme of ['light', 'dark']) await looks(width, height, scheme);
await browser.close();
console.log(failed === 0 ? 'the page in the browser: all well' : `the page in the browser: ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
