'use strict';
// Small helpers of the page.

/**
 * The element of the page with that id.
 * @template {keyof PageElements} Id @param {Id} id @returns {PageElements[Id]}
 */
function element(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`This page has no element ${id}.`);
  return /** @type {PageElements[Id]} */ (found);
}


/**
 * An element of that kind with text and attributes.
 * @template {keyof HTMLElementTagNameMap} Kind @param {Kind} kind @param {string} [text] @param {Record<string, string | number>} [attributes] @returns {HTMLElementTagNameMap[Kind]}
 */
function made(kind, text, attributes = {}) {
  const one = document.createElement(kind);
  if (text) one.textContent = text;
  for (const [name, value] of Object.entries(attributes)) one.setAttribute(name, String(value));
  return one;
}

/** @type {(list: HTMLElement, texts: string[]) => void} */
function fillList(list, texts) { list.replaceChildren(...texts.map(text => made('li', text))); }

/**
 * Shows the page at `address` in the frame of that id, or hides it where there is none. A new frame each time: one that was hidden with its page may stay blank with the next.
 * @type {(id: 'plan-report' | 'check-report' | 'elements-report', address?: string) => void}
 */
function showFrame(id, address) {
  const frame = /** @type {HTMLIFrameElement} */ (element(id).cloneNode());
  frame.hidden = !address;
  frame.src = address ? `${address}#framed${lengths.inch && id !== 'elements-report' ? '&unit=inch' : ''}` : 'about:blank';
  element(id).replaceWith(frame);
}

/** @type {(select: HTMLSelectElement, values: string[], first?: string) => void} */
function fillSelect(select, values, first) {
  const options = values.map(value => made('option', value, {value}));
  if (first) options.unshift(made('option', first, {value: ''}));
  select.replaceChildren(...options);
}

/** Says what is going on; errors are told apart. @type {(status: HTMLElement, text: string, isError?: boolean) => void} */
function say(status, text, isError = false) {
  status.textContent = text;
  status.classList.toggle('error', isError);
  status.classList.remove('done');
}

/** A word as a shell takes it. @type {(word: string) => string} */
function quoted(word) { return /^[\w@%+=:,./-]+$/.test(word) ? word : `"${word.replaceAll('"', '')}"`; }

/** What an error says. @type {(error: unknown) => string} */
const wordsOfError = error => error instanceof Error ? error.message : String(error);

/** The only element of that kind in another. @type {<Kind extends keyof HTMLElementTagNameMap>(kind: Kind, within: Element) => HTMLElementTagNameMap[Kind]} */
function theOne(kind, within) {
  const found = within.querySelector(kind);
  if (!found) throw new Error(`There is no ${kind}.`);
  return found;
}

/** A file's name without its ending. @type {(name: string) => string} */
const stemOf = name => name.replace(/\.[^.]*$/, '');

/** The field that somebody is typing in: what was typed is not said yet, and must not be overwritten by what is. @type {{ field: Element | null }} */
const typing = {
  field: null
};
/** @type {(within: Element) => boolean} */
const isTypedIn = within => typing.field !== null && typing.field === document.activeElement && within.contains(typing.field);

/** `left`: called once such a field was left. @type {(left: () => void) => void} */
function watchTyping(left) {
  document.addEventListener('input', event => {
    const {target} = event;
    typing.field = target instanceof HTMLInputElement && !['checkbox', 'file', 'range'].includes(target.type) ? target : null;
  }, true);
  document.addEventListener('change', () => {
    typing.field = null;
  }, true);
  document.addEventListener('focusout', () => {
    if (!typing.field) return;
    typing.field = null;
    setTimeout(left);
  });
}
