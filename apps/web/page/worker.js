'use strict';
// One run of the command; the page ends this worker to cancel it.
importScripts('run_command.js', 'clearcut.js');

onmessage = async event => {
  /** @type {WorkerTask} */
  const {wasm, words, files} = event.data;
  /** @type {(message: WorkerMessage) => void} */
  const tell = message => postMessage(message);
  try {
    const end = await runCommand(clearcutModule, wasm, words, files, line => tell({line}));
    tell({end});
  } catch (error) {
    // What emscripten throws at an exit is no Error.
    tell({broken: typeof error === 'object' && error !== null && 'message' in error ? String(error.message) : String(error)});
  }
};
