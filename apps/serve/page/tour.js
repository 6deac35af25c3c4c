// The tab that orders points: how the best value falls while the search goes on, its bound, and the tour.

/** @type {{ files: ChosenFiles, run: Run, samples: TourSample[], stem: string, answers: Record<string, string[]> }} */
const tour = {
  files: listOfFiles('tour', ['points'], () => showTourCommand()),
  samples: [],
  answers: {},
  stem: '',
  run: new Run('tour', {progress: state => hearTour(state), done: state => showTour(state), ended: () => showTourCommand()})
};

/** The options as on the command line. @type {() => string} */
function tourOptions() {
  /** @type {string[]} */
  const words = [];
  /** @type {(name: string, value: string) => void} */
  const add = (name, value) => {
    if (value.trim()) words.push(`${name} ${quoted(value.trim())}`);
  };
  add('--objective', element('tour-objective').value);
  add('--solver', element('tour-solver').value);
  add('--time', element('tour-time').value);
  add('--seed', element('tour-seed').value);
  words.push(element('tour-shape').value, ...wordsOfAnswers(tour.answers));
  return words.filter(word => word).join(' ');
}

/** A lattice as the command takes it; '': it is none. @type {(text: string) => string} */
const latticeOf = text => /^\s*([1-9]\d{0,3})\s*[x×*]\s*([1-9]\d{0,3})\s*$/i.exec(text)?.slice(1).join('x') ?? '';

function showTourCommand() {
  const points = tour.files.of('points'), lattice = latticeOf(element('tour-lattice').value),
        input = points ? quoted(points.name) : lattice;
  element('tour-lattice').disabled = Boolean(points);
  element('tour-lattice').setAttribute('aria-invalid', String(!points && !lattice && element('tour-lattice').value.trim() !== ''));
  element('tour-command').textContent = input ? `clearcut tour ${input} ${tourOptions()} --json tour.json --svg tour.svg` : '';
  element('tour-go').disabled = !input;
}

/**
 * A curve that falls in steps, in a box of 1000 x 1000 with y downward: each value holds until the next, the last until `until` seconds.
 * @type {(samples: TourSample[], until: number, low: number, high: number) => string}
 */
function convergencePath(samples, until, low, high) {
  /** @type {(seconds: number) => number} */
  const x = seconds => Math.round(until > 0 ? 1000 * Math.min(1, seconds / until) : 0);
  /** @type {(value: number) => number} */
  const y = value => Math.round(high > low ? 1000 * (high - value) / (high - low) : 500);
  const steps = samples.map(([seconds, best], i) => `${i === 0 ? 'M' : 'H'}${x(seconds)}${i === 0 ? ' ' : 'V'}${y(best)}`);
  return samples.length > 0 ? `${steps.join('')}H1000` : '';
}

/** @type {(value: number) => string} */
const shortNumber = value => String(Number(value.toPrecision(7)));

/** The samples so far, and the bound once it is known. @type {(until: number, bound?: number) => void} */
function drawConvergence(until, bound) {
  const values = tour.samples.map(([, best]) => best), high = Math.max(...values), best = Math.min(...values);
  const low = bound === undefined ? best : Math.min(best, bound);
  element('tour-figure').hidden = tour.samples.length === 0;
  if (tour.samples.length === 0) return;
  element('tour-curve').setAttribute('d', convergencePath(tour.samples, until, low, high));
  element('tour-curve').setAttribute('data-samples', String(tour.samples.length));
  element('tour-bound').setAttribute('d', bound === undefined ? '' : convergencePath([[0, bound]], until, low, high));
  element('tour-high').textContent = shortNumber(high);
  element('tour-low').textContent = low < high ? shortNumber(low) : '';
  element('tour-until').textContent = `${until.toFixed(until < 1 ? 3 : 1)} s`;
  element('tour-said').textContent = `${
    values.length === 1 ? `1 value, ${shortNumber(best)}` :
                          `${values.length} values, from ${shortNumber(values[0])} to ${shortNumber(best)}`}${
    bound === undefined ? '' : `; the dashed line is the bound, ${shortNumber(bound)}`}`;
}

/** @type {(state: WaitingState | RunningState) => void} */
function hearTour(state) {
  const progress = state.state === 'running' ? state.progress : undefined;
  if (state.state !== 'running' || progress?.stage !== 'searching') return;
  const last = tour.samples.at(-1);
  if (!last || progress.best < last[1]) tour.samples.push([progress.found_s, progress.best]);
  drawConvergence(state.seconds);
}

/** What was found, as lines of a list. @type {(found: TourFound) => [string, string][]} */
function tourFigures(found) {
  const proven = found.gap === 0;
  return [
    [found.objective_name === 'length' ? 'length' : `objective (${found.objective_name})`, shortNumber(found.objective)],
    ['bound', `${shortNumber(found.bound)} (${found.bound_basis})`],
    ['gap',
      proven               ? '0: proven optimal' :
        found.gap === null ? 'not known' :
                             `${(100 * found.gap).toFixed(3)} %`],
    ...(found.objective_name === 'length' ? [] : [/** @type {[string, string]} */ (['length', shortNumber(found.length)])]),
    ['turns', String(found.turns)], ['points', String(found.tour.length)], ['time', `${found.time_s.toFixed(2)} s`],
    ['method', found.method]
  ];
}

/** @type {(state: DoneState) => Promise<void>} */
async function showTour(state) {
  element('tour-downloads').replaceChildren(...downloadLines(state.results, tour.stem));
  element('tour-picture').src = state.results.picture;
  fillList(element('tour-messages'), state.messages);
  element('tour-notes').hidden = state.messages.length === 0;
  try {
    /** @type {TourFound} */
    const found = JSON.parse(await textAt(state.results.tour));
    tour.samples = found.convergence;
    drawConvergence(found.time_s, found.bound);
    element('tour-figures').replaceChildren(...tourFigures(found).flatMap(([name, value]) => [made('dt', name), made('dd', value)]));
    say(element('tour-status'), `Done: ${shortNumber(found.objective)}.`);
  } catch (error) { say(element('tour-status'), wordsOfError(error), true); }
}

/** @type {(event: Event) => Promise<void>} */
async function startTour(event) {
  event.preventDefault();
  const points = tour.files.of('points'), lattice = latticeOf(element('tour-lattice').value), form = tour.files.form(tourOptions());
  if (!points) form.append('lattice', lattice);
  tour.stem = points ? stemOf(points.name) : lattice;
  tour.samples = [];
  drawConvergence(0);
  await tour.run.start(form);
}

function setUpTour() {
  element('tour-form').addEventListener('submit', startTour);
  element('tour-form').addEventListener('input', showTourCommand);
  showTourCommand();
}
