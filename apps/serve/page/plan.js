// The tab that plans.

/** @type {{ files: ChosenFiles, id: string, unfollow: (() => void) | null, read?: File, part: string, job: JobText | null, jobAddress: string }} */
const plan = { files: listOfFiles('plan', ['part', 'tools', 'machine', 'file'], () => planFilesChanged()), id: '', unfollow: null, part: '', job: null, jobAddress: '' };

/** Files that say their tools themselves. @type {(name: string) => boolean} */
const saysTools = name => ['toml', 'p21', 'stpnc', '238'].includes(kindOf(name));

/** The options as on the command line, with the strategy or without. @type {(which?: { strategy: boolean }) => string} */
function planOptions({ strategy } = { strategy: true }) {
  /** @type {string[]} */
  const words = [];
  /** @type {(name: string, value: string) => void} */
  const add = (name, value) => { if (value.trim()) words.push(`${name} ${quoted(value.trim())}`); };
  add('--tools', plan.files.of('tools')?.name ?? '');
  add('--machine', plan.files.of('machine')?.name ?? '');
  const diameter = element('tool-diameter').value.trim();
  if (diameter) add('--tool', `${element('tool-kind').value}:${diameter}`);
  add('--depth', element('depth').value);
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
  element('plan-go').disabled = element('plan-compare').disabled = !part;
}

function planFilesChanged() {
  const part = plan.files.of('part');
  const diameter = element('tool-diameter');
  if (part && !diameter.dataset.typed) diameter.value = saysTools(part.name) || plan.files.of('tools') ? '' : '6';
  if (part && !plan.id) say(element('plan-status'), `${part.name} is ready to be planned.`);
  showPlanCommand();
  if (part !== plan.read) readPart();
  plan.read = part;
}

/** @type {(state: WaitingState | RunningState) => string} */
function progressText(state) {
  if (state.state === 'waiting') return state.ahead > 0 ? `Waiting; ${state.ahead} before it.` : 'Waiting for its turn.';
  const seconds = Math.round(state.seconds), progress = state.progress;
  if (!progress) return `Reading and preparing … ${seconds} s`;
  if (progress.stage === 'certifying') return `Certifying the program … ${seconds} s`;
  const left = progress.left_s ? `, at most ${progress.left_s} s left` : '';
  return `Planning: ${progress.done} of at most ${progress.most} candidates … ${seconds} s${left}`;
}

/** @type {(state: WaitingState | RunningState) => void} */
function showProgress(state) {
  const bar = element('plan-progress');
  bar.hidden = false;
  const progress = state.state === 'running' ? state.progress : undefined;
  if (progress && progress.most > 0 && progress.stage === 'planning') {
    bar.max = progress.most;
    bar.value = progress.done;
  } else {
    bar.removeAttribute('value');
  }
  say(element('plan-status'), progressText(state));
}

/** @type {[string, string, string][]} */
const downloads = [['program', 'Program', '.ngc'], ['certificate', 'Certificate', '.json'], ['report', 'Report', '.html'], ['picture', 'Picture', '.svg'], ['setup-sheet', 'Set-up sheet', '-setup.html'], ['text', 'Figures', '.txt']];

/**
 * Results of a kind: one, or one for each set-up of the job, as [set-up or '', address].
 * @type {(results: Record<string, string>, kind: string) => [string, string][]}
 */
const resultsOf = (results, kind) => Object.entries(results).filter(([name]) => name === kind || /^-\d+$/.test(name.slice(kind.length)) && name.startsWith(kind))
  .map(([name, address]) => [name.slice(kind.length + 1), address]);

/** @type {(results: Record<string, string>, stem: string) => void} */
function showDownloads(results, stem) {
  const links = downloads.flatMap(([kind, title, ending]) => resultsOf(results, kind).map(([setup, address]) =>
    made('a', setup ? `${title} of set-up ${setup}` : title, { href: address, download: (setup ? `${stem}-${setup}` : stem) + ending })));
  element('plan-downloads').replaceChildren(...links.map(link => {
    const line = made('li');
    line.append(link);
    return line;
  }), ...jobDownload(stem));
}

/** The report, and a choice of set-ups where there are several. @type {(results: Record<string, string>) => void} */
function showReports(results) {
  const reports = resultsOf(results, 'report'), choice = element('plan-setup');
  choice.replaceChildren(...reports.map(([setup, address]) => made('option', `Set-up ${setup}`, { value: address })));
  element('plan-setups').hidden = reports.length < 2;
  showFrame('plan-report', reports[0]?.[1]);
}

/** The job file of what was planned; where the part is a job, it is there already. @type {(stem: string) => HTMLElement[]} */
function jobDownload(stem) {
  URL.revokeObjectURL(plan.jobAddress);
  if (!plan.job) return [];
  plan.jobAddress = URL.createObjectURL(new Blob([plan.job.text], { type: 'application/toml' }));
  const line = made('li');
  line.append(made('a', 'Job file', { href: plan.jobAddress, download: stem + '.toml', id: 'plan-job' }));
  if (plan.job.left.length > 0) line.append(made('span', ` (without ${plan.job.left.join(' ')})`));
  return [line];
}

/** @type {(state: DoneState) => void} */
function showPlan(state) {
  const verdict = element('plan-verdict');
  verdict.textContent = state.verdict;
  verdict.className = `verdict ${state.verdict}`;
  element('plan-summary').textContent = `planned and certified in ${state.seconds.toFixed(1)} s`;
  showDownloads(state.results, stemOf(plan.part));
  fillList(element('plan-messages'), state.messages);
  element('plan-notes').hidden = state.messages.length === 0;
  element('plan-result').hidden = false;
  showReports(state.results);
  say(element('plan-status'), `Done: ${state.verdict}.`);
}

function endPlan() {
  plan.unfollow?.();
  plan.unfollow = null;
  element('plan-progress').hidden = true;
  element('plan-cancel').hidden = true;
  showPlanCommand();
}

/** @type {(state: WorkState) => void} */
function hearPlan(state) {
  if (state.state === 'waiting' || state.state === 'running') return showProgress(state);
  endPlan();
  if (state.state === 'done') return showPlan(state);
  say(element('plan-status'), state.message || 'Cancelled.', state.state === 'failed');
}

/** @type {(id: string) => void} */
function followPlan(id) {
  plan.unfollow = pipeline.follow(id, hearPlan, error => {
    endPlan();
    say(element('plan-status'), error.message, true);
  });
}

/** @type {(event: Event) => Promise<void>} */
async function startPlan(event) {
  event.preventDefault();
  const part = plan.files.of('part');
  if (!part) return;
  if (plan.id) pipeline.drop(plan.id);  // its results are not wanted any more
  plan.id = '';
  element('plan-result').hidden = true;
  element('plan-report').removeAttribute('src');
  element('plan-go').disabled = true;
  say(element('plan-status'), 'Sending the files …');
  const options = planOptions();
  plan.part = part.name;
  plan.job = kindOf(plan.part) === 'toml' ? null : jobOf(plan.part, options);
  try {
    plan.id = await pipeline.plan(plan.files.form(options));
    element('plan-cancel').hidden = false;
    followPlan(plan.id);
  } catch (error) {
    endPlan();
    say(element('plan-status'), wordsOfError(error), true);
  }
}

async function cancelPlan() {
  const id = plan.id;
  plan.id = '';
  endPlan();
  say(element('plan-status'), 'Cancelled.');
  await pipeline.drop(id);
}

function setUpPlan() {
  element('plan-form').addEventListener('submit', startPlan);
  element('plan-form').addEventListener('input', showPlanCommand);
  element('tool-diameter').addEventListener('input', () => { element('tool-diameter').dataset.typed = '1'; });
  element('plan-cancel').addEventListener('click', cancelPlan);
  element('plan-compare').addEventListener('click', startComparison);
  element('plan-setup').addEventListener('change', () => showFrame('plan-report', element('plan-setup').value));
  element('unit').addEventListener('change', readPart);
  showPlanCommand();
}
