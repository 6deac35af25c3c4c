// The check of a program as a function of texts, for Node and for pages. README.md describes question and answer.
'use strict';

(function(root, factory) {
if (typeof module === 'object' && module.exports) module.exports = factory(require('./clearcut-gate.js'), nodeBinary);
else root.clearcutGate = factory(root.clearcutGateModule, () => undefined);

/** The bytes of the module, from the file beside this one. */
function nodeBinary() { return require('fs').readFileSync(require('path').join(__dirname, 'clearcut-gate.wasm')); }
})(typeof self === 'undefined' ? globalThis : self, (instantiate, binaryBeside) => {
/** A text of the module's memory that ends with a zero; its place is given back. */
function takeText(instance, at) {
  const heap = instance.HEAPU8;
  let end = at;
  while (heap[end] !== 0) ++end;
  const text = new TextDecoder().decode(heap.slice(at, end));
  instance._free(at);
  return text;
}

/** A text as bytes in the module's memory. */
function putText(instance, text) {
  const bytes = new TextEncoder().encode(text);
  const at = instance._malloc(bytes.length + 1);
  instance.HEAPU8.set(bytes, at);
  return {at, size: bytes.length};
}

function gateOf(instance) {
  let ended = '';

  function check(program, question) {
    if (ended) throw new Error(ended);
    const asked = typeof question === 'string' ? question : JSON.stringify(question);
    try {
      const first = putText(instance, String(program));
      const second = putText(instance, asked);
      const answer = instance._clearcut_check(first.at, first.size, second.at, second.size);
      instance._free(first.at);
      instance._free(second.at);
      return takeText(instance, answer);
    } catch (error) {
      ended = 'this gate ended with ' + error.message + '; make another with createGate()';
      return JSON.stringify({error: 'the check ended: ' + error.message + '; check a smaller program'});
    }
  }

  function optionNames() { return takeText(instance, instance._clearcut_option_names()).split('\n').filter(Boolean); }

  return {check, optionNames};
}

/** Resolves to a gate. `wasmBinary`: bytes of clearcut-gate.wasm, where a page has them already. */
async function createGate(settings = {}) {
  const binary = settings.wasmBinary || binaryBeside();
  return gateOf(await instantiate(binary ? {wasmBinary: binary} : {}));
}

return {createGate};
});
