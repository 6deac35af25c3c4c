// The scripts of a page without a browser: as much of a document as they touch before anything is drawn, so that what they compute can be asked.
import fs from 'node:fs';
import path from 'node:path';
import vm from 'node:vm';

export const root = path.resolve(import.meta.dirname, '../..');

/** An element that holds what it is given and draws nothing. */
class FakeElement {
  /** @param {string} id */
  constructor(id) {
    this.id = id;
    this.textContent = '';
    this.value = '';
    this.hidden = false;
    /** @type {Record<string, string>} */
    this.style = {};
    /** @type {Record<string, string>} */
    this.dataset = {};
    /** @type {FakeElement[]} */
    this.children = [];
    this.classList = {toggle() {}, add() {}, remove() {}};
  }

  getContext() { return {}; }
  /** @param {FakeElement[]} more */
  append(...more) { this.children.push(...more); }
  /** @param {FakeElement[]} all */
  replaceChildren(...all) { this.children = all; }
  setAttribute() {}
  addEventListener() {}
  scrollIntoView() {}
  focus() {}
  querySelectorAll() { return []; }
  /** @param {string} kind */
  querySelector(kind) { return new FakeElement(kind); }
  /** @type {FakeElement[]} */
  get rows() { return []; }
}

/** The scripts of a folder up to and with the last one that is wanted, in the page's order. @type {(folder: string, last: string) => string} */
function scriptsOf(folder, last) {
  const names = fs.readFileSync(path.join(folder, 'scripts.txt'), 'utf8').trim().split('\n'), end = names.indexOf(last);
  if (end < 0) throw new Error(`${folder} has no script ${last}`);
  return names.slice(0, end + 1).map(name => fs.readFileSync(path.join(folder, name), 'utf8')).join('\n');
}

/**
 * Runs the scripts of a page up to `last` and gives what asks them: an expression of theirs, its value as plain data.
 * @type {(folder: string, last: string, texts?: Record<string, string>) => (expression: string) => unknown}
 */
export function runScripts(folder, last, texts = {}) {
  /** @type {Map<string, FakeElement>} */
  const elements = new Map();
  /** @type {(id: string) => FakeElement} */
  const elementOf = id => {
    const found = elements.get(id) ?? new FakeElement(id);
    found.textContent ||= texts[id] ?? '';
    elements.set(id, found);
    return found;
  };
  const document = {getElementById: elementOf, createElement: elementOf.bind(null, ''), documentElement: new FakeElement('')};
  const context = vm.createContext({
    document,
    matchMedia: () => ({matches: false}),
    getComputedStyle: () => ({getPropertyValue: () => '#123456'}),
    setTimeout,
    clearTimeout,
    URL,
    URLSearchParams,
    Blob,
    File,
    FormData,
    TextDecoder,
    TextEncoder,
    atob,
    btoa,
    Path2D: Object
  });
  vm.runInContext(scriptsOf(path.join(root, folder), last), context);
  return expression => {
    const text = vm.runInContext(`JSON.stringify(${expression})`, context);
    return text === undefined ? undefined : JSON.parse(text);
  };
}

/**
 * The report's scripts with that job.
 * @type {(last: string, job: object) => (expression: string) => unknown}
 */
export const runReport = (last, job) => runScripts('src/report/viewer', last, {job: JSON.stringify(job)});
