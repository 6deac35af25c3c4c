// ---- The program's text: only the lines in sight are elements, so a million lines are no burden.
const ROW = 20, TALLEST = 8e6;  // pixels; browsers draw no element that is much taller
const lineCount = job.program.length;
/** @type {HTMLDivElement[]} */
const rows = [];
const faultLines = new Set(job.faults.map(fault => fault.line));
let selectedLine = 0;

const programHeight = () => Math.min(lineCount * ROW, TALLEST);
/** Pixels of text for each pixel of the scroll bar: 1 unless the text is taller than any element. */
function scrollRatio() {
  const room = programHeight() - by('program').clientHeight;
  return room > 0 ? Math.max(1, (lineCount * ROW - by('program').clientHeight) / room) : 1;
}

function drawProgram() {
  if (lineCount === 0) return;
  const box = by('program'), top = box.scrollTop * scrollRatio(), first = Math.max(0, Math.floor(top / ROW) - 4);
  const needed = Math.min(lineCount - first, Math.ceil(box.clientHeight / ROW) + 8);
  while (rows.length < needed) rows.push(element('div', '', by('program-space')));
  rows.forEach((row, k) => {
    row.hidden = k >= needed;
    if (row.hidden) return;
    const line = first + k + 1;
    row.setAttribute('role', 'option');
    row.id = 'line-' + line;
    row.dataset.line = String(line);
    row.style.top = (first + k) * ROW - top + box.scrollTop + 'px';
    row.textContent = String(line).padStart(String(lineCount).length) + '  ' + job.program[line - 1];
    row.className = faultLines.has(line) ? 'fault' : '';
    row.setAttribute('aria-selected', String(line === selectedLine));
    row.setAttribute('aria-posinset', String(line));
    row.setAttribute('aria-setsize', String(lineCount));
  });
  if (rows.some(row => !row.hidden && row.dataset.line === String(selectedLine)))
    box.setAttribute('aria-activedescendant', 'line-' + selectedLine);
  else box.removeAttribute('aria-activedescendant');
}

/** Selects a line and scrolls to it if it is out of sight. @type {(line: number) => void} */
function selectLine(line) {
  if (lineCount === 0 || line === selectedLine) return;
  selectedLine = line;
  const box = by('program'), ratio = scrollRatio(), y = (line - 1) * ROW - box.scrollTop * ratio;
  if (line > 0 && (y < 0 || y > box.clientHeight - 2 * ROW)) box.scrollTop = Math.max(0, ((line - 1) * ROW - box.clientHeight / 2) / ratio);
  drawProgram();
}

/** Brings the cutter to the end of the line's first move; a line without one leaves it where the line before does. @type {(line: number) => void} */
function goToLine(line) {
  line = Math.max(1, Math.min(lineCount, line));
  let k = line;
  while (k > 0 && moveOfLine[k] < 0) --k;
  if (k > 0) selectMove(moveOfLine[k]);
  else show(0);
  selectLine(line);
}

function listenToProgram() {
  by('program-box').hidden = lineCount === 0;
  by('program-space').style.height = programHeight() + 'px';
  by('program').onscroll = drawProgram;
  by('program').onclick = event => {
    const row = event.target instanceof Element ? event.target.closest('[data-line]') : null;
    if (row instanceof HTMLElement) {
      play(false);
      goToLine(Number(row.dataset.line));
    }
  };
  by('program').onkeydown = event => {
    const page = Math.floor(by('program').clientHeight / ROW) - 1;
    const step = {ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -lineCount, End: lineCount}[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    play(false);
    goToLine(Math.max(1, selectedLine) + step);
  };
}
