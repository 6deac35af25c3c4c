// node web_browser_test.mjs FOLDER BROWSER SITE EXAMPLES [COMMAND]: serves the folder SITE as any static host would, on this machine alone, and does
// with the page what a person does: plan, cancel, check, elements, tours, download, reload without a network. Screenshots go to FOLDER/pictures. COMMAND, where
// it is named, has to check the downloaded program as the page did.
import {spawnSync} from 'node:child_process';
import {readFileSync, writeFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {showsBeside} from './beside.mjs';
import {becomes, check, conclude, fits, isAccessible, launch, opensAnew, reportIn, saysOptions, textOf, watch} from './browser.mjs';
import {hostOf} from './static_host.mjs';

/** @typedef {import('playwright-core').Page} Page */

const [folder, executablePath, site, examples, command] = process.argv.slice(2).map(argument => resolve(argument));
const {host, address, asked} = await hostOf(site);
const browser = await launch(executablePath, ['--enable-unsafe-swiftshader']);

/** @type {(width: number, height: number, colorScheme: 'light' | 'dark') => Promise<Page>} */
async function open(width, height, colorScheme) {
  const context = await browser.newContext({viewport: {width, height}, colorScheme, reducedMotion: 'reduce'});
  const page = await context.newPage();
  watch(page, url => url.startsWith(address) || /^(data|blob):/.test(url));
  await opensAnew(page, address);
  return page;
}

/** @type {(name: string) => string} */
const picture = name => `${folder}/pictures/${name}.png`;
/** @type {(page: Page) => Promise<string[]>} */
const partOf = page => page.selectOption('#plan-list li:last-child select', 'part');

/** @type {(page: Page, verdict: string) => Promise<void>} */
async function planned(page, verdict) {
  await page.click('#plan-go');
  await page.waitForSelector('#plan-result:not([hidden])', {timeout: 240000});
  check(await textOf(page, '#plan-verdict') === verdict, `a plan ends with its verdict, ${verdict}`);
}

/** @type {(page: Page) => Promise<void>} */
async function plansBracket(page) {
  await page.setInputFiles('#plan-files', join(examples, 'bracket.dxf'));
  await saysOptions(page, '--stepdown 2.5');
  check((await textOf(page, '#plan-command')).startsWith('clearcut plan bracket.dxf --tool endmill:6'), 'the command line is shown');
  await planned(page, 'CLEAN');
  const frame = await reportIn(page, '#plan-report');
  check(await frame.isVisible('#play'), 'the report plays in the frame');
  for (const [title, ending] of [['Program', 'ngc'], ['Certificate', 'json'], ['Report', 'html']]) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`#plan-downloads a:text-is("${title}")`)]);
    await download.saveAs(`${folder}/web-bracket.${ending}`);
    check(download.suggestedFilename() === `bracket.${ending}`, `${title.toLowerCase()} is downloaded`);
  }
  const golden = readFileSync(join(examples, '../tests/golden/examples/bracket/linuxcnc-mm.ngc'), 'utf8');
  check(readFileSync(`${folder}/web-bracket.ngc`, 'utf8') === golden, 'the program is the golden one, byte for byte');
  if (!command) return;
  const end = spawnSync(command,
    ['verify', `${folder}/web-bracket.ngc`, '--part', join(examples, 'bracket.dxf'), '--tool', 'endmill:6', '--stepdown', '2.5'],
    {encoding: 'utf8'});
  check(end.status === 0, 'the command finds the downloaded program CLEAN, too');
}

/** A plate of which nothing says what its edge is: both readings are drawn, a click answers, and it can be asked again. @type {(page: Page) => Promise<void>} */
async function asksForReadings(page) {
  const square = (/** @type {number} */ a, /** @type {number} */ b) =>
    `0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n${a}\n20\n${a}\n10\n${b}\n20\n${a}\n10\n${b}\n20\n${b}\n10\n${a}\n20\n${b}\n`;
  writeFileSync(`${folder}/unsaid.dxf`,
    `0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n${square(0, 60)}${square(20, 40)}0\nENDSEC\n0\nEOF\n`);
  await opensAnew(page, address);
  await page.setInputFiles('#plan-files', `${folder}/unsaid.dxf`);
  await page.waitForSelector('#readings-list button');
  check((await page.locator('#readings-list strong').allTextContents()).join('; ') ===
      'The edge of the part: cut out along it; A pocket: what lies in it stays',
    'a drawing that may be read in two ways is asked about');
  check(await page.locator('#readings-list .drawing .profile').count() === 1 &&
      await page.locator('#readings-list .drawing .island').count() === 1 && await page.locator('#drawing .unsaid').count() === 2,
    'both readings are drawn');
  await isAccessible(page, 'the page with two readings');
  await page.screenshot({path: picture('web-readings-1366')});
  await page.click('#readings-list button');
  await page.waitForSelector('#drawing .profile');
  check(await page.isHidden('#readings') && (await textOf(page, '#plan-command')).includes('--op profile:outer') &&
      /field Depth/.test(await textOf(page, '#plan-status')),
    'a click says which is meant');
  await page.fill('#option-depth', '3');
  await page.press('#option-depth', 'Tab');
  await page.waitForFunction(() => document.getElementById('plan-status')?.textContent === 'unsaid.dxf is ready to be planned.');
  await page.click('#given-again');
  await page.waitForSelector('#readings-list button');
  check(!(await textOf(page, '#plan-command')).includes('--op'), 'and it can be asked again');
  await page.fill('#option-depth', '');
}

/** @type {(page: Page) => Promise<void>} */
async function compares(page) {
  writeFileSync(`${folder}/small.json`,
    JSON.stringify({name: 'small', units: 'mm', outer: [[0, 0, 0], [40, 0, 0], [40, 30, 0], [0, 30, 0]], islands: [], top: 0, depth: 2}));
  await page.setInputFiles('#plan-files', `${folder}/small.json`);
  await partOf(page);
  await saysOptions(page, '--accept out-of-reach');
  await page.click('#compare-go');
  await page.waitForSelector('#comparison tbody tr', {timeout: 300000});
  const rows = await page.locator('#comparison tbody tr').count();
  check(rows > 10 && await page.locator('#comparison tr.fastest').count() === 1, `${rows} strategies are compared`);
  await showsBeside(page, picture('web-beside-1366'));
  if (!command) return;
  const said = JSON.parse(spawnSync(command,
    ['compare', `${folder}/small.json`, '--tool', 'endmill:6', '--accept', 'out-of-reach', '--json'],
    {encoding: 'utf8'}).stdout);
  const fastest = said.strategies.find((/** @type {{ fastest?: boolean }} */ one) => one.fastest).strategy;
  check((await textOf(page, '#comparison tr.fastest td')).startsWith(fastest), `the fastest is that of the command, ${fastest}`);
}

/** @type {(page: Page) => Promise<void>} */
async function cancels(page) {
  const part = {
    name: 'large',
    units: 'mm',
    outer: [[0, 0, 0.1], [400, 0, 0.2], [400, 300, 0.1], [0, 300, 0.3]],
    islands: [[[200, 150, 1], [150, 150, 1]]],
    top: 0,
    depth: 5
  };
  writeFileSync(`${folder}/large.json`, JSON.stringify(part));
  await page.setInputFiles('#plan-files', `${folder}/large.json`);
  await partOf(page);
  await page.fill('#tool-0-diameter', '1');
  await page.press('#tool-0-diameter', 'Tab');
  await saysOptions(page, '');
  await page.click('#plan-go');
  await page.waitForFunction(
    () => /Planning|Reading/.test(document.getElementById('plan-status')?.textContent ?? ''), null, {timeout: 60000});
  // Those of the readings and plans before it end as it begins.
  for (let i = 0; i < 100 && page.workers().length > 1; ++i) await page.waitForTimeout(100);
  check(page.workers().length === 1, 'a plan runs in a worker');
  await page.click('#plan-cancel');
  check(await textOf(page, '#plan-status') === 'Cancelled.', 'a plan is cancelled');
  await page.click('#compare-go');
  await page.waitForFunction(
    () => /^Planning and certifying: [0-9]+ of [0-9]+ strategies/.test(document.getElementById('compare-status')?.textContent ?? ''), null,
    {timeout: 60000});
  await page.screenshot({path: picture('web-comparing-1366')});
  await page.click('#compare-cancel');
  check(await textOf(page, '#compare-status') === 'Cancelled.' && await page.isEnabled('#compare-go'),
    'a comparison says how far it is, and is cancelled');
  for (let i = 0; i < 100 && page.workers().length > 0; ++i) await page.waitForTimeout(100);
  check(page.workers().length === 0, 'its worker is gone');
}

/** @type {(page: Page) => Promise<void>} */
async function refuses(page) {
  await page.setInputFiles('#plan-files', join(examples, 'bracket.step'));
  await partOf(page);
  await page.fill('#tool-0-diameter', '6');
  await page.press('#tool-0-diameter', 'Tab');
  await page.click('#plan-go');
  await page.waitForFunction(() => document.getElementById('plan-status')?.classList.contains('error'), null, {timeout: 60000});
  check(/bracket\.step.*a STEP solid, which this page cannot read/.test(await textOf(page, '#plan-status')),
    'a STEP solid is refused in plain words');
  await page.setInputFiles('#plan-files', join(examples, 'bracket.dxf'));
  await partOf(page);
  await saysOptions(page, '--no-such-option');
  await page.click('#plan-go');
  await page.waitForFunction(
    () => /no-such-option/.test(document.getElementById('plan-status')?.textContent ?? ''), null, {timeout: 60000});
  check(true, 'an unknown option is refused in the words of the command');
  await saysOptions(page, '');
}

/** @type {(page: Page) => Promise<void>} */
async function checks(page) {
  await page.click('#tab-check');
  writeFileSync(`${folder}/wrong.ngc`, 'G21 G90 G17 G54\nT1 M6\nS5000 M3\nG0 Z5\nG0 X-20 Y25\nG0 Z-1\nG1 X70 F900\nG0 Z5\nM30\n');
  await page.setInputFiles('#check-files', [`${folder}/wrong.ngc`, join(examples, 'bracket.dxf')]);
  await page.fill('#check-diameter', '6');
  await page.click('#check-go');
  await page.waitForSelector('#check-result:not([hidden])', {timeout: 120000});
  check(await textOf(page, '#check-verdict') === 'FAULTY', 'a wrong program is FAULTY');
  check(await page.locator('#check-faults li').count() > 0, 'its faults are listed');
  check(await page.locator('#check-lines li.fault').count() > 0, 'their lines are marked');
  const faulty = await reportIn(page, '#check-report');
  await page.click('#check-faults button:text-is("Line 6")');
  check(await becomes(faulty, 'selected >= 0 && moves.line[selected] === 6'), 'a click on the line of a fault brings the report there');
  check(/Nothing is uploaded/.test(await textOf(page, '#promise')), 'the page says that nothing is uploaded');
  await page.click('#check [aria-label="Remove bracket.dxf"]');
  await page.fill('#check-stock', '0:70,0:50,-5:0');
  await page.click('#check-go');
  await page.waitForFunction(
    () => document.getElementById('check-verdict')?.textContent?.endsWith('WITHOUT A PART'), null, {timeout: 120000});
  const frame = await reportIn(page, '#check-report');
  check((await textOf(frame, '#tiles')).includes('not asked'), 'a program is checked alone, and its report says what was not asked');
}

/** A long program: how far its check is, and its end before it is done. @type {(page: Page) => Promise<void>} */
async function cancelsCheck(page) {
  const moves = Array.from({length: 60000}, (_, i) => `G1 X${(0.004 * i).toFixed(3)} Y${((i % 2 ? -1 : 1) * 0.0012 * i).toFixed(3)} F900`);
  writeFileSync(
    `${folder}/long.ngc`, `G21 G90 G17 G54\nT1 M6\nS5000 M3\nG0 Z5\nG0 X0 Y0\nG1 Z-1 F300\n${moves.join('\n')}\nG0 Z5\nM5\nM2\n`);
  await opensAnew(page, address);
  await page.click('#tab-check');
  await page.setInputFiles('#check-files', `${folder}/long.ngc`);
  await page.fill('#check-diameter', '6');
  await page.fill('#check-stock', '-10:260,-90:90,-5:0');
  await page.click('#check-go');
  await page.waitForFunction(
    () => /^Checking the program … /.test(document.getElementById('check-status')?.textContent ?? ''), null, {timeout: 60000});
  check(await page.isVisible('#check-progress'), 'a check says how far it is');
  await page.screenshot({path: picture('web-checking-1366')});
  await page.click('#check-cancel');
  check(await textOf(page, '#check-status') === 'Cancelled.' && await page.isHidden('#check-result') && await page.isEnabled('#check-go'),
    'a check is cancelled');
}

/** @type {(page: Page) => Promise<void>} */
async function activates(page) {
  if (await page.isHidden('#tab-elements')) await page.click('#research-go');
  await page.click('#tab-elements');
  await page.setInputFiles('#elements-files', join(examples, 'five_pockets.toml'));
  await page.click('#elements-go');
  await page.waitForSelector('#elements-result:not([hidden])', {timeout: 240000});
  const frame = await (await page.waitForSelector('#elements-report')).contentFrame();
  await frame?.waitForSelector('svg');
  check(/Activated, reduced, cut/.test(await frame?.content() ?? ''), 'elements show their squares');
  await page.waitForFunction(() => /verdict: /.test(document.getElementById('elements-text')?.textContent ?? ''));
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#elements-downloads a')]);
  check(download.suggestedFilename() === 'five_pockets.ngc', 'their program is downloaded');
}

/** @type {(page: Page) => Promise<void>} */
async function solves(page) {
  if (await page.isHidden('#tab-tour')) await page.click('#research-go');
  await page.click('#tab-tour');
  await page.fill('#tour-lattice', '40x40');
  await page.selectOption('#tour-shape', '--closed');
  await page.click('#tour-go');
  await page.waitForSelector('#tour-figures dd', {timeout: 60000});
  check(/bound.*lattice steps/.test(await textOf(page, '#tour-figures')), 'the bound of a tour is said');
  await isAccessible(page, 'the page with a tour');
  const points = Array.from(
    {length: 2000}, (_, i) => `${i + 1} ${500 + 10 * Math.sqrt(i) * Math.cos(2.4 * i)} ${500 + 10 * Math.sqrt(i) * Math.sin(2.4 * i)}`);
  writeFileSync(`${folder}/spiral.tsp`,
    `NAME : spiral\nTYPE : TSP\nDIMENSION : 2000\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n${points.join('\n')}\nEOF\n`);
  await page.setInputFiles('#tour-files', `${folder}/spiral.tsp`);
  await page.selectOption('#tour-solver', 'published');
  await page.fill('#tour-time', '300');
  await page.click('#tour-go');
  await page.waitForFunction(() => Number(document.getElementById('tour-curve')?.getAttribute('data-samples')) > 1 &&
      document.getElementById('tour-status')?.textContent?.startsWith('Searching'),
    null, {timeout: 60000});
  check(true, 'the graph of a tour grows while the search goes on');
  await page.click('#tour-cancel');
  check(await textOf(page, '#tour-status') === 'Cancelled.', 'a search is cancelled');
}

/** @type {(page: Page) => Promise<void>} */
async function worksOffline(page) {
  await page.evaluate('navigator.serviceWorker.ready');
  await page.reload();
  await page.waitForFunction('navigator.serviceWorker.controller !== null', null, {timeout: 30000});
  host.closeAllConnections();
  await new Promise(closed => {
    host.close(closed);
  });
  await page.reload();
  await page.waitForFunction(() => document.querySelectorAll('#option-strategy option').length > 3, null, {timeout: 30000});
  await page.setInputFiles('#plan-files', join(examples, 'bracket.dxf'));
  await saysOptions(page, '--stepdown 2.5');
  await planned(page, 'CLEAN');
}

const page = await open(1366, 768, 'light');
await isAccessible(page, 'the empty page');
/** @type {{ name: string, display: string, icons: object[] }} */
const manifest =
  await page.evaluate(async () => (await fetch(document.querySelector('link[rel=manifest]')?.getAttribute('href') ?? '')).json());
check(manifest.name === 'Clearcut' && manifest.display === 'standalone' && manifest.icons.length > 0, 'it can be installed as an app');
check(/DXF, SVG, STEP-NC.*STEP solids are not read in the browser/.test(await page.innerText('#plan-kinds')),
  'what is not read is said before anything is dropped');
await plansBracket(page);
await page.screenshot({path: picture('web-1366')});
await isAccessible(page, 'the page with a plan');
check(await fits(page), 'nothing overflows at 1366');
await asksForReadings(page);
await opensAnew(page, address);
await compares(page);
await cancels(page);
await refuses(page);
await checks(page);
await page.screenshot({path: picture('web-check-1366')});
await cancelsCheck(page);
await activates(page);
await solves(page);
const phone = await open(390, 844, 'dark');
await phone.setInputFiles('#plan-files', join(examples, 'bracket.dxf'));
await planned(phone, 'CLEAN');
check(await fits(phone), 'nothing overflows at 390');
await phone.screenshot({path: picture('web-390-dark'), fullPage: true});
await phone.context().close();
await worksOffline(page);
check(asked.every(one => one.startsWith('GET ')), 'nothing was sent to the host');
await browser.close();
conclude('the page without a server');
