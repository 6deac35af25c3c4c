// node command.mjs FOLDER WORD...: runs the command of the web build (FOLDER holds clearcut.js and clearcut.wasm) as a page does: every
// file of the current folder is handed to it; what it writes to results/ is written to ./results.
import fs from 'node:fs';
import path from 'node:path';
import {createRequire} from 'node:module';

const require = createRequire(import.meta.url);
const [folder, ...words] = process.argv.slice(2);
/** @type {{ runCommand: RunCommand }} */
const {runCommand} = require(path.resolve(import.meta.dirname, 'page/run_command.js'));
/** @type {MakeModule} */
const makeModule = require(path.resolve(folder, 'clearcut.js'));
const wasm = new WebAssembly.Module(fs.readFileSync(path.join(folder, 'clearcut.wasm')));
/** @type {NamedBytes[]} */
const files = fs.readdirSync('.', {withFileTypes: true}).filter(one => one.isFile()).map(one => [one.name, fs.readFileSync(one.name)]);
const end = await runCommand(makeModule, wasm, words, files, line => {
  if (!line.startsWith('{"progress"')) process.stderr.write(`${line}\n`);
});
process.stdout.write(end.text);
fs.mkdirSync('results', {recursive: true});
for (const [name, bytes] of Object.entries(end.results)) fs.writeFileSync(path.join('results', name), bytes);
process.exitCode = end.code;
