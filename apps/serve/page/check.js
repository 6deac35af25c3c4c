// The tab that checks a program of any CAM against the part it is for.

/** @type {{ files: ChosenFiles }} */
const check = { files: listOfFiles('check', ['program', 'part', 'file'], () => showCheckCommand()) };
const mostLines = 20000;  // of a program that are shown

/** @type {() => string} */
function checkOptions() {
  const words = [];
  /** @type {(name: string, value: string) => void} */
  const add = (name, value) => { if (value.trim()) words.push(`${name} ${quoted(value.trim())}`); };
  const diameter = element('check-diameter').value.trim(), alone = !check.files.of('part');
  if (diameter) add('--tool', `${element('check-kind').value}:${inMm(diameter)}`);
  if (alone) add('--stock', inMm(element('check-stock').value));
  else add('--depth', inMm(element('check-depth').value));
  add('--dialect', element('dialect').value);
  words.push(element('check-options').value.trim());
  return words.filter(word => word).join(' ');
}

/** What the check can speak of. @type {(program: File | undefined, part: File | undefined, names: string[]) => string} */
function whatIsJudged(program, part, names) {
  if (!program && names.length > 0) return `${names.join(', ')}: no program by the name's ending; say in the list which file is the program, or choose one more.`;
  if (!program) return 'Choose a program, and its part if there is one.';
  return part ? 'The program is checked against its part.'
    : 'Without a part: rapids, plunges, depths, engagement, limits, feeds and spindle are checked in the stock; what is left and what is gouged cannot be said.';
}

function showCheckCommand() {
  const program = check.files.of('program'), part = check.files.of('part');
  const words = ['clearcut', 'verify', program && quoted(program.name), part && `--part ${quoted(part.name)}`, checkOptions()];
  element('check-command').textContent = program ? words.filter(word => word).join(' ') : '';
  element('check-go').disabled = !program;
  element('check-depth-box').hidden = !part;
  element('check-stock-box').hidden = Boolean(part);
  if (element('check-result').hidden) say(element('check-status'), whatIsJudged(program, part, check.files.entries.map(entry => entry.file.name)));
}

/** Brings the report above to the line, and the list below, which may not be there. @type {(number: number) => void} */
function showLine(number) {
  const frame = element('check-report'), list = element('check-lines'), line = list.children[number - 1];
  frame.src = `${frame.src.replace(/#.*/, '')}#line=${number}`;
  if (line instanceof HTMLElement) list.scrollTop = line.offsetTop - list.offsetTop - list.clientHeight / 2;
}

/** @type {(text: string, line: number, kind: string) => HTMLElement} */
function faultLine(text, line, kind) {
  const item = made('li', text, { class: kind });
  if (line > 0) {
    const button = made('button', `Line ${line}`, { type: 'button' });
    button.addEventListener('click', () => showLine(line));
    item.append(button);
  }
  return item;
}

/** @type {(program: File, faults: CertificateFault[]) => Promise<void>} */
async function showProgram(program, faults) {
  const lines = (await program.text()).trimEnd().split(/\r?\n/);
  const marked = new Set(faults.map(fault => fault.line));
  const shown = lines.length <= mostLines;
  element('check-lines').hidden = element('check-lines-title').hidden = !shown;
  if (shown) element('check-lines').replaceChildren(...lines.map((text, i) => made('li', text || ' ', marked.has(i + 1) ? { class: 'fault' } : {})));
}

/** @type {(state: DoneState, program: File) => void} */
function showCheck(state, program) {
  const verdict = element('check-verdict');
  verdict.textContent = state.verdict;
  verdict.className = `verdict ${state.verdict.split(' ')[0]}`;
  const faults = state.certificate?.faults ?? [];
  const conditions = (state.certificate?.conditions ?? []).filter(one => !one.met_by);
  element('check-summary').textContent = faults.length === 0 ? 'no fault found' : `${faults.length} ${faults.length === 1 ? 'fault' : 'faults'}`;
  element('check-faults').replaceChildren(
    ...faults.map(fault => faultLine(fault.text, fault.line, 'fault')),
    ...conditions.map(one => faultLine(one.text, one.line, 'condition')));
  fillList(element('check-messages'), state.messages);
  element('check-notes').hidden = state.messages.length === 0;
  element('check-text').textContent = state.text ?? '';
  element('check-result').hidden = false;
  showFrame('check-report', state.results.report);
  say(element('check-status'), `Done: ${state.verdict}.`);
  showProgram(program, faults);
}

/** @type {(event: Event) => Promise<void>} */
async function startCheck(event) {
  event.preventDefault();
  const program = check.files.of('program');
  if (!program) return;
  element('check-result').hidden = true;
  element('check-go').disabled = true;
  say(element('check-status'), 'Checking …');
  try {
    const state = await pipeline.check(check.files.form(checkOptions()));
    if (state.state === 'done') showCheck(state, program);
    else say(element('check-status'), state.state === 'failed' && state.message || 'The check was broken off.', true);
  } catch (error) {
    say(element('check-status'), wordsOfError(error), true);
  }
  element('check-go').disabled = false;
}

function setUpCheck() {
  element('check-form').addEventListener('submit', startCheck);
  element('check-form').addEventListener('input', showCheckCommand);
  showCheckCommand();
}
