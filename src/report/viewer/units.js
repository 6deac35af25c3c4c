// ---- Words and figures. The job is in mm; what is shown is in the unit chosen.
/** @type {Record<string, Unit>} */
const UNITS = {
  mm: {per: 1, name: 'mm', feed: 'mm/min', more: 0},
  inch: {per: 1 / 25.4, name: 'in', feed: 'in/min', more: 1}
};
let unit = UNITS.mm;
/** @type {(v: number | null, n: number) => string} */
const fixed = (v, n) => v === null || !isFinite(v) ? '?' : v.toFixed(n);
/** @type {(mm: number | null, n: number) => string} */
const bare = (mm, n) => mm === null ? '?' : fixed(mm * unit.per, n + unit.more);
/** @type {(mm: number | null, n: number) => string} */
const lengthText = (mm, n) => bare(mm, n) + '\u00a0' + unit.name;
/** Sizes, areas, lengths and places in a sentence of the job. */
const SAID =
  /(?:(?<width>-?\d+(?:\.\d+)?) x )?(?<mm>-?\d+(?:\.\d+)?) mm\b|(?<mm2>\d+(?:\.\d+)?) mm2\b|\b(?<axis>[xyz]) (?<at>-?\d+(?:\.\d+)?)/g;
/** @type {(text: string) => string} */
function sentence(text) {
  if (unit === UNITS.mm) return text;
  const inches = (/** @type {string | undefined} */ mm) => String(Number((Number(mm) * unit.per).toFixed(4)));
  return text.replaceAll(SAID, (...found) => {
    /** @type {Record<string, string | undefined>} */
    const {width, mm, mm2, axis, at} = found.at(-1);
    if (mm) return (width ? inches(width) + ' x ' : '') + inches(mm) + ' in';
    return mm2 ? Number((Number(mm2) * unit.per * unit.per).toFixed(5)) + ' in2' : axis + ' ' + inches(at);
  });
}
/** @type {(v: number) => string} */
const feedText = v => v > 0 ? bare(v, 0) + '\u00a0' + unit.feed : 'rapid';

/** @type {(s: number | null) => string} */
function clock(s) {
  if (s === null || !isFinite(s)) return '?';
  s = Math.round(s);
  const two = (/** @type {number} */ v) => String(v).padStart(2, '0');
  const hours = Math.floor(s / 3600), minutes = Math.floor(s / 60) % 60;
  return (hours ? hours + ':' + two(minutes) : minutes) + ':' + two(s % 60);
}

/** @template {keyof HTMLElementTagNameMap} Name @param {Name} name @param {string | number} [text] @param {Element} [parent] @param {string} [type] @returns {HTMLElementTagNameMap[Name]} */
function element(name, text, parent, type) {
  const e = document.createElement(name);
  if (text !== undefined) e.textContent = String(text);
  if (type) e.className = type;
  if (parent) parent.append(e);
  return e;
}
