// node try.mjs COMMAND UNPACKED EXAMPLES FOLDER: runs the programs for Windows in UNPACKED under Wine, in FOLDER. For every example, program,
// certificate, picture, report, set-up sheet, messages and exit code have to be those of COMMAND, byte for byte; solids have to be refused
// in plain words. Then names beyond ASCII, the checker of proofs, a batch, and the server with its page.
import {spawn, spawnSync} from 'node:child_process';
import {copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync} from 'node:fs';
import path from 'node:path';
import {EXAMPLES, filesOf, optionsOf, stemOf} from '../viewer_browser/example_parts.mjs';

/** How a run ended. @typedef {{ code: number | null, messages: string, text: string, seconds: number }} Ran */

const [command, unpacked, examples, folder] = process.argv.slice(2).map(word => path.resolve(word));
const quiet = {
  ...process.env,
  NO_COLOR: '1',
  COLUMNS: '100',
  CLEARCUT_PROGRESS: 'json'
};
const homes = {
  own: [command],
  wine: ['wine', path.join(unpacked, 'clearcut.exe')]
};
let passed = 0, failed = 0, ownSeconds = 0, wineSeconds = 0;

/** @type {(holds: boolean, what: string) => boolean} */
function check(holds, what) {
  if (holds) ++passed;
  else {
    ++failed;
    console.log(`FAILED ${what}`);
  }
  return holds;
}

/** Runs a command in a home's folder. @type {(home: 'own' | 'wine', words: string[]) => Ran} */
function run(home, words) {
  const began = performance.now(), [program, ...first] = homes[home];
  const end = spawnSync(program, [...first, ...words], {cwd: path.join(folder, home), encoding: 'utf8', env: quiet});
  return {
    code: end.status,
    messages: end.stderr.replace(/^\{"progress".*\n/gm, ''),
    text: end.stdout,
    seconds: (performance.now() - began) / 1000
  };
}

/** Files below a folder. @type {(place: string) => string[]} */
const filesBelow = place => existsSync(place) ?
  readdirSync(place, {recursive: true}).map(String).filter(name => statSync(path.join(place, name)).isFile()).sort() :
  [];

/** The same words in both homes: the same exit code, messages, text, and files in `out`. @type {(words: string[], what: string) => Ran} */
function same(words, what) {
  const own = run('own', words), wine = run('wine', words);
  ownSeconds += own.seconds;
  wineSeconds += wine.seconds;
  /** @type {string[]} */
  const different = [];
  if (own.code !== wine.code) different.push(`exit code ${own.code} and ${wine.code}: ${wine.messages}`);
  if (own.messages !== wine.messages) different.push(`messages "${own.messages}" and "${wine.messages}"`);
  if (own.text !== wine.text) different.push(`text: ${firstDifference(own.text, wine.text)}`);
  const ownFiles = filesBelow(path.join(folder, 'own/out')), wineFiles = filesBelow(path.join(folder, 'wine/out'));
  if (ownFiles.join() !== wineFiles.join()) different.push(`files ${ownFiles.join()} and ${wineFiles.join()}`);
  for (const name of ownFiles.filter(one => wineFiles.includes(one))) {
    const a = readFileSync(path.join(folder, 'own/out', name)), b = readFileSync(path.join(folder, 'wine/out', name));
    if (!a.equals(b)) different.push(`${name}: ${firstDifference(a.toString(), b.toString())}`);
  }
  check(different.length === 0, `${what}: ${different.join('; ')}`);
  return wine;
}

/** Where two texts part, as a line of both. @type {(one: string, other: string) => string} */
function firstDifference(one, other) {
  const a = one.split('\n'), b = other.split('\n'), at = a.findIndex((line, i) => line !== b[i]);
  return `line ${at + 1}: ${(a[at] ?? 'the end').slice(0, 200)} | ${(b[at] ?? 'the end').slice(0, 200)}`;
}

/** Both homes with nothing but the examples. */
function newFolders() {
  for (const home of ['own', 'wine']) {
    rmSync(path.join(folder, home), {recursive: true, force: true});
    mkdirSync(path.join(folder, home, 'out'), {recursive: true});
    for (const name of readdirSync(examples))
      if (statSync(path.join(examples, name)).isFile()) copyFileSync(path.join(examples, name), path.join(folder, home, name));
  }
}

const words = (/** @type {string} */ text) => text.split(' ').filter(word => word);
const resultsOf = (/** @type {string} */ stem) => ['-o', `out/${stem}.ngc`, '--certificate', `out/${stem}.json`, '--svg', `out/${stem}.svg`,
  '--report', `out/${stem}.html`, '--setup-sheet', `out/${stem}-sheet.html`];

let equal = 0, refused = 0;
for (const example of EXAMPLES) {
  newFolders();
  const before = failed, plan = ['plan', example.part, ...words(optionsOf(example)), ...resultsOf(stemOf(example.part))];
  if (filesOf(example).some(name => name.endsWith('.step'))) {
    const end = run('wine', plan);
    if (check(end.code === 2 && end.messages.includes('a STEP solid, which Clearcut for Windows cannot read'),
          `${example.part}: a solid is refused in plain words: ${end.messages}`))
      ++refused;
    continue;
  }
  same(plan, example.part);
  if (!existsSync(path.join(folder, 'wine/out', `${stemOf(example.part)}.ngc`))) check(false, `${example.part}: no program`);
  same(['verify', `out/${stemOf(example.part)}.ngc`, '--part', example.part, ...words(example.options)], `${example.part}, verified`);
  if (failed === before) ++equal;
}
console.log(`${equal} examples are the same bytes, ${refused} solids are refused; ${ownSeconds.toFixed(1)} s here, ${
  wineSeconds.toFixed(1)} s under Wine`);

newFolders();
for (const home of ['own', 'wine']) {
  mkdirSync(path.join(folder, home, 'Stück für 𝄞'));
  copyFileSync(path.join(examples, 'plate.dxf'), path.join(folder, home, 'Stück für 𝄞/Öse.dxf'));
}
const plate = words('--tool endmill:5 --tool chamfer:90deg:8:tip=0.4 --stepdown 3');
same(['plan', 'Stück für 𝄞/Öse.dxf', ...plate, '-o', 'out/Öse.ngc', '--certificate', 'out/Öse.json'], 'names beyond ASCII');
same(['plan', 'Stück für 𝄞/Öse.dxf', ...plate, '-o', 'out/Öse.ngc'], 'a program is replaced');
same(['plan', 'Stück für 𝄞/Öse.dxf', ...plate, '-o', '-'], 'a program on standard output');
same(['plan', 'plate.dxf', ...plate, '-o', 'out/threads.ngc', '--threads', '4'], 'several threads');
same(['plan', 'none.dxf'], 'a file that is not there');
same(['plan', 'plate.dxf', '--no-such-option'], 'an unknown option');
same(['plan', 'plate.dxf', ...plate, '-o', 'no/such/folder.ngc'], 'a folder that is not there');
same(['plan', 'bracket.json', '--tool', 'endmill:6', '-o', 'out/bracket.ngc', '--witness', 'out/bracket.ccw'], 'a witness');
same(['info', 'plate.dxf', '--json'], 'info');
same(['machines'], 'the machines');
same(['generate', 'options'], 'options, by clearcut-studies');
const proven = run('wine', ['verify', 'out/bracket.ngc', '--part', 'bracket.json', '--tool', 'endmill:6', '--prove']);
check(
  proven.code === 0 && proven.text.includes('proved by witness'), `a program proved by clearcut-check: ${proven.text} ${proven.messages}`);
newFolders();
for (const home of ['own', 'wine']) {
  mkdirSync(path.join(folder, home, 'parts/deep'), {recursive: true});
  copyFileSync(path.join(examples, 'bracket.dxf'), path.join(folder, home, 'parts/deep/bracket.dxf'));
  copyFileSync(path.join(examples, 'inch_plate.dxf'), path.join(folder, home, 'parts/inch.dxf'));
}
for (const home of /** @type {('own' | 'wine')[]} */ (['own', 'wine']))
  check(run(home, ['batch', 'parts', ...words('--tool endmill:3 --jobs 2 --quiet'), '-o', 'out']).code !== null, `a batch (${home})`);
for (const name of ['deep/bracket.dxf.ngc', 'inch.dxf.ngc', 'results.csv', 'results.json']) {
  const [a, b] = ['own', 'wine'].map(home => path.join(folder, home, 'out', name));
  check(existsSync(a) && existsSync(b) && readFileSync(a).equals(readFileSync(b)), `${name} of a batch`);
}

/** Starts the server, any free port. @type {() => Promise<{ process: import('node:child_process').ChildProcess, address: string }>} */
function serve() {
  const server = spawn(
    'wine', [path.join(unpacked, 'clearcut.exe'), 'serve', '--port', '0'], {cwd: folder, env: quiet, stdio: ['ignore', 'pipe', 'inherit']});
  return new Promise((resolve, reject) => {
    let text = '';
    server.stdout?.on('data', more => {
      text += String(more);
      const address = /http:\S+/.exec(text)?.[0];
      if (address) resolve({process: server, address});
    });
    server.on('exit', () => reject(new Error(`the server ends at once: ${text}`)));
    setTimeout(() => reject(new Error('the server says no address')), 60000);
  });
}

/** A plan by the server. @type {(address: string) => Promise<string>} */
async function plannedAt(address) {
  const form = new FormData();
  form.append('part', new Blob([readFileSync(path.join(examples, 'plate.dxf'))]), 'plate.dxf');
  form.append('options', plate.join(' '));
  const posted = await fetch(`${address}plan`, {method: 'POST', body: form});
  const {id} = /** @type {{ id: string }} */ (await posted.json());
  await (await fetch(`${address}plan/${id}/events`)).text();
  return (await fetch(`${address}plan/${id}/program`)).text();
}

try {
  const {process: server, address} = await serve();
  const page = await fetch(address), html = await page.text();
  check(page.status === 200 && html.includes('<title>') && html.includes('app.js'), 'the server gives its page');
  const script = await fetch(`${address}app.js`);
  check(script.status === 200 && (await script.text()).length > 10000, 'and its script');
  same(['plan', 'plate.dxf', ...plate, '-o', 'out/plate.ngc'], 'the plate');
  check(await plannedAt(address) === readFileSync(path.join(folder, 'own/out/plate.ngc'), 'utf8'), 'the server plans the same bytes');
  const ended = new Promise(resolve => server.on('exit', resolve));
  server.kill();
  await ended;
  await new Promise(soon => setTimeout(soon, 1000));
  const left = await fetch(address).then(() => true, () => false);
  check(!left, 'the server ends with the command');
} catch (error) { check(false, `the server: ${String(error)}`); }
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
