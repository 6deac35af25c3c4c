// node serve_browser_test.mjs FOLDER BROWSER ADDRESS COMMAND: what a person does with the page of `clearcut serve`, and whether it follows.
// FOLDER holds square.json, twice.toml, large.json, plate.dxf, tools.toml and five_pockets.toml; screenshots go to FOLDER/pictures.
import {execFileSync, spawnSync} from 'node:child_process';
import {copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {showsBeside} from './beside.mjs';
import {becomes, check, conclude, fits, isAccessible, launch, opensAnew, reportIn, saysOptions, textOf, watch} from './browser.mjs';
import {keepsItsPlace, walksByTab} from './keyboard.mjs';

/** @typedef {import('playwright-core').Page} Page */

const [folder, executablePath] = process.argv.slice(2, 4).map(argument => resolve(argument));
const address = process.argv[4], command = resolve(process.argv[5]);
const browser = await launch(executablePath, ['--enable-unsafe-swiftshader']);

/** @type {(width: number, height: number, colorScheme: 'light' | 'dark') => Promise<Page>} */
async function open(width, height, colorScheme) {
  // axe is put into the page, which its policy forbids to everybody else.
  const context = await browser.newContext({viewport: {width, height}, colorScheme, reducedMotion: 'reduce', bypassCSP: false});
  context.setDefaultTimeout(120000);  // a machine may be busy with other work
  const page = await context.newPage();
  watch(page, url => url.startsWith(address) || /^(data|blob):/.test(url));
  await opensAnew(page, address);
  return page;
}

/** @type {(name: string) => string} */
const picture = name => `${folder}/pictures/${name}.png`;

/** @type {(page: Page) => Promise<void>} */
async function plans(page) {
  await page.setInputFiles('#plan-files', `${folder}/square.json`);
  await page.waitForSelector('#plan-list li');
  await saysOptions(page, '--accept out-of-reach');
  check((await textOf(page, '#plan-command')).startsWith('clearcut plan square.json --tool endmill:6'), 'the command line is shown');
  const inMm = await textOf(page, '#plan-command');
  await page.selectOption('#lengths', 'inch');
  check(await page.inputValue('#tool-0-diameter') === '0.23622' && await textOf(page, '#plan-command') === inMm &&
      await textOf(page, '#tool-table [data-unit]') === 'in',
    'in inches fields say the same');
  await page.selectOption('#lengths', 'mm');
  check(await page.inputValue('#tool-0-diameter') === '6', 'and in mm again');
  await page.click('#plan-go');
  await page.waitForSelector('#plan-result:not([hidden])', {timeout: 120000});
  check(await textOf(page, '#plan-verdict') === 'CLEAN', 'a plan ends with its verdict');
  const frame = await reportIn(page, '#plan-report');
  check(await frame.isVisible('#play'), 'the report plays in the frame');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#plan-downloads a')]);
  await download.saveAs(`${folder}/square.ngc`);
  check(download.suggestedFilename() === 'square.ngc' && readFileSync(`${folder}/square.ngc`, 'utf8').includes('G1'),
    'the program is downloaded');
  const verified = spawnSync(command, ['verify', 'square.ngc', '--part', 'square.json', '--tool', 'endmill:6'], {cwd: folder});
  check(verified.status === 0, 'the command finds it CLEAN, too');
}

/** @type {(page: Page, selector: string, name: string) => Promise<string>} */
async function saved(page, selector, name) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
  await download.saveAs(`${folder}/drive/${name}`);
  return readFileSync(`${folder}/drive/${name}`, 'utf8');
}

/** Everything that a job says: what outlines are for, a library, material, controller; and what comes back. @type {(page: Page) => Promise<void>} */
async function drives(page) {
  rmSync(`${folder}/drive`, {recursive: true, force: true});
  mkdirSync(`${folder}/drive`);
  await opensAnew(page, address);
  await page.setInputFiles('#plan-files', [`${folder}/plate.dxf`, `${folder}/tools.toml`]);
  await page.waitForSelector('#outlines tbody tr', {timeout: 60000});
  const outlines = await page.locator('#outlines tbody tr').count();
  check(outlines === 10, 'the outlines of the drawing are listed');
  check((await textOf(page, '#found-title')).startsWith('What was found: 9 features'), 'and what was found');
  check(await page.locator('#drawing path').count() === outlines &&
      (await page.locator('#drawing text').allTextContents()).flatMap(text => text.split(', ')).length === outlines,
    'and are drawn with their numbers');
  await page.click('#show-drawing');
  await page.locator('#drawing path[data-index="2"]').dispatchEvent('click');
  check(await page.evaluate('document.activeElement.id') === 'menu-kind' && await page.locator('#drawing path.marked').count() === 1,
    'a click on one asks what it is for');
  await page.keyboard.press('Escape');
  await page.evaluate('document.getElementById("outlines-box").open = true');
  check(await page.inputValue('#plan-list li:last-child select') === 'tools', 'a tool library is known by what it says');
  await page.click('#show-drawing');
  await page.selectOption('[aria-label="What outline 3 is for"]', 'ignore');
  check(await page.getAttribute('#drawing path[data-index="2"]', 'class') === 'ignore', 'what it is for is seen in the drawing');
  await page.screenshot({path: picture('serve-drawing-1366')});
  await page.selectOption('[aria-label="What outline 4 is for"]', 'pocket');
  await page.fill('[aria-label="Depth of outline 4, mm"]', '4');
  await page.press('[aria-label="Depth of outline 4, mm"]', 'Tab');
  for (let k = 6; k <= outlines; ++k) await page.selectOption(`[aria-label="What outline ${k} is for"]`, 'ignore');
  await page.selectOption('#option-material', 'aluminium');
  await page.selectOption('#option-post', 'grbl');
  await saysOptions(page, '--accept out-of-reach --accept tool-by-hand --stepdown 2');
  const shown = await textOf(page, '#plan-command');
  check(
    ['--tools tools.toml', '--op ignore:3', '--op pocket_d4:4', '--material aluminium', '--post grbl'].every(word => shown.includes(word)),
    'the command line says it all: ' + shown);
  await page.click('#plan-go');
  await page.waitForFunction(() => {
    const status = document.getElementById('plan-status');
    return /^Done|error/.test(`${status?.textContent}${status?.className}`);
  }, null, {timeout: 240000});
  check((await textOf(page, '#plan-status')).startsWith('Done'), 'it is planned: ' + await textOf(page, '#plan-status'));
  const program = await saved(page, '#plan-downloads li:first-child a', 'plate.ngc'),
        sheet = await saved(page, 'a[download="plate-setup.html"]', 'sheet.html');
  check(sheet.includes('<html') && sheet.includes('plate'), 'the set-up sheet is downloaded');
  const sheetPage = await page.context().newPage();
  await sheetPage.goto(`file://${folder}/drive/sheet.html`);
  await isAccessible(sheetPage, 'the set-up sheet');
  await sheetPage.close();
  const job = await saved(page, '#plan-job', 'plate.toml');
  check(!(await textOf(page, '#plan-downloads')).includes('without'), 'the job holds everything');
  for (const file of ['plate.dxf', 'tools.toml']) copyFileSync(`${folder}/${file}`, `${folder}/drive/${file}`);
  try {
    execFileSync(command, ['plan', 'plate.toml', '-o', 'again.ngc', '--quiet'], {cwd: `${folder}/drive`, stdio: 'pipe'});
  } catch (error) {
    const ended = /** @type {{ status: number | null, stderr: Buffer }} */ (error);
    check(ended.status === 1, 'the job can be planned: ' + ended.stderr + job);
  }
  check(readFileSync(`${folder}/drive/again.ngc`, 'utf8') === program, 'the job planned by the command gives the same bytes');
  await page.screenshot({path: picture('serve-drive-1366'), fullPage: true});
}

/** A job that is milled from two sides: each set-up has its results. @type {(page: Page) => Promise<void>} */
async function plansSetups(page) {
  await opensAnew(page, address);
  await page.setInputFiles('#plan-files', [`${folder}/twice.toml`, `${folder}/square.json`]);
  await page.waitForFunction(() => document.getElementById('found')?.textContent?.includes('set-up 2: '), null, {timeout: 60000});
  await saysOptions(page, '--accept out-of-reach');
  await page.click('#plan-go');
  await page.waitForSelector('#plan-result:not([hidden])', {timeout: 120000});
  check((await textOf(page, '#plan-downloads')).includes('Program of set-up 2'), 'each set-up has its program');
  check(await page.locator('#plan-setup option').count() === 2, 'and its report');
  const secondIsShown = page.waitForResponse(/\/report-2$/);
  await page.selectOption('#plan-setup', {label: 'Set-up 2'});
  check((await secondIsShown).ok(), 'which is shown when it is chosen');
  await page.screenshot({path: picture('serve-setups-1366'), fullPage: true});
  await isAccessible(page, 'the page with two set-ups');
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
  await page.screenshot({path: picture('serve-readings-1366')});
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
  await opensAnew(page, address);
  await page.setInputFiles('#plan-files', `${folder}/square.json`);
  await saysOptions(page, '--accept out-of-reach');
  await page.click('#compare-go');
  await page.waitForSelector('#comparison tbody tr', {timeout: 240000});
  check(await page.locator('#comparison tr.fastest').count() === 1 && await page.locator('#comparison tbody tr').count() > 2,
    'strategies are compared');
  await page.click('#comparison button[aria-label="Take the strategy zigzag"]');
  check((await textOf(page, '#plan-command')).includes('--strategy zigzag'), 'and one is taken');
  await page.screenshot({path: picture('serve-compare-1366')});
  await isAccessible(page, 'the page with a comparison');
  await showsBeside(page, picture('serve-beside-1366'));
}

/** @type {(page: Page) => Promise<void>} */
async function cancels(page) {
  await page.setInputFiles('#plan-files', `${folder}/large.json`);
  await page.selectOption('#plan-list li:last-child select', 'part');
  await page.fill('#tool-0-diameter', '1');
  await page.press('#tool-0-diameter', 'Tab');
  await page.click('#plan-go');
  await page.waitForFunction(
    () => /Planning|Reading/.test(document.getElementById('plan-status')?.textContent ?? ''), null, {timeout: 60000});
  await page.click('#plan-cancel');
  check(await textOf(page, '#plan-status') === 'Cancelled.', 'a plan is cancelled');
  await page.click('#compare-go');
  await page.waitForFunction(
    () => /^Planning and certifying: [0-9]+ of [0-9]+ strategies/.test(document.getElementById('compare-status')?.textContent ?? ''), null,
    {timeout: 60000});
  await page.screenshot({path: picture('serve-comparing-1366')});
  await page.click('#compare-cancel');
  check(await textOf(page, '#compare-status') === 'Cancelled.' && await page.isEnabled('#compare-go'),
    'a comparison says how far it is, and is cancelled');
}

/** @type {(page: Page) => Promise<void>} */
async function checks(page) {
  await page.focus('#tab-plan');
  await page.keyboard.press('ArrowRight');
  check(await page.isVisible('#check') && !await page.isVisible('#plan'), 'tabs are changed by keys');
  writeFileSync(`${folder}/wrong.ngc`, 'G21 G90 G17 G54\nT1 M6\nS5000 M3\nG0 Z5\nG0 X-20 Y25\nG0 Z-1\nG1 X70 F900\nG0 Z5\nM30\n');
  await page.setInputFiles('#check-files', [`${folder}/wrong.ngc`, `${folder}/square.json`]);
  await page.fill('#check-diameter', '6');
  await page.click('#check-go');
  await page.waitForSelector('#check-result:not([hidden])', {timeout: 120000});
  check(await textOf(page, '#check-verdict') === 'FAULTY', 'a wrong program is FAULTY');
  check(await page.locator('#check-faults li').count() > 0, 'its faults are listed');
  check(await page.locator('#check-lines li.fault').count() > 0, 'their lines are marked');
  const frame = await reportIn(page, '#check-report');
  await page.click('#check-faults button:text-is("Line 6")');
  check(await becomes(frame, 'selected >= 0 && moves.line[selected] === 6'), 'a click on the line of a fault brings the report there');
  const play = await frame.locator('#play').boundingBox();
  check(play !== null && play.y > 0 && play.y + play.height <= 768, 'verdict, faults, part and play are seen without scrolling');
}

/** A condition that is met is none that is open. @type {(page: Page) => Promise<void>} */
async function checksWithConditions(page) {
  await opensAnew(page, address);
  await page.click('#tab-check');
  spawnSync(command, ['plan', 'square.json', '--tool', 'endmill:20', '-o', 'wide.ngc', '--quiet'], {cwd: folder});
  await page.setInputFiles('#check-files', [`${folder}/wide.ngc`, `${folder}/square.json`]);
  await page.fill('#check-diameter', '20');
  for (const [options, verdict, open] of [['', 'CONDITIONAL', 1], ['--accept out-of-reach', 'CLEAN', 0]]) {
    await page.evaluate('document.querySelectorAll("#check-form details").forEach(one => { one.open = true; })');
    await page.fill('#check-option-accept-1', String(options).replace('--accept ', ''));
    await page.press('#check-option-accept-1', 'Tab');
    await page.click('#check-go');
    await page.waitForFunction(wanted => document.getElementById('check-verdict')?.textContent === wanted, verdict, {timeout: 120000});
    check(await page.locator('#check-faults li.condition').count() === open, `${verdict}: ${open} open conditions are listed`);
  }
}

/** The same program without its part, in a block. @type {(page: Page) => Promise<void>} */
async function checksAlone(page) {
  await page.click('#check [aria-label="Remove square.json"]');
  check(await page.isVisible('#check-stock') && !await page.isVisible('#check-depth'), 'without a part the stock is asked for');
  await page.fill('#check-stock', '50,50,5');
  check((await textOf(page, '#check-command')).includes('--stock 50,50,5') && !(await textOf(page, '#check-command')).includes('--part'),
    'and the command line says so');
  await page.click('#check-go');
  await page.waitForFunction(
    () => document.getElementById('check-verdict')?.textContent?.endsWith('WITHOUT A PART'), null, {timeout: 120000});
  const frame = await reportIn(page, '#check-report');
  check((await textOf(frame, '#tiles')).includes('not asked'), 'a program is checked alone, and its report says what was not asked');
}

/** What is no program is told for what it is. @type {(page: Page) => Promise<void>} */
async function refusesNoPrograms(page) {
  await opensAnew(page, address);
  await page.click('#tab-check');
  for (const [name, text, words] of [['empty.ngc', '\n', 'the file is empty'],
         ['letter.txt', 'Dear Sir,\nplease mill this.\n', 'no line of it is a block of a program, such as G1 X10 F300'],
         ['drawing.nc', '  0\nSECTION\n', 'this is a DXF drawing, no program']]) {
    writeFileSync(`${folder}/${name}`, text);
    await page.setInputFiles('#check-files', `${folder}/${name}`);
    await page.fill('#check-diameter', '6');
    await page.click('#check-go');
    await page.waitForSelector('#check-status.error');
    check((await textOf(page, '#check-status')).startsWith(`${name}: ${words}; `) && await page.isHidden('#check-result'),
      `what is no program is told: ${await textOf(page, '#check-status')}`);
    if (name !== 'drawing.nc') await page.click(`[aria-label="Remove ${name}"]`);
  }
  await isAccessible(page, 'the page with what is no program');
  await page.setInputFiles('#check-files', [`${folder}/letter.txt`, `${folder}/square.json`]);
  await page.click('[aria-label="Remove drawing.nc"]');
  await keepsItsPlace(page, 'letter.txt', 'square.json');
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
  await page.screenshot({path: picture('serve-checking-1366')});
  await page.click('#check-cancel');
  check(await textOf(page, '#check-status') === 'Cancelled.' && await page.isHidden('#check-result') && await page.isEnabled('#check-go'),
    'a check is cancelled');
}

/** Elements that are written down, then a job of them: squares, tool impact, visit, points. @type {(page: Page) => Promise<void>} */
async function activates(page) {
  await opensAnew(page, address);
  if (await page.isHidden('#tab-elements')) await page.click('#research-go');
  await page.click('#tab-elements');
  await page.fill('[aria-label="Numbers of element 1"]', '0,0,24,18');
  await page.click('#elements-add');
  await page.selectOption('[aria-label="Kind of element 2"]', 'hole');
  await page.fill('[aria-label="Numbers of element 2"]', '-12, 9, 6');
  await page.fill('[aria-label="Tool of element 2"]', '2');
  await page.fill('[aria-label="Depth of element 2"]', '5');
  await page.selectOption('#elements-solver', 'published');
  await page.fill('#elements-generations', '30');
  const shown = await textOf(page, '#elements-command');
  check(['--pocket 0,0,24,18:T1:depth=3', '--hole=-12,9,6:T2:depth=5', '--tool endmill:4:T2', '--solver published --generations 30'].every(
          word => shown.includes(word)),
    'elements are options: ' + shown);
  await page.click('#elements-go');
  await page.waitForSelector('#elements-result:not([hidden])');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#elements-downloads a')]);
  check(download.suggestedFilename() === 'elements.ngc', 'their program is downloaded');
  await page.click('[aria-label="Remove element 2"]');
  check(!(await textOf(page, '#elements-command')).includes('--hole'), 'an element is removed');
  await page.setInputFiles('#elements-files', `${folder}/five_pockets.toml`);
  await page.waitForSelector('#elements-editor', {state: 'hidden'});
  check(await page.isHidden('#elements-editor') &&
      (await textOf(page, '#elements-command')).startsWith('clearcut elements five_pockets.toml --solver'),
    'a job stands in their place');
  await page.selectOption('#elements-solver', '');
  await page.click('#elements-go');
  await page.waitForFunction(
    () => document.querySelector('#elements-downloads a')?.getAttribute('download') === 'five_pockets.ngc', null, {timeout: 120000});
  const frame = await (await page.waitForSelector('#elements-report')).contentFrame();
  await frame?.waitForSelector('svg');
  check(/Activated, reduced, cut/.test(await frame?.content() ?? '') && (await frame?.locator('td:text-is("middle")').count() ?? 0) > 0,
    'squares and the table of elements are shown');
  await isAccessible(page, 'the page with elements');
  const report = await page.context().newPage();
  await report.goto(await page.getAttribute('#elements-report', 'src').then(src => new URL(src ?? '', address).href));
  await isAccessible(report, 'the report of elements');
  await report.close();
  check(await fits(page), 'nothing overflows with elements');
}

/** @type {(page: Page) => Promise<void>} */
async function refusesElements(page) {
  await page.click('[aria-label="Remove five_pockets.toml"]');
  await page.fill('[aria-label="Numbers of element 1"]', '0,0');
  await page.click('#elements-go');
  await page.waitForSelector('#elements-status.error');
  check(/pocket/.test(await textOf(page, '#elements-status')) && await page.isHidden('#elements-result'),
    'an element without its numbers is refused in one line: ' + await textOf(page, '#elements-status'));
}

/** A lattice, then points of a file whose best value falls while the page shows it, and a search that is cancelled. @type {(page: Page) => Promise<void>} */
async function solves(page) {
  await opensAnew(page, address);
  if (await page.isHidden('#tab-tour')) await page.click('#research-go');
  await page.click('#tab-tour');
  await page.waitForSelector('#tour-objective option', {state: 'attached'});
  await page.fill('#tour-lattice', '10 x 10');
  check((await textOf(page, '#tour-command')).startsWith('clearcut tour 10x10 --objective length --solver modern --time 10'),
    'a lattice is part of the command line');
  await page.click('#tour-go');
  await page.waitForSelector('#tour-figures dd');
  check(Number(await page.getAttribute('#tour-curve', 'data-samples')) > 0 &&
      (await page.getAttribute('#tour-curve', 'd'))?.endsWith('H1000') === true,
    'the graph of a lattice has its value');
  check(/99.*bound.*99.*proven optimal/.test(await textOf(page, '#tour-figures')), 'length, bound and gap are said');
  check(await page.evaluate(() => new Promise(done => {
    const img = document.querySelector('img');
    if (img?.complete) done(img.naturalWidth > 0);
    else img?.addEventListener('load', () => done(true));
  })),
    'the tour is drawn');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#tour-downloads a:text-is("Tour")')]);
  await download.saveAs(`${folder}/lattice-tour.json`);
  check(download.suggestedFilename() === '10x10-tour.json' &&
      JSON.parse(readFileSync(`${folder}/lattice-tour.json`, 'utf8')).tour.length === 100,
    'the tour is downloaded');
  const points = Array.from(
    {length: 2000}, (_, i) => `${i + 1} ${500 + 10 * Math.sqrt(i) * Math.cos(2.4 * i)} ${500 + 10 * Math.sqrt(i) * Math.sin(2.4 * i)}`);
  writeFileSync(`${folder}/spiral.tsp`,
    `NAME : spiral\nTYPE : TSP\nDIMENSION : 2000\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n${points.join('\n')}\nEOF\n`);
  await page.setInputFiles('#tour-files', `${folder}/spiral.tsp`);
  check(await page.isDisabled('#tour-lattice') && (await textOf(page, '#tour-command')).startsWith('clearcut tour spiral.tsp'),
    'a file goes before a lattice');
  await page.selectOption('#tour-solver', 'published');
  await page.fill('#tour-time', '8');
  await page.click('#tour-go');
  const grows = (/** @type {number} */ least) =>
    page.waitForFunction(most => Number(document.getElementById('tour-curve')?.getAttribute('data-samples')) > most &&
        document.getElementById('tour-result')?.hidden,
      least, {timeout: 60000});
  await grows(1);
  const before = Number(await page.getAttribute('#tour-curve', 'data-samples'));
  await grows(before);
  check(true, 'the graph grows while the search goes on');
  check((await textOf(page, '#tour-status')).startsWith('Searching: best '), 'the best value so far is said');
  await page.waitForSelector('#tour-result:not([hidden])');
  await page.waitForFunction(() => document.getElementById('tour-status')?.textContent?.startsWith('Done: '));
  check(Number(await page.getAttribute('#tour-curve', 'data-samples')) > before &&
      /dashed line is the bound/.test(await textOf(page, '#tour-said')),
    'at the end it holds every value and the bound');
  await isAccessible(page, 'the page with a tour');
  check(await fits(page), 'nothing overflows with a tour');
}

/** @type {(page: Page) => Promise<void>} */
async function cancelsTour(page) {
  await page.fill('#tour-time', '300');
  await page.click('#tour-go');
  await page.waitForFunction(() => document.getElementById('tour-status')?.textContent?.startsWith('Searching'));
  await page.click('#tour-cancel');
  check(await textOf(page, '#tour-status') === 'Cancelled.' && await page.isEnabled('#tour-go'), 'a search is cancelled');
}

const page = await open(1366, 768, 'light');
await isAccessible(page, 'the empty page');
check(/DXF, SVG, STEP, STEP-NC/.test(await page.innerText('#plan-kinds')), 'what is read is said before anything is dropped');
await plans(page);
await page.screenshot({path: picture('serve-1366')});
await isAccessible(page, 'the page with a plan');
await walksByTab(page, 'the page with a plan');
check(await fits(page), 'nothing overflows at 1366');
await drives(page);
await isAccessible(page, 'the page with outlines');
check(await fits(page), 'nothing overflows with outlines');
await plansSetups(page);
await asksForReadings(page);
await compares(page);
await cancels(page);
await checks(page);
await page.screenshot({path: picture('serve-check-1366')});
await isAccessible(page, 'the page with a check');
await walksByTab(page, 'the page with a check');
await checksAlone(page);
await page.screenshot({path: picture('serve-alone-1366'), fullPage: true});
await isAccessible(page, 'the page with a program alone');
await checksWithConditions(page);
await refusesNoPrograms(page);
await cancelsCheck(page);
await activates(page);
await page.screenshot({path: picture('serve-elements-1366'), fullPage: true});
await walksByTab(page, 'the page with elements');
await refusesElements(page);
await solves(page);
await page.screenshot({path: picture('serve-tour-1366'), fullPage: true});
await walksByTab(page, 'the page with a tour');
await cancelsTour(page);
const phone = await open(390, 844, 'dark');
await plans(phone);
check(await fits(phone), 'nothing overflows at 390');
await phone.screenshot({path: picture('serve-390-dark'), fullPage: true});
await isAccessible(phone, 'the dark page on a phone');
await compares(phone);
await phone.screenshot({path: picture('serve-beside-390-dark'), fullPage: true});
await activates(phone);
await phone.screenshot({path: picture('serve-elements-390-dark'), fullPage: true});
await solves(phone);
await phone.screenshot({path: picture('serve-tour-390-dark'), fullPage: true});
await browser.close();
conclude('the page of the server');
