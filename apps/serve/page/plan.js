// The tab that plans: what the command is asked, by everything that was said, again after each change.

/** `isAwaited`: the machining is shown once it is there. @type {{ files: ChosenFiles, run: Run, read?: File, part: string, job: JobText | null, jobAddress: string, due: number, asked: string, isAwaited: boolean, isFilling: boolean }} */
const plan = {
  files: listOfFiles('plan', ['part', 'tools', 'machine', 'file'], () => planFilesChanged()),
  run: new Run('plan', {done: state => showPlan(state), ended: () => showPlanCommand()}),
  part: '',
  job: null,
  jobAddress: '',
  due: 0,
  asked: '',
  isAwaited: false,
  isFilling: false
};

/** Files that say their tools themselves. @type {(name: string) => boolean} */
const saysTools = name => ['toml', 'p21', 'stpnc', '238'].includes(kindOf(name));
/** @type {(now: Project, role: FileRole) => File | undefined} */
const fileOf = (now, role) => now.files.find(one => one.role === role)?.file;
const isJobName = (/** @type {string} */ name) => kindOf(name) === 'toml';

/** The options as on the command line, with the strategy or without. @type {(which?: { strategy: boolean }) => string} */
function planOptions({strategy} = {
  strategy: true
}) {
  const {now} = project, library = fileOf(now, 'tools'), machine = fileOf(now, 'machine');
  const {'--machine': said, ...answers} = now.answers;
  const named = machine ? [machine.name] : said;
  if (!strategy) delete answers['--strategy'];
  return [
    ...library ? [optionWord('--tools', library.name)] : [], ...named ? [optionWord('--machine', named[0])] : [], ...toolOptions(now),
    ...outlineOptions(now), ...wordsOfAnswers(answers)
  ].join(' ');
}

/** What only a job can say: stock, operations, their order. @type {(now: Project) => JobMore | null} */
function moreOfJob(now) {
  const rows = operationRows(part.features, now.sequence), operations = operationTables(rows, now.operations),
        sequence = namesInSequence(rows, now.sequence);
  const stock = stockTable(now.stock);
  return operations || stock || sequence.length > 0 ? {operations, stock, sequence} : null;
}

/** [stock] of a job; '': none is said. @type {(stock: StockSaid) => string} */
function stockTable({margin, bottom, top}) {
  if (!bottom) return '';
  return `[stock]\nmargin = ${margin || '0'}\nz = [${bottom}, ${top || '0'}]\n`;
}

/** The text of somebody's job with what was said here. @type {(text: string, more: JobMore) => string} */
function jobWith(text, {operations, sequence}) {
  const line = sequence.length > 0 ? `sequence = [${sequence.map(tomlText).join(', ')}]\n` : '';
  const isThere = /^\[plan\][^\n]*\n/m,
        withLine = !line ? text :
    isThere.test(text)   ? text.replace(isThere, found => found + line) :
                           `${text}\n[plan]\n${line}`;
  return operations ? `${withLine.trimEnd()}\n\n${operations}` : withLine;
}

/** What the command is asked: the part as it is, or a job of it where something was said that only a job can say. @type {(options: string) => Promise<PlanAsked | null>} */
async function planAsked(options) {
  const {now} = project, chosen = fileOf(now, 'part'), more = moreOfJob(now);
  if (!chosen) return null;
  if (!more) return {input: chosen.name, options, files: []};
  if (isJobName(chosen.name))
    return {input: `page-${chosen.name}`, options, files: [new File([jobWith(await chosen.text(), more)], `page-${chosen.name}`)]};
  const {text, left} = jobOf(chosen.name, options, more), stem = stemOf(chosen.name);
  const name = now.files.some(one => one.file.name === `${stem}.toml`) ? `${stem}-job.toml` : `${stem}.toml`;
  return {input: name, options: left.join(' '), files: [new File([text], name)]};
}

/** As a form for the server. @type {(asked: PlanAsked) => FormData} */
function formOfPlan({input, options, files}) {
  const form = new FormData();
  form.append('options', options);
  for (const file of [...files, ...project.now.files.map(one => one.file)])
    form.append(file.name === input ? 'part' : 'file', file, file.name);
  return form;
}

function showPlanCommand() {
  const chosen = fileOf(project.now, 'part');
  const isJob = chosen && moreOfJob(project.now) !== null, input = isJob ? `${stemOf(chosen.name)}.toml` : chosen?.name ?? '';
  element('plan-command').textContent = !chosen ? '' :
    isJob                                       ? `clearcut plan ${quoted(input)} -o program.ngc  # the job file above` :
                                                  `clearcut plan ${quoted(input)} ${planOptions()} -o program.ngc`;
  element('plan-go').disabled = !chosen;
  element('compare-go').disabled = !chosen || comparing.isOn;
  element('project-save').disabled = !chosen;
  element('undo').disabled = project.past.length === 0;
  element('redo').disabled = project.future.length === 0;
}

/** Where none of the files is a part. @type {(names: string[]) => string} */
const whatIsMissing = names => names.length === 0 ?
  'Choose a part.' :
  `${names.join(', ')}: no part by the name's ending; choose a DXF, SVG, ${
    pipeline.noSolids ? '' : 'STEP, '}STEP-NC, Gerber, Excellon, JSON or TOML file, or say in the list which file is the part.`;

/** Files that nothing names. @type {(now: Project) => string[]} */
function unusedFiles(now) {
  const chosen = fileOf(now, 'part'), words = Object.values(now.answers).flat();
  if (!chosen || isJobName(chosen.name)) return [];
  const hasBits = kindOf(fileOf(now, 'tools')?.name ?? '') === 'fctl';
  return now.files.filter(one => one.role === 'file' && !words.includes(one.file.name) && !(hasBits && kindOf(one.file.name) === 'fctb'))
    .map(one => one.file.name);
}

/** The list of files was changed by somebody. */
function planFilesChanged() {
  if (plan.isFilling) return;
  const opened = plan.files.entries.find(one => one.file.name.endsWith(projectEnding));
  if (opened) {
    openProject(opened.file);
    return;
  }
  const before = fileOf(project.now, 'part'), now = plan.files.of('part'), isOther = before && now !== before;
  // What was said of another part means nothing to this one; tools, machine and the like stay.
  const forgotten = isOther ?
    {given: [], outlines: {}, operations: {}, sequence: [], stock: emptyProject().stock, answers: withoutPart(project.now.answers)} :
    {};
  change('', {files: [...plan.files.entries], ...forgotten});
}

/** Answers that hold for any part. @type {(answers: Record<string, string[]>) => Record<string, string[]>} */
const withoutPart = answers =>
  Object.fromEntries(Object.entries(answers).filter(([name]) => !readNames.has(name) && jobKeys[name]?.table !== 'part'));

/** @type {(file: File) => Promise<void>} */
async function openProject(file) {
  try {
    replaceProject(projectOf(file.name, await file.text()));
    say(element('plan-status'), `${file.name} is open.`);
  } catch (error) {
    fillFiles();
    say(element('plan-status'), wordsOfError(error), true);
  }
}

async function saveProject() {
  const chosen = fileOf(project.now, 'part'), asked = await planAsked(planOptions());
  if (chosen && asked) giveFile(stemOf(chosen.name) + projectEnding, await projectText(project.now, asked), 'application/json');
}

/** The list of files as the project has it. */
function fillFiles() {
  plan.isFilling = true;
  plan.files.entries = project.now.files.map(one => ({...one}));
  plan.files.show();
  plan.isFilling = false;
}

/** Everything that shows the project, after a change. @type {(before: Project) => void} */
function showProject(before) {
  const {now} = project, chosen = fileOf(now, 'part'), isNewPart = chosen !== plan.read;
  if (now.files !== before.files) fillFiles();
  const unused = unusedFiles(now);
  element('unused').hidden = unused.length === 0;
  element('unused').textContent = `Not used: ${unused.join(', ')}. Say in the list what ${unused.length === 1 ? 'it is' : 'they are'} for.`;
  const names = Object.keys({...before.answers, ...now.answers}).filter(name => before.answers[name] !== now.answers[name]);
  planFields?.show(now.files === before.files ? names : undefined);
  showStock();
  showCards();
  showMarks();
  showTools();
  showOperations();
  showSaidOutlines();
  colourDrawing();
  showPlanCommand();
  if (isNewPart) {
    plan.read = chosen;
    plan.run.cancel();
    element('plan-result').hidden = true;
    forgetComparison();
    if (!chosen) say(element('plan-status'), whatIsMissing(now.files.map(one => one.file.name)), now.files.length > 0);
    readNewPart();
  } else if (chosen && readOptions() !== part.readBy) {
    readPart();
  } else if (chosen && part.isReady) {
    planSoon();
  }
}

/** Plans a moment later, so that changes that follow each other at once give one plan; the one before is cancelled. */
function planSoon() {
  clearTimeout(plan.due);
  if (!element('plan-again').checked) return;
  plan.due = setTimeout(() => {
    startPlan(true).catch(error => say(element('plan-status'), wordsOfError(error), true));
  }, 150);
}

/** The report, and a choice of set-ups where there are several. @type {(results: Record<string, string>) => void} */
function showReports(results) {
  const reports = resultsOf(results, 'report'), choice = element('plan-setup');
  choice.replaceChildren(...reports.map(([setup, address]) => made('option', `Set-up ${setup}`, {value: address})));
  element('plan-setups').hidden = reports.length < 2;
  showFrame('plan-report', reports[0]?.[1]);
}

/** The job file of what was planned; where the part is a job, it is there already. @type {(stem: string) => HTMLElement[]} */
function jobDownload(stem) {
  URL.revokeObjectURL(plan.jobAddress);
  if (!plan.job) return [];
  plan.jobAddress = URL.createObjectURL(new Blob([plan.job.text], {type: 'application/toml'}));
  const line = made('li');
  line.append(made('a', 'Job file', {href: plan.jobAddress, download: stem + '.toml', id: 'plan-job'}));
  if (plan.job.left.length > 0) line.append(made('span', ` (without ${plan.job.left.join(' ')})`));
  return [line];
}

/** @type {(state: DoneState) => void} */
function showPlan(state) {
  showVerdict('plan', state);
  element('plan-status').classList.add('done');
  element('plan-result').classList.remove('stale');
  const stem = stemOf(plan.part);
  element('plan-downloads').replaceChildren(...downloadLines(state.results, stem), ...jobDownload(stem));
  showReports(state.results);
  if (plan.isAwaited && element('plan').dataset.middle === 'drawing') showMiddle('machining');
  plan.isAwaited = false;
}

/** `isAgain`: after a change, and only where it is another question. @type {(isAgain?: boolean) => Promise<void>} */
async function startPlan(isAgain = false) {
  clearTimeout(plan.due);
  const options = planOptions(), asked = await planAsked(options), chosen = fileOf(project.now, 'part');
  if (!chosen || !asked) return;
  const question = JSON.stringify(
    [asked.input, asked.options, await Promise.all(asked.files.map(file => file.text())), project.now.files.map(one => one.file.name)]);
  if (isAgain && question === plan.asked && (plan.run.isOn || plan.run.id)) return;
  plan.asked = question;
  plan.part = chosen.name;
  plan.job = isJobName(plan.part) ? null : jobOf(plan.part, options, moreOfJob(project.now));
  element('plan-result').classList.add('stale');
  if (!isAgain || !plan.run.id && element('plan').dataset.middle === 'drawing') showMachining();
  await plan.run.start(formOfPlan(asked), isAgain);
}

/** The machining, or, while there is none yet, the part as it was read until then. */
function showMachining() {
  plan.isAwaited = !plan.run.id && !element('drawing-box').hidden;
  showMiddle(plan.isAwaited ? 'drawing' : 'machining');
}

/** What is seen in the middle: the drawing, the machining once there is one, or strategies that are compared. @type {(which: MiddleName) => void} */
function showMiddle(which) {
  element('plan').dataset.middle = which;
  for (const one of /** @type {const} */ (['drawing', 'machining', 'compare']))
    element(`show-${one}`).setAttribute('aria-pressed', String(one === which));
  if (which === 'drawing') sizeNumbers();
}

function showStock() {
  const {stock} = project.now, chosen = fileOf(project.now, 'part'), isJob = chosen !== undefined && isJobName(chosen.name);
  for (const name of /** @type {const} */ (['margin', 'bottom', 'top'])) {
    if (!isTypedIn(element(`stock-${name}`)))
      element(`stock-${name}`).value = lengths.inch ? changedNumbers(stock[name], mmToInch) : stock[name];
    element(`stock-${name}`).disabled = isJob;
  }
}

/** What a closed card says: the answers within it. */
function showCards() {
  const {now} = project, machine = fileOf(now, 'machine');
  element('plan-form').classList.toggle('has-part', fileOf(now, 'part') !== undefined);
  for (const place of fieldPlaces) {
    if (place === 'tools') continue;
    const fields = planFields?.fields.filter(({option}) => placeOf(option) === place && now.answers[nameOfOption(option)]) ?? [];
    const words = fields.map(({option}) => [option.value && !option.place?.choice ? labelOf(option) :
                                 option.value                                     ? '' :
                                                                                    labelOf(option),
                               ...(now.answers[nameOfOption(option)] ?? []).map(value => shownAnswer(option, value))]
                                             .filter(word => word)
                                             .join(' '));
    if (place === 'machine') words.unshift(...now.answers['--post'] ? [] : ['linuxcnc'], ...machine ? [machine.name] : []);
    if (place === 'stock' && now.stock.bottom) words.unshift(`Z ${now.stock.bottom} to ${now.stock.top || '0'}`);
    element(`${place}-now`).textContent = words.join(', ');
  }
}

function setUpStock() {
  for (const name of /** @type {const} */ (['margin', 'bottom', 'top'])) {
    element(`stock-${name}`).addEventListener('change', () => change(`stock ${name}`, {
      stock: {...project.now.stock, [name]: inMm(element(`stock-${name}`).value)}
    }));
  }
}

/** Fields of the options' table; null: the table has not come yet. @type {OptionFields | null} */
let planFields = null;
/** Options that the page has places of its own for. */
const ownPlaces = ['--op', '--tool', '--tools'];

/** @type {(options: CommandOption[]) => void} */
function setUpPlanFields(options) {
  planFields = new OptionFields({
    prefix: 'option-',
    files: () => project.now.files.filter(one => one.role !== 'part').map(one => one.file.name),
    values: name => project.now.answers[name],
    say: answer
  });
  const usable =
    options.filter(one => !one.positional && !['Output', 'Help'].includes(one.group) && !ownPlaces.includes(nameOfOption(one)));
  for (const place of fieldPlaces) planFields.put(usable.filter(one => placeOf(one) === place), element(`fields-${place}`));
  operationOptions = options.filter(one => one.place?.operations);
  shownFields.push(planFields);
}

/** An example that comes with the page. */
function takeExample() {
  replaceProject({
    ...emptyProject(project.now.tools),
    files: [{file: new File([exampleDrawing()], 'example.dxf'), role: 'part'}],
    answers: {'--material': ['softwood'], '--tabs': ['4']}
  });
}

/** @type {(event: KeyboardEvent) => void} */
function historyByKey(event) {
  if (!(event.ctrlKey || event.metaKey) || event.altKey || element('plan').hidden) return;
  const key = event.key.toLowerCase(), isRedo = key === 'y' || key === 'z' && event.shiftKey;
  if (key === 's') {
    event.preventDefault();
    saveProject();
  } else if (isRedo || key === 'z') {
    event.preventDefault();
    (isRedo ? redo : undo)();
  }
}

function setUpPlan() {
  element('plan-form').addEventListener('submit', event => {
    event.preventDefault();
    startPlan();
  });
  project.shown = showProject;
  element('compare-go').addEventListener('click', startComparison);
  element('plan-setup').addEventListener('change', () => showFrame('plan-report', element('plan-setup').value));
  element('undo').addEventListener('click', undo);
  element('redo').addEventListener('click', redo);
  element('project-new').addEventListener('click', () => replaceProject(emptyProject(project.now.tools)));
  element('project-save').addEventListener('click', saveProject);
  element('example-go').addEventListener('click', takeExample);
  element('show-drawing').addEventListener('click', () => {
    plan.isAwaited = false;
    showMiddle('drawing');
  });
  element('show-compare').addEventListener('click', () => showMiddle('compare'));
  element('show-machining').addEventListener('click', () => showMiddle('machining'));
  element('plan-again').addEventListener('change', planSoon);
  document.addEventListener('keydown', historyByKey);
  setUpStock();
  showMiddle('drawing');
  showPlanCommand();
}

/** What was worked on last. */
async function goOn() {
  const found = await keptProject();
  // Whoever was faster than the browser's store has begun something else.
  if (found && project.now.files.length === 0) project.now = found;
  projectChanged(emptyProject());
}
