// The tab that checks a program of any CAM against the part it is for.

/** @type {{ files: ChosenFiles, run: Run, program?: File, due: number, answers: Record<string, string[]> }} */
const check = {
  files: listOfFiles('check', ['program', 'part', 'file'],
    () => {
      check.run.forget();
      showCheckCommand();
      checkSoon();
    }),
  answers: {},
  due: 0,
  run: new Run('check', {certifying: 'Checking the program', done: state => showCheck(state), ended: () => showCheckCommand()})
};
const mostLines = 20000;  // of a program that are shown

/** @type {() => string} */
function checkOptions() {
  const words = [];
  /** @type {(name: string, value: string) => void} */
  const add = (name, value) => {
    if (value.trim()) words.push(`${name} ${quoted(value.trim())}`);
  };
  const diameter = element('check-diameter').value.trim(), alone = !check.files.of('part');
  if (diameter) add('--tool', `${element('check-kind').value}:${inMm(diameter)}`);
  if (alone) add('--stock', inMm(element('check-stock').value));
  else add('--depth', inMm(element('check-depth').value));
  add('--dialect', element('dialect').value);
  words.push(...wordsOfAnswers(check.answers));
  return words.filter(word => word).join(' ');
}

/** What the check can speak of. @type {(program: File | undefined, part: File | undefined, names: string[]) => string} */
function whatIsJudged(program, part, names) {
  if (!program && names.length > 0)
    return `${names.join(', ')}: no program by the name's ending; say in the list which file is the program, or choose one more.`;
  if (!program) return 'Choose a program, and its part if there is one.';
  return part ?
    'The program is checked against its part.' :
    'Without a part: rapids, plunges, depths, engagement, limits, feeds and spindle are checked in the stock; what is left and what is gouged cannot be said.';
}

function showCheckCommand() {
  const program = check.files.of('program'), part = check.files.of('part');
  const words = ['clearcut', 'verify', program && quoted(program.name), part && `--part ${quoted(part.name)}`, checkOptions()];
  element('check-command').textContent = program ? words.filter(word => word).join(' ') : '';
  element('check-go').disabled = !program;
  element('check-depth-box').hidden = !part;
  element('check-stock-box').hidden = Boolean(part);
  if (element('check-result').hidden && !check.run.isOn)
    say(element('check-status'), whatIsJudged(program, part, check.files.entries.map(entry => entry.file.name)));
}

/** Brings the report above to the line, and the list below, which may not be there. @type {(number: number) => void} */
function showLine(number) {
  const frame = element('check-report'), list = element('check-lines'), line = list.children[number - 1];
  frame.src = `${frame.src.replace(/#.*/, '')}#line=${number}`;
  if (line instanceof HTMLElement) list.scrollTop = line.offsetTop - list.offsetTop - list.clientHeight / 2;
}

/** @type {(text: string, line: number, kind: string) => HTMLElement} */
function faultLine(text, line, kind) {
  const item = made('li', shownText(text), {class: kind});
  if (line > 0) {
    const button = made('button', `Line ${line}`, {type: 'button'});
    button.addEventListener('click', () => showLine(line));
    item.append(button);
  }
  return item;
}

/** @type {(program: string, faults: CertificateFault[]) => void} */
function showProgram(program, faults) {
  const lines = program.trimEnd().split(/\r?\n/);
  const marked = new Set(faults.map(fault => fault.line));
  const shown = lines.length <= mostLines;
  element('check-lines').hidden = element('check-lines-title').hidden = !shown;
  if (shown)
    element('check-lines').replaceChildren(...lines.map((text, i) => made('li', text || ' ', marked.has(i + 1) ? {class: 'fault'} : {})));
}

/** @type {(certificate: Certificate) => void} */
function showFaults({faults, conditions}) {
  element('check-summary').textContent =
    faults.length === 0 ? 'no fault found' : `${faults.length} ${faults.length === 1 ? 'fault' : 'faults'}`;
  element('check-faults')
    .replaceChildren(...faults.map(fault => faultLine(fault.text, fault.line, 'fault')),
      ...conditions.filter(one => !one.met_by).map(one => faultLine(one.text, one.line, 'condition')));
}

/** Verdict, faults and program appear together, once all of them have come. @type {(state: DoneState) => Promise<void>} */
async function showCheck(state) {
  const verdict = element('check-verdict'), program = check.program, id = check.run.id;
  element('check-result').hidden = true;
  const texts = await Promise.all([textAt(state.results.certificate), textAt(state.results.text), program?.text() ?? '']);
  if (check.run.id !== id) return;
  /** @type {Certificate} */
  const certificate = JSON.parse(texts[0]);
  element('check-result').hidden = false;
  verdict.textContent = state.verdict;
  verdict.className = `verdict ${state.verdict.split(' ')[0]}`;
  showFaults(certificate);
  fillList(element('check-messages'), state.messages);
  element('check-notes').hidden = state.messages.length === 0;
  element('check-downloads').replaceChildren(...downloadLines(state.results, stemOf(program?.name ?? 'program')));
  showFrame('check-report', state.results.report);
  showProgram(texts[2], certificate.faults);
  element('check-text').textContent = texts[1];
  say(element('check-status'), `Done: ${state.verdict}.`);
}

/** Checks a moment later, so that changes that follow each other at once give one check. */
function checkSoon() {
  clearTimeout(check.due);
  if (!check.files.of('program')) return;
  check.due = setTimeout(() => {
    startCheck().catch(error => say(element('check-status'), wordsOfError(error), true));
  }, 300);
}

/** @type {(event?: Event) => Promise<void>} */
async function startCheck(event) {
  event?.preventDefault();
  clearTimeout(check.due);
  check.program = check.files.of('program');
  if (!check.program) return;
  await check.run.start(check.files.form(checkOptions()), event === undefined);
}

function setUpCheck() {
  element('check-form').addEventListener('submit', startCheck);
  element('check-form').addEventListener('input', showCheckCommand);
  element('check-form').addEventListener('change', event => {
    // Files tell of themselves.
    if (!(event.target instanceof HTMLInputElement && event.target.type === 'file')) checkSoon();
  });
  showCheckCommand();
}
