// node same_bytes.mjs COMMAND BUILT EXAMPLES COUNT [SEED]: plans the examples for every controller in both units, and COUNT random parts, with
// the command and with its WebAssembly build in the folder BUILT. Programs, exit codes and messages have to be the same. Tells the times of both.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {createRequire} from 'node:module';
import {randomJob} from './random_job.mjs';

/** @typedef {import('./random_job.mjs').WebJob} WebJob */
/** How a run ended. @typedef {{ code: number | null, messages: string, text: string, program: string, seconds: number }} Ran */

const require = createRequire(import.meta.url);
const [command, built, examples] = process.argv.slice(2, 5).map(word => path.resolve(word));
const count = Number(process.argv[5] ?? 20), seed = Number(process.argv[6] ?? 1);
/** @type {{ runCommand: RunCommand }} */
const {runCommand} = require(path.resolve(import.meta.dirname, '../../apps/web/page/run_command.js'));
/** @type {MakeModule} */
const makeModule = require(path.join(built, 'clearcut.js'));
const wasm = new WebAssembly.Module(fs.readFileSync(path.join(built, 'clearcut.wasm')));

// CLEARCUT_POSTS=linuxcnc: only this one, where time is short.
const controllers = (process.env.CLEARCUT_POSTS ?? 'linuxcnc fanuc grbl haas heidenhain mach3 mach4 marlin').split(' ');
process.setMaxListeners(0);  // emscripten adds some with each run
const exampleParts = [
  ['bracket.dxf', '--tool=endmill:6', '--stepdown=2.5'], ['bracket.svg', '--tool=endmill:6'], ['bracket.json', '--tool=endmill:6'],
  ['bracket.toml'], ['fishhead.p21', '--stepdown=50'], ['fishhead.p21', '--stepdown=2'], ['fishhead_sloped.p21', '--stepdown=50'],
  ['sign.dxf', '--tool=vbit:60deg:10'], ['plate.dxf', '--tool=endmill:5', '--tool=chamfer:90deg:8:tip=0.4', '--stepdown=3'],
  ['five_pockets.toml'], ['bracket.dxf', '--tool=endmill:6', '--origin=corner'], ['bracket.step', '--tool=endmill:6']
];

/** @type {[string, Uint8Array][]} */
const exampleFiles = fs.readdirSync(examples, {withFileTypes: true})
                       .filter(one => one.isFile())
                       .map(one => [one.name, fs.readFileSync(path.join(examples, one.name))]);

/** @type {() => WebJob[]} */
function jobs() {
  /** @type {WebJob[]} */
  const out = [];
  for (const words of exampleParts)
    for (const post of controllers)
      for (const unit of ['mm', 'inch'])
        out.push({
          name: `${words.join(' ')} ${post} ${unit}`,
          files: exampleFiles,
          words:
            [...words, `--post=${post}`, ...(unit === 'inch' ? ['--inch'] : []), ...(post === 'marlin' ? ['--accept=tool-by-hand'] : [])]
        });
  for (let i = 0; i < count; ++i) out.push(randomJob(seed + i));
  return out;
}

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'clearcut-web-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true, force: true}));

/** @type {(job: WebJob, words: string[]) => Ran} */
function native(job, words) {
  fs.rmSync(folder, {recursive: true, force: true});
  fs.mkdirSync(path.join(folder, 'results'), {recursive: true});
  for (const [name, bytes] of job.files) fs.writeFileSync(path.join(folder, name), bytes);
  const began = performance.now();
  const end = spawnSync(
    command, words, {cwd: folder, encoding: 'utf8', env: {...process.env, NO_COLOR: '1', COLUMNS: '100', CLEARCUT_PROGRESS: 'json'}});
  const seconds = (performance.now() - began) / 1000, program = path.join(folder, 'results/program');
  return {
    code: end.status,
    messages: end.stderr.replace(/^\{"progress".*\n/gm, ''),
    text: end.stdout,
    program: fs.existsSync(program) ? fs.readFileSync(program, 'utf8') : '',
    seconds
  };
}

/** @type {(job: WebJob, words: string[]) => Promise<Ran>} */
async function inBrowser(job, words) {
  let messages = '';
  const began = performance.now();
  const end = await runCommand(makeModule, wasm, words, job.files, line => {
    if (!line.startsWith('{"progress"')) messages += `${line}\n`;
  });
  const program = end.results.program;
  return {
    code: end.code,
    messages,
    text: end.text,
    program: program ? new TextDecoder().decode(program) : '',
    seconds: (performance.now() - began) / 1000
  };
}

/** Where two texts part, as a line of both. @type {(one: string, other: string) => string} */
function firstDifference(one, other) {
  const a = one.split('\n'), b = other.split('\n'), at = a.findIndex((line, i) => line !== b[i]);
  return `line ${at + 1}: ${a[at] ?? 'the end'} | ${b[at] ?? 'the end'}`;
}

/** @type {(job: WebJob) => boolean} */
const isSolid = job => job.words[0].endsWith('.step');
let same = 0, nativeSeconds = 0, webSeconds = 0;
const different = {
  length: 0,
  push(/** @type {string} */ line) {
    ++this.length;
    console.log(`DIFFERENT ${line}`);
  },
};
for (const job of jobs()) {
  const words = ['plan', ...job.words, '--threads=1', '--output=results/program'];
  const web = await inBrowser(job, words);
  if (isSolid(job)) {
    if (web.code === 2 && web.messages.includes('STEP solid, which this page cannot read')) ++same;
    else different.push(`${job.name}: a solid is not refused plainly: ${web.messages}`);
    continue;
  }
  const own = native(job, words);
  nativeSeconds += own.seconds;
  webSeconds += web.seconds;
  /** @type {(keyof Ran)[]} */
  const compared = ['code', 'program', 'messages', 'text'], parts = compared.filter(part => own[part] !== web[part]);
  if (parts.length === 0) ++same;
  else different.push(`${job.name}: ${parts.map(part => `${part}: ${firstDifference(String(own[part]), String(web[part]))}`).join('; ')}`);
  if (parts.length > 0 && process.env.CLEARCUT_KEEP && job.seed !== undefined)
    fs.writeFileSync(path.join(process.env.CLEARCUT_KEEP, `${job.seed}.json`), job.files[0][1]);
}
console.log(`the command ${nativeSeconds.toFixed(1)} s on one thread, WebAssembly ${webSeconds.toFixed(1)} s`);
console.log(`${same} passed, ${different.length} failed`);
process.exit(different.length === 0 ? 0 : 1);
