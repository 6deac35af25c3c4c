'use strict';
// Small helpers of the page.

const element = id => document.getElementById(id);

/** An element of that kind with text and attributes. */
function made(kind, text, attributes = {}) {
  const one = document.createElement(kind);
  if (text) one.textContent = text;
  for (const [name, value] of Object.entries(attributes)) one.setAttribute(name, value);
  return one;
}

function fillList(list, texts) { list.replaceChildren(...texts.map(text => made('li', text))); }

/** Shows the page at `address` in the frame of that id, or hides it where there is none. A new frame each time: one that was hidden with its page may stay blank with the next. */
function showFrame(id, address) {
  const frame = element(id).cloneNode();
  frame.hidden = !address;
  frame.src = address ?? 'about:blank';
  element(id).replaceWith(frame);
}

function fillSelect(select, values, first) {
  const options = values.map(value => made('option', value, { value }));
  if (first) options.unshift(made('option', first, { value: '' }));
  select.replaceChildren(...options);
}

/** Says what is going on; errors are told apart. */
function say(status, text, isError = false) {
  status.textContent = text;
  status.classList.toggle('error', isError);
}

/** A word as a shell takes it. */
function quoted(word) { return /^[\w@%+=:,./-]+$/.test(word) ? word : `"${word.replaceAll('"', '')}"`; }

/** A file's name without its ending. */
const stemOf = name => name.replace(/\.[^.]*$/, '');
