// node examples_test.mjs HOME FOLDER BROWSER COMMAND EXAMPLES [PLACE]: every example in a home of the page: `report`; `server` at the address PLACE;
// `web`, the folder PLACE as a static host serves it. Planned there, its program has to be the command's, byte for byte; downloaded, the
// command has to find it CLEAN; and its report, scrubbed both ways, has to look as a fresh replay does. CLEARCUT_EXAMPLES=WORD: those whose name holds it.
import {mkdirSync, readFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {check, conclude, launch, opensAnew, reportIn, saysOptions, textOf, watch} from './browser.mjs';
import {EXAMPLES, filesOf, optionsOf, programsOf} from './example_parts.mjs';
import {copyExamples, jobPlannedByCommand, plannedByCommand, scrubsBothWays, verifiedByCommand} from './examples.mjs';
import {hostOf} from './static_host.mjs';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('./example_parts.mjs').Example} Example */

const [home, folderName, browserName, commandName, examplesName, place = ''] = process.argv.slice(2);
const command = resolve(commandName), folder = `${resolve(folderName)}/examples-${home}`;
const browser = await launch(resolve(browserName), ['--enable-unsafe-swiftshader']);
const context = await browser.newContext({viewport: {width: 1000, height: 600}, reducedMotion: 'reduce'});
context.setDefaultTimeout(240000);  // a machine may be busy with other work
const hosted = home === 'web' ? await hostOf(resolve(place)) : null, address = hosted?.address ?? place;

/** @type {(isOwn: (url: string) => boolean) => Promise<Page>} */
async function newPage(isOwn) {
  const page = await context.newPage();
  watch(page, isOwn);
  return page;
}

/** @type {(example: Example) => Promise<void>} */
async function inReport(example) {
  plannedByCommand(command, folder, example, true);
  verifiedByCommand(command, folder, example, 'own');
  for (const name of programsOf(example)) {
    const page = await newPage(url => url.startsWith('file://'));
    await page.goto(`file://${folder}/own/${name.replace(/ngc$/, 'html')}`);
    check(await textOf(page, '#verdict') === 'CLEAN', `${name}: its report says CLEAN`);
    await scrubsBothWays(page, async () => {
      await page.reload();
      return page;
    }, name);
    await page.close();
  }
}

/** Solids are read by Open CASCADE, which the static page does not have. @type {(page: Page, example: Example) => Promise<void>} */
async function isRefused(page, example) {
  await page.waitForFunction(() => document.getElementById('plan-status')?.classList.contains('error'));
  check(/a STEP solid, which this page cannot read/.test(await textOf(page, '#plan-status')),
    `${example.part}: a solid is refused in plain words`);
}

/** @type {(page: Page, example: Example) => Promise<void>} */
async function inPage(page, example) {
  await opensAnew(page, address);
  await page.setInputFiles('#plan-files', filesOf(example).map(name => `${folder}/${name}`));
  await saysOptions(page, optionsOf(example));
  await page.click('#plan-go');
  if (home === 'web' && filesOf(example).some(name => name.endsWith('.step'))) {
    await isRefused(page, example);
    return;
  }
  await page.waitForFunction(() => {
    const status = document.getElementById('plan-status');
    return /^Done/.test(status?.textContent ?? '') || status?.classList.contains('error');
  });
  const said = await textOf(page, '#plan-status'), programs = plannedByCommand(command, folder, example);
  check(said === 'Done: CLEAN.', `${example.part}: ${said}`);
  if (!said.startsWith('Done')) return;
  for (const [k, name] of programsOf(example).entries()) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`#plan-downloads a[download="${name}"]`)]);
    await download.saveAs(`${folder}/downloaded/${name}`);
    check(
      readFileSync(`${folder}/downloaded/${name}`, 'utf8') === programs[k], `${name}: the page's program is the command's, byte for byte`);
  }
  verifiedByCommand(command, folder, example, 'downloaded');
  if (await page.locator('#plan-job').count() > 0) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#plan-job')]);
    await download.saveAs(`${folder}/downloaded/${download.suggestedFilename()}`);
    check(!(await textOf(page, '#plan-downloads')).includes('without'), `${example.part}: its job holds everything`);
    jobPlannedByCommand(command, folder, example, programs);
  }
  for (const [k, name] of programsOf(example).entries()) {
    if (k > 0) await page.selectOption('#plan-setup', {index: k});
    const again = async () => {
      await page.evaluate(`showFrame('plan-report', element('plan-report').src.split('#')[0])`);
      return reportIn(page, '#plan-report');
    };
    await scrubsBothWays(await reportIn(page, '#plan-report'), again, name);
  }
}

copyExamples(folder, resolve(examplesName));
mkdirSync(`${folder}/downloaded`);
const page = home === 'report' ? null : await newPage(url => url.startsWith(address) || /^(data|blob):/.test(url));
for (const example of EXAMPLES.filter(one => one.part.includes(process.env.CLEARCUT_EXAMPLES ?? '')))
  await (page ? inPage(page, example) : inReport(example));
check(EXAMPLES.length > 20 && hosted?.asked.every(one => one.startsWith('GET ')) !== false,
  'every example was tried, and nothing sent to a static host');
await browser.close();
hosted?.host.close();
conclude(`the examples in the ${home}`);
