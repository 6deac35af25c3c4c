// The examples planned, checked and looked at, for the tests of all three homes of the page: the report, the server's page, the static page.
import {spawnSync} from 'node:child_process';
import {copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {check} from './browser.mjs';
import {ACCEPTED, filesOf, optionsOf, programsOf, stemOf} from './example_parts.mjs';

/** @typedef {import('./example_parts.mjs').Example} Example */
/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').Frame} Frame */

const words = (/** @type {string} */ text) => text.split(' ').filter(word => word);

/** A folder of the examples' files in which the command works. @type {(folder: string, examples: string) => void} */
export function copyExamples(folder, examples) {
  rmSync(folder, {recursive: true, force: true});
  mkdirSync(folder, {recursive: true});
  for (const name of readdirSync(examples))
    if (statSync(`${examples}/${name}`).isFile()) copyFileSync(`${examples}/${name}`, `${folder}/${name}`);
}

/** Planned by the command: its programs, and with `report` the page of each program. @type {(command: string, folder: string, example: Example, report?: boolean) => string[]} */
export function plannedByCommand(command, folder, example, report = false) {
  mkdirSync(`${folder}/own`, {recursive: true});
  const stem = `own/${stemOf(example.part)}`;
  const ended = spawnSync(command,
    ['plan', example.part, ...words(optionsOf(example)), '-o', `${stem}.ngc`, ...report ? ['--report', `${stem}.html`] : [], '--quiet'],
    {cwd: folder, encoding: 'utf8'});
  check(ended.status === 0, `${example.part}: the command plans it ${ended.status === 0 ? '' : ended.stderr}`);
  return programsOf(example).map(name => existsSync(`${folder}/own/${name}`) ? readFileSync(`${folder}/own/${name}`, 'utf8') : '');
}

/** A job that the page gave away, planned by the command beside the files that it names: the same programs. @type {(command: string, folder: string, example: Example, programs: string[]) => void} */
export function jobPlannedByCommand(command, folder, example, programs) {
  const stem = stemOf(example.part), place = `${folder}/job`;
  rmSync(place, {recursive: true, force: true});
  mkdirSync(place);
  for (const name of filesOf(example)) copyFileSync(`${folder}/${name}`, `${place}/${name}`);
  copyFileSync(`${folder}/downloaded/${stem}.toml`, `${place}/${stem}.toml`);
  const ended = spawnSync(command, ['plan', `${stem}.toml`, '--quiet'], {cwd: place, encoding: 'utf8'});
  const same =
    programsOf(example).every((name, k) => existsSync(`${place}/${name}`) && readFileSync(`${place}/${name}`, 'utf8') === programs[k]);
  check(ended.status === 0 && same, `${stem}.toml: the page's job gives the same bytes ${ended.stderr}`);
}

/** The programs in `folder`/`from`, downloaded or written, by `clearcut verify`. @type {(command: string, folder: string, example: Example, from: string) => void} */
export function verifiedByCommand(command, folder, example, from) {
  const names = programsOf(example);
  names.forEach((name, k) => {
    const setup = (example.setups?.[k] ?? '').replace('EARLIER', `${from}/${names[0]}`);
    const ended = spawnSync(command,
      ['verify', `${from}/${name}`, '--part', example.part, '--dialect', 'linuxcnc', ...words(`${example.options} ${ACCEPTED} ${setup}`)],
      {cwd: folder, encoding: 'utf8'});
    check(ended.status === 0 && /^verdict: CLEAN$/m.test(ended.stdout),
      `${name}: the command finds it CLEAN${ended.status === 0 ? '' : `: ${ended.stderr} ${ended.stdout.slice(-400)}`}`);
  });
}

/** Waits until a piece of the report's own script holds; its policy lets no string be run from within. @type {(frame: Page | Frame, code: string) => Promise<void>} */
export async function until(frame, code) {
  for (let k = 0; k < 1200; ++k) {
    if (await frame.evaluate(code).catch(() => false) === true) return;
    await new Promise(soon => {
      setTimeout(soon, 100);
    });
  }
  throw new Error(`${code}: not in time`);
}

/** Where an element lies once all of it is in sight and the page around it moves no more. @type {(one: import('playwright-core').Locator) => Promise<{ x: number, y: number, width: number, height: number }>} */
async function boxInSight(one) {
  const window_ = one.page().viewportSize();
  for (let k = 0, before = ''; k < 100; ++k) {
    const box = await one.boundingBox(), now = JSON.stringify(box),
          isWhole = box && box.y >= 0 && box.y + box.height <= (window_?.height ?? Infinity);
    if (isWhole && now === before) return box;
    if (!isWhole)
      await one.evaluate(element => {
        element.scrollIntoView({block: 'center'});
      });
    before = now;
    await new Promise(soon => {
      setTimeout(soon, 100);
    });
  }
  throw new Error('the stage is not in sight');
}

/** The stage at rest, without its rounded edge, which a browser blends with what lies around as it likes. @type {(frame: Page | Frame) => Promise<Buffer>} */
export async function stageAtRest(frame) {
  await until(frame, '!redrawAsked && detail.settled');
  const page = 'page' in frame ? frame.page() : frame, box = await boxInSight(frame.locator('#stage'));
  return page.screenshot(
    {clip: {x: Math.ceil(box.x) + 8, y: Math.ceil(box.y) + 8, width: Math.floor(box.width) - 17, height: Math.floor(box.height) - 17}});
}

/**
 * Scrubs a report on and back to the middle; what is seen then has to be what a fresh replay shows, byte for byte. `again` opens it anew.
 * @type {(frame: Page | Frame, again: () => Promise<Page | Frame>, what: string) => Promise<void>}
 */
export async function scrubsBothWays(frame, again, what) {
  await frame.evaluate('play(false); show(total * 0.95); show(total * 0.1); show(total * 0.55 + 1); show(total * 0.55)');
  const back = await stageAtRest(frame), other = await again();
  await other.evaluate('play(false); show(total * 0.55)');
  const fresh = await stageAtRest(other);
  if (!back.equals(fresh)) ['back', 'fresh'].forEach((name, k) => writeFileSync(`${tmpdir()}/${what}-${name}.png`, [back, fresh][k]));
  check(back.equals(fresh), `${what}: scrubbed both ways it looks as a fresh replay does`);
}
