// A run of the command that goes on while the page shows how far it is: a plan, a job of elements, a tour. All tabs that have one show it alike.

/** @type {(state: WaitingState | RunningState, words?: RunWords) => string} */
function progressText(state, {things = 'candidates', certifying = 'Certifying the program'} = {}) {
  if (state.state === 'waiting') return state.ahead > 0 ? `Waiting; ${state.ahead} before it.` : 'Waiting for its turn.';
  const seconds = Math.round(state.seconds), progress = state.progress;
  if (!progress) return `Reading and preparing … ${seconds} s`;
  const about = progress.stage === 'planning' || progress.stage === 'searching' ? 'at most' : 'about',
        left = progress.left_s ? `, ${about} ${progress.left_s} s left` : '';
  if (progress.stage === 'counting')
    return `Planning and certifying: ${progress.done} of ${progress.most} ${progress.things} done … ${seconds} s${left}`;
  if (progress.stage === 'certifying') return `${certifying} … ${seconds} s${left}`;
  if (progress.stage === 'searching')
    return `Searching: best ${progress.best} after ${progress.found_s.toFixed(1)} s … ${seconds} s${left}`;
  return `Planning: ${progress.done} of at most ${progress.most} ${things} … ${seconds} s${left}`;
}

/** How far it is as [done, of]; null: not known. @type {(state: WaitingState | RunningState) => [number, number] | null} */
function shareDone(state) {
  const progress = state.state === 'running' ? state.progress : undefined;
  if (state.state !== 'running' || !progress) return null;
  if (progress.stage === 'searching') return [state.seconds, state.seconds + (progress.left_s ?? 0)];
  return progress.most > 0 ? [progress.done, progress.most] : null;
}

/** The run of a tab, whose elements have names that begin with the tab's. */
class Run {
  /** @param {RunTab} tab @param {RunShown} shown */
  constructor(tab, shown) {
    this.tab = tab;
    this.shown = shown;
    /** Of the run on its way or of the last one; '': none. */
    this.id = '';
    /** @type {(() => void) | null} */
    this.unfollow = null;
    /** From its start, when the files are sent, to its end. */
    this.isOn = false;
    /** Runs that were started: what was begun for an earlier one is not wanted any more. */
    this.count = 0;
    element(`${tab}-cancel`).addEventListener('click', () => this.cancel());
  }

  /** Begins another; what the last one left is not wanted any more. `isAgain`: that is shown until the next has come. @type {(form: FormData, isAgain?: boolean) => Promise<void>} */
  async start(form, isAgain = false) {
    this.leave();
    const mine = ++this.count;
    this.isOn = true;
    if (!isAgain) {
      element(`${this.tab}-result`).hidden = true;
      element(`${this.tab}-go`).disabled = true;
    }
    element(`${this.tab}-cancel`).hidden = false;
    say(element(`${this.tab}-status`), 'Sending the files …');
    if (!isAgain) element(`${this.tab}-status`).scrollIntoView({block: 'nearest'});  // a narrow page has it below the form
    try {
      const id = await pipeline.begin(this.tab, form);
      if (mine !== this.count) {
        pipeline.drop(id);
        return;
      }
      this.id = id;
      this.unfollow = pipeline.follow(id, state => this.hear(state), error => this.fail(error));
    } catch (error) {
      if (mine === this.count) this.fail(error);
    }
  }

  /** Hears no more of the run and drops it, if there is one. */
  leave() {
    this.unfollow?.();
    this.unfollow = null;
    if (this.id) pipeline.drop(this.id);
    this.id = '';
  }

  /** What the last one left is not shown any more, as the question is another; one that goes on is not touched. */
  forget() {
    if (this.isOn || !this.id) return;
    this.leave();
    element(`${this.tab}-result`).hidden = true;
  }

  /** @type {(error: unknown) => void} */
  fail(error) {
    this.end();
    say(element(`${this.tab}-status`), wordsOfError(error), true);
  }

  /** @type {(state: WorkState) => void} */
  hear(state) {
    if (state.state === 'waiting' || state.state === 'running') {
      this.showProgress(state);
      return;
    }
    this.end();
    if (state.state === 'done') {
      element(`${this.tab}-result`).hidden = false;
      Promise.resolve(this.shown.done(state)).catch(error => this.fail(error));
    } else {
      say(element(`${this.tab}-status`), state.message || 'Cancelled.', state.state === 'failed');
    }
  }

  /** @type {(state: WaitingState | RunningState) => void} */
  showProgress(state) {
    const bar = element(`${this.tab}-progress`), share = shareDone(state);
    bar.hidden = false;
    if (share) [bar.value, bar.max] = share;
    else bar.removeAttribute('value');
    say(element(`${this.tab}-status`), progressText(state, this.shown));
    this.shown.progress?.(state);
  }

  end() {
    this.unfollow?.();
    this.unfollow = null;
    this.isOn = false;
    element(`${this.tab}-progress`).hidden = true;
    element(`${this.tab}-cancel`).hidden = true;
    this.shown.ended();
  }

  cancel() {
    ++this.count;
    this.leave();
    this.end();
    say(element(`${this.tab}-status`), 'Cancelled.');
  }
}

/** @type {[string, string, string][]} */
const downloads = [
  ['program', 'Program', '.ngc'], ['certificate', 'Certificate', '.json'], ['report', 'Report', '.html'], ['tour', 'Tour', '-tour.json'],
  ['picture', 'Picture', '.svg'], ['points', 'Points', '-points.csv'], ['setup-sheet', 'Set-up sheet', '-setup.html'],
  ['text', 'Figures', '.txt']
];

/**
 * Results of a kind: one, or one for each set-up of the job, as [set-up or '', address].
 * @type {(results: Record<string, string>, kind: string) => [string, string][]}
 */
const resultsOf = (results, kind) =>
  Object.entries(results).filter(([name]) => name === kind || /^-\d+$/.test(name.slice(kind.length)) && name.startsWith(kind)).map(([
    name, address
  ]) => [name.slice(kind.length + 1), address]);

/** Lines with a link to each result. @type {(results: Record<string, string>, stem: string) => HTMLElement[]} */
const downloadLines = (results, stem) => downloads.flatMap(([kind, title, ending]) => resultsOf(results, kind).map(([setup, address]) => {
  const line = made('li');
  line.append(
    made('a', setup ? `${title} of set-up ${setup}` : title, {href: address, download: (setup ? `${stem}-${setup}` : stem) + ending}));
  return line;
}));

/** What lies at the address of a result. @type {(address: string) => Promise<string>} */
const textAt = async address => (await fetch(address)).text();

/** What speaks against a program, in a line; '': nothing. @type {(certificate: Certificate) => string} */
function reasonOf({faults, conditions}) {
  const open = conditions.filter(one => !one.met_by),
        [first, count, name] = faults.length > 0 ? [faults[0], faults.length, 'fault'] : [open[0], open.length, 'open condition'];
  return first ? `${count} ${name}${count === 1 ? '' : 's'}: ${shownText(first.text)}` : '';
}

/** The same of each set-up. @type {(results: Record<string, string>) => Promise<string>} */
async function reasonsOf(results) {
  const reasons = await Promise.all(resultsOf(
    results, 'certificate').map(async ([setup, address]) => [setup && `set-up ${setup}, `, reasonOf(JSON.parse(await textAt(address)))]));
  return reasons.filter(([, reason]) => reason).map(([setup, reason]) => setup + reason).join('; ');
}

/** What was found of a program. @type {(tab: 'plan' | 'elements', state: DoneState) => void} */
function showVerdict(tab, state) {
  const verdict = element(`${tab}-verdict`);
  verdict.textContent = state.verdict;
  verdict.className = `verdict ${state.verdict}`;
  const summary = element(`${tab}-summary`), said = `planned and certified in ${state.seconds.toFixed(1)} s`;
  summary.textContent = said;
  reasonsOf(state.results).then(reasons => {
    if (!reasons || summary.textContent !== said) return;
    summary.textContent = `${reasons} (${said})`;
    summary.title = reasons;
  }, () => {});
  fillList(element(`${tab}-messages`), state.messages);
  element(`${tab}-notes`).hidden = state.messages.length === 0;
  say(element(`${tab}-status`), `Done: ${state.verdict}.`);
}
