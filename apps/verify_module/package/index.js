// The check of a program as a function of texts, for Node and for pages. README.md describes question and answer.
'use strict';

(function(root, factory) {
if (typeof module === 'object' && module.exports) module.exports = factory(require('./clearcut-verify.js'), nodeBinary);
else root.clearcutVerify = factory(root.clearcutVerifyModule, () => undefined);

/** The bytes of the module, from the file beside this one. */
function nodeBinary() { return require('fs').readFileSync(require('path').join(__dirname, 'clearcut-verify.wasm')); }
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

function verifierOf(instance) {
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
      ended = 'this verifier ended with ' + error.message + '; make another with createVerifier()';
      return JSON.stringify({error: 'the check ended: ' + error.message + '; check a smaller program'});
    }
  }

  function optionNames() { return takeText(instance, instance._clearcut_option_names()).split('\n').filter(Boolean); }

  return {check, optionNames};
}

/** Resolves to a verifier. `wasmBinary`: bytes of clearcut-verify.wasm, where a page has them already. */
async function createVerifier(settings = {}) {
  const binary = settings.wasmBinary || binaryBeside();
  return verifierOf(await instantiate(binary ? {wasmBinary: binary} : {}));
}

return {createVerifier};
});
