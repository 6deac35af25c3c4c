// Lengths in the unit that was chosen at the top: fields hold them so, commands and results are in mm.

const MM_PER_INCH = 25.4;
const lengths = {
  inch: false
};
const lengthName = () => lengths.inch ? 'in' : 'mm';
/** Decimals that keep a length exact from one unit to the other and back. */
const DECIMALS = {
  mm: 4,
  inch: 6
};

/** Every number in a text by another; those that name a unit themselves stay. @type {(text: string, change: (value: number) => number) => string} */
const changedNumbers = (text, change) =>
  /\d\s*(mm|in)\b/.test(text) ? text : text.replaceAll(/-?(?:\d+\.?\d*|\.\d+)/g, found => String(change(Number(found))));
/** @type {(value: number) => number} */
const inchToMm = value => round(value * MM_PER_INCH, DECIMALS.mm);
/** @type {(value: number) => number} */
const mmToInch = value => round(value / MM_PER_INCH, DECIMALS.inch);
/** What a field of lengths says, as the command takes it. @type {(text: string) => string} */
const inMm = text => lengths.inch ? changedNumbers(text.trim(), inchToMm) : text.trim();
/** A length of a result, as it is shown. @type {(mm: number, decimals: number) => number} */
const shownLength = (mm, decimals) => lengths.inch ? round(mm / MM_PER_INCH, decimals + 1) : round(mm, decimals);

/** Sizes, areas, lengths and places in a sentence. */
const SAID_LENGTHS =
  /(?:(?<width>-?\d+(?:\.\d+)?) x )?(?<mm>-?\d+(?:\.\d+)?) mm\b|(?<mm2>\d+(?:\.\d+)?) mm2\b|\b(?<axis>[xyz]) (?<at>-?\d+(?:\.\d+)?)/g;

/** A sentence of a result, which is in mm. @type {(text: string) => string} */
function shownText(text) {
  if (!lengths.inch) return text;
  const inches = (/** @type {string} */ mm) => String(round(Number(mm) / MM_PER_INCH, 4));
  return text.replaceAll(SAID_LENGTHS, (...found) => {
    /** @type {Record<string, string | undefined>} */
    const {width, mm, mm2, axis, at} = found.at(-1);
    if (mm) return `${width ? `${inches(width)} x ` : ''}${inches(mm)} in`;
    return mm2 ? `${round(Number(mm2) / MM_PER_INCH ** 2, 5)} in2` : `${axis} ${inches(at ?? '')}`;
  });
}

/** All fields of lengths that there are. @type {() => HTMLInputElement[]} */
const lengthFields = () => [...document.querySelectorAll('input')].filter(input => input.dataset.length === '1');

/** What is in the fields stays as long as it is. */
function chooseLengths() {
  const inch = element('lengths').value === 'inch';
  if (inch === lengths.inch) return;
  for (const field of lengthFields()) field.value = changedNumbers(field.value, inch ? mmToInch : inchToMm);
  lengths.inch = inch;
  for (const name of document.querySelectorAll('[data-unit]')) name.textContent = lengthName();
  for (const fields of shownFields) fields.show();
  relabelOutlines();
  showStock();
  showTools();
  showOperations();
  showPlanCommand();
  showCheckCommand();
  showElementsCommand();
}
