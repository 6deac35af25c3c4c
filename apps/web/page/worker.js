'use strict';
// One run of the command; the page ends this worker to cancel it.
importScripts('run_command.js', 'clearcut.js');

onmessage = async event => {
  const { wasm, words, files } = event.data;
  try {
    const end = await runCommand(clearcutModule, wasm, words, files, line => postMessage({ line }));
    postMessage({ end });
  } catch (error) {
    postMessage({ broken: String(error && error.message ? error.message : error) });
  }
};
