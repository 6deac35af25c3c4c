// The tab that plans.

/** @type {{ files: ChosenFiles, run: Run, read?: File, part: string, job: JobText | null, jobAddress: string }} */
const plan = {
  files: listOfFiles('plan', ['part', 'tools', 'machine', 'file'], () => planFilesChanged()),
  run: new Run('plan', {done: state => showPlan(state), ended: () => showPlanCommand()}),
  part: '',
  job: null,
  jobAddress: ''
};

/** Files that say their tools themselves. @type {(name: string) => boolean} */
const saysTools = name => ['toml', 'p21', 'stpnc', '238'].includes(kindOf(name));

/** The options as on the command line, with the strategy or without. @type {(which?: { strategy: boolean }) => string} */
function planOptions({strategy} = {
  strategy: true
}) {
  /** @type {string[]} */
  const words = [];
  /** @type {(name: string, value: string) => void} */
  const add = (name, value) => {
    if (value.trim()) words.push(`${name} ${quoted(value.trim())}`);
  };
  add('--tools', plan.files.of('tools')?.name ?? '');
  add('--machine', plan.files.of('machine')?.name ?? '');
  const diameter = element('tool-diameter').value.trim();
  if (diameter) add('--tool', `${element('tool-kind').value}:${inMm(diameter)}`);
  add('--depth', inMm(element('depth').value));
  add('--unit', element('unit').value);
  words.push(...outlineOptions());
  add('--material', element('material').value);
  if (strategy) add('--strategy', element('strategy').value);
  add('--post', element('post').value);
  words.push(element('plan-options').value.trim());
  return words.filter(word => word).join(' ');
}

function showPlanCommand() {
  const part = plan.files.of('part');
  element('plan-command').textContent = part ? `clearcut plan ${quoted(part.name)} ${planOptions()} -o program.ngc` : '';
  element('plan-go').disabled = !part;
  element('compare-go').disabled = !part || comparing.isOn;
}

/** Where none of the files is a part. @type {(names: string[]) => string} */
const whatIsMissing = names => names.length === 0 ?
  'Choose a part.' :
  `${names.join(', ')}: no part by the name's ending; choose a DXF, SVG, ${
    pipeline.noSolids ? '' : 'STEP, '}STEP-NC, Gerber, Excellon, JSON or TOML file, or say in the list which file is the part.`;

function planFilesChanged() {
  const part = plan.files.of('part');
  const diameter = element('tool-diameter');
  if (part && !diameter.dataset.typed)
    diameter.value = saysTools(part.name) || plan.files.of('tools') ? '' : String(lengths.inch ? mmToInch(6) : 6);
  if (part !== plan.read) {
    plan.run.forget();
    forgetComparison();
  }
  if (!part) say(element('plan-status'), whatIsMissing(plan.files.entries.map(entry => entry.file.name)), plan.files.entries.length > 0);
  showPlanCommand();
  if (part !== plan.read) readNewPart();
  plan.read = part;
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
  const stem = stemOf(plan.part);
  element('plan-downloads').replaceChildren(...downloadLines(state.results, stem), ...jobDownload(stem));
  showReports(state.results);
}

/** @type {(event: Event) => Promise<void>} */
async function startPlan(event) {
  event.preventDefault();
  const part = plan.files.of('part');
  if (!part) return;
  element('plan-report').removeAttribute('src');
  element('compare-result').open = false;  // what is planned now stands in sight
  const options = planOptions();
  plan.part = part.name;
  plan.job = kindOf(plan.part) === 'toml' ? null : jobOf(plan.part, options);
  await plan.run.start(plan.files.form(options));
}

function setUpPlan() {
  element('plan-form').addEventListener('submit', startPlan);
  element('plan-form').addEventListener('input', showPlanCommand);
  element('tool-diameter').addEventListener('input', () => {
    element('tool-diameter').dataset.typed = '1';
  });
  element('compare-go').addEventListener('click', startComparison);
  element('plan-setup').addEventListener('change', () => showFrame('plan-report', element('plan-setup').value));
  for (const input of [element('unit'), element('depth'), element('outlines')]) input.addEventListener('change', () => readPart());
  showPlanCommand();
}
