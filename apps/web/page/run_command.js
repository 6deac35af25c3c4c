'use strict';
// Runs the command once, in memory of its own: its files are those that are handed to it, and nothing else. Used by the worker of the
// page and by the tests under Node.

/**
 * `makeModule`: what emscripten's script gives; `wasm`: the compiled WebAssembly.Module; `words`: as on the command line;
 * `files`: [name, Uint8Array] pairs, put into the folder it runs in; `heard` is called with each line on standard error.
 * Gives the exit code, standard output, and the files of the folder results/.
 * @type {RunCommand}
 */
async function runCommand(makeModule, wasm, words, files, heard) {
  /** @type {string[]} */
  const lines = [];
  const module = await makeModule({
    noInitialRun: true,
    quit: (status, thrown) => {
      throw thrown;
    },  // under Node it would end the process
    print: line => lines.push(line),
    printErr: heard,
    instantiateWasm: (imports, done) => {
      WebAssembly.instantiate(wasm, imports).then(instance => done(instance, wasm));
      return {};
    },
    preRun: [one => Object.assign(one.ENV, {CLEARCUT_PROGRESS: 'json', COLUMNS: '100', NO_COLOR: '1'})],
  });
  const {FS} = module;
  FS.mkdir('/files');
  FS.mkdir('/files/results');
  FS.chdir('/files');
  for (const [name, bytes] of files) FS.writeFile(name, bytes);
  const code = module.callMain(words);
  /** @type {CommandEnd['results']} */
  const results = {};
  for (const name of FS.readdir('results'))
    if (!name.startsWith('.')) results[name] = FS.readFile(`results/${name}`);
  return {code, text: lines.length > 0 ? `${lines.join('\n')}\n` : '', results};
}

if (typeof module !== 'undefined') module.exports = {runCommand};
