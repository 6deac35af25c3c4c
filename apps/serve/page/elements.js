// The tab of design elements on a grid: squares before and after the reduction, tool impact, visit, convergence.

/** What each kind of element is given by, as `clearcut elements` takes it. @type {Record<ElementKind, string>} */
const elementNumbers = {
  pocket: 'X,Y,LENGTH,WIDTH',
  line: 'X1,Y1,X2,Y2',
  arc: 'X1,Y1,X2,Y2,RADIUS,cw',
  hole: 'X,Y,DIAMETER',
  slot: 'X1,Y1,X2,Y2,WIDTH'
};
const elementKinds = /** @type {ElementKind[]} */ (Object.keys(elementNumbers));

/** @type {{ files: ChosenFiles, run: Run, rows: ElementRow[], stem: string, answers: Record<string, string[]> }} */
const elements = {
  files: listOfFiles('elements', ['job'], () => showElementsCommand()),
  rows: [],
  stem: '',
  answers: {},
  run: new Run('elements', {things: 'elements', done: state => showElements(state), ended: () => showElementsCommand()})
};

/** A value that begins with a minus is told from an option. @type {(name: string, value: string) => string} */
const withValue = (name, value) => `${name}${value.startsWith('-') ? '=' : ' '}${quoted(value)}`;

/** An element as an option; '': it has no numbers. @type {(row: { kind: string, numbers: string, tool: string, depth: string }) => string} */
function elementOption({kind, numbers, tool, depth}) {
  const given = numbers.replaceAll(/\s+/g, '');
  return given &&
    withValue(
      `--${kind}`, [given, tool.trim() && `T${tool.trim()}`, depth.trim() && `depth=${depth.trim()}`].filter(word => word).join(':'));
}

/** The options as on the command line; a job says elements, tools and stock itself. @type {() => string} */
function elementsOptions() {
  /** @type {string[]} */
  const words = [];
  /** @type {(name: string, value: string) => void} */
  const add = (name, value) => {
    if (value.trim()) words.push(withValue(name, value.trim()));
  };
  if (!elements.files.of('job')) {
    words.push(...elements.rows.map(
      row => elementOption({kind: row.kind.value, numbers: inMm(row.numbers.value), tool: row.tool.value, depth: inMm(row.depth.value)})));
    for (const [number, input] of [element('elements-tool-1'), element('elements-tool-2')].entries())
      if (input.value.trim()) add('--tool', `endmill:${inMm(input.value)}:T${number + 1}`);
    add('--resolution', inMm(element('elements-resolution').value));
    add('--stock', inMm(element('elements-stock').value).replaceAll(/\s+/g, ''));
  }
  add('--solver', element('elements-solver').value);
  if (element('elements-solver').value) add('--generations', element('elements-generations').value);
  add('--post', element('elements-post').value);
  words.push(...wordsOfAnswers(elements.answers));
  return words.filter(word => word).join(' ');
}

function showElementsCommand() {
  const job = elements.files.of('job');
  element('elements-editor').hidden = Boolean(job);
  element('elements-generations-box').hidden = !element('elements-solver').value;
  const written = Boolean(job) || elements.rows.some(row => row.numbers.value.trim());
  element('elements-command').textContent =
    written ? ['clearcut elements', job && quoted(job.name), elementsOptions(), '-o program.ngc'].filter(word => word).join(' ') : '';
  element('elements-go').disabled = !written;
}

/** @type {(kind?: ElementKind, numbers?: string, depth?: string) => void} */
function addElement(kind = 'pocket', numbers = '', depth = '') {
  const line = made('tr'), number = elements.rows.length + 1;
  /** @type {(what: string, attributes: Record<string, string | number>) => HTMLInputElement} */
  const input = (what, attributes) =>
    made('input', '', {'aria-label': `${what} of element ${number}`, spellcheck: 'false', autocomplete: 'off', ...attributes});
  const row = {
    line,
    kind: made('select', '', {'aria-label': `Kind of element ${number}`}),
    numbers: input('Numbers', {'data-length': '1'}),
    tool: input('Tool', {inputmode: 'numeric'}),
    depth: input('Depth', {inputmode: 'decimal', 'data-length': '1'})
  };
  const remove = made('button', '×', {type: 'button', 'title': 'Remove', 'aria-label': `Remove element ${number}`});
  fillSelect(row.kind, elementKinds);
  row.kind.value = kind;
  row.numbers.value = numbers;
  row.tool.value = '1';
  row.depth.value = depth;
  const hint = () => {
    row.numbers.placeholder = elementNumbers[elementKinds[row.kind.selectedIndex]] ?? '';
  };
  row.kind.addEventListener('change', hint);
  remove.addEventListener('click', () => removeElement(row));
  hint();
  for (const one of [row.kind, row.numbers, row.tool, row.depth, remove]) {
    const cell = made('td');
    cell.append(one);
    line.append(cell);
  }
  elements.rows.push(row);
  theOne('tbody', element('elements-table')).append(line);
}

/** @type {(row: ElementRow) => void} */
function removeElement(row) {
  elements.rows = elements.rows.filter(one => one !== row);
  row.line.remove();
  element('elements-add').focus();
  showElementsCommand();
}

/** @type {(state: DoneState) => Promise<void>} */
async function showElements(state) {
  showVerdict('elements', state);
  element('elements-downloads').replaceChildren(...downloadLines(state.results, elements.stem));
  showFrame('elements-report', state.results.report);
  element('elements-text').textContent = '';
  element('elements-text').textContent = await textAt(state.results.text);
}

/** @type {(event: Event) => Promise<void>} */
async function startElements(event) {
  event.preventDefault();
  elements.stem = stemOf(elements.files.of('job')?.name ?? 'elements');
  element('elements-report').removeAttribute('src');
  await elements.run.start(elements.files.form(elementsOptions()));
}

function setUpElements() {
  addElement('pocket', '0,0,40,30', '3');
  element('elements-form').addEventListener('submit', startElements);
  element('elements-form').addEventListener('input', showElementsCommand);
  element('elements-add').addEventListener('click', () => {
    addElement();
    elements.rows.at(-1)?.kind.focus();
    showElementsCommand();
  });
  showElementsCommand();
}
