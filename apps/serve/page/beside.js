// Strategies side by side: each that was chosen in the comparison is planned, and their reports move as one, by one camera and one time.

/** What was compared. @type {FormData | null} */
let compared = null;
/** @type {{ panes: Pane[], ids: string[], isPlanning: boolean, isPlaying: boolean, lastFrame: number, share: number }} */
const beside = {
  panes: [],
  ids: [],
  isPlanning: false,
  isPlaying: false,
  lastFrame: 0,
  share: 0
};
const mostBeside = 4;

/** The strategies whose boxes are ticked. @type {() => string[]} */
const chosenBeside = () => [...element('comparison').querySelectorAll('input')].filter(box => box.checked).map(box => box.value);

/** From two to four: more would be too small to be seen. */
function limitBeside() {
  const count = chosenBeside().length;
  for (const box of element('comparison').querySelectorAll('input'))
    box.disabled = beside.isPlanning || !box.checked && count >= mostBeside;
  element('beside-go').disabled = !beside.isPlanning && count < 2;
  element('beside-go').textContent = beside.isPlanning ? 'Cancel' : 'Show side by side';
}

/** A box for a strategy of the comparison. @type {(one: PlannedRun, isChosen: boolean) => HTMLElement} */
function besideBox(one, isChosen) {
  const box = made('input', '', {type: 'checkbox', value: one.strategy, 'aria-label': `Show the strategy ${one.strategy} beside others`});
  box.checked = isChosen;
  box.addEventListener('change', limitBeside);
  return box;
}

/** The fastest, and the next in time whose path is another. @type {(strategies: StrategyRun[]) => string[]} */
function firstBeside(strategies) {
  const runs = strategies.filter(one => one.planned)
                 .sort((a, b) => Number(b.fastest) - Number(a.fastest) || Number(b.clean) - Number(a.clean) ||
                     (a.time_s ?? Infinity) - (b.time_s ?? Infinity));
  const other = runs.find(one => one.time_s !== runs[0].time_s || one.feed_mm !== runs[0].feed_mm) ?? runs[1];
  return [runs[0], other].filter(one => one).map(one => one.strategy);
}

/** One report among others. */
class Pane {
  /** @param {string} strategy @param {DoneState} state */
  constructor(strategy, state) {
    const frame = made('iframe', '', {
      title: `${strategy}, move by move`,
      sandbox: 'allow-scripts allow-downloads',
      src: `${resultsOf(state.results, 'report')[0]?.[1]}#linked${lengths.inch ? '&unit=inch' : ''}`
    });
    this.frame = frame;
    this.box = made('figure');
    this.caption = made('figcaption');
    this.caption.append(made('strong', strategy), ' ', made('span', state.verdict, {class: `verdict ${state.verdict}`}), ' ');
    this.clock = made('span');
    this.caption.append(this.clock);
    this.box.append(this.caption, frame);
    /** s; 0: not known yet. */
    this.total = 0;
    /** Whether the last time that it was told is not shown yet, and whether another has come since. */
    this.isBusy = false;
    this.isLate = false;
  }

  /** @type {(order: ReportOrder) => void} */
  tell(order) { this.frame.contentWindow?.postMessage(order, '*'); }

  /** One time after the other: a slow machine leaves some out. */
  showTime() {
    const time = timeOf(this);
    this.clock.textContent = `${minutes(time)} of ${minutes(this.total)}`;
    this.isLate = this.isBusy;
    if (this.isBusy || this.total === 0) return;
    this.isBusy = true;
    this.tell({clearcut: 'time', time});
  }

  /** @type {(message: ReportMessage) => void} */
  hear(message) {
    if (message.clearcut === 'ready') {
      this.total = message.total;
      this.isBusy = false;
      if (beside.panes.every(pane => pane.total > 0)) beside.panes[0].tell({clearcut: 'ask'});
      showShare(beside.share);
    } else if (message.clearcut === 'look') {
      for (const other of beside.panes)
        if (other !== this) other.tell(message);
    } else if (message.clearcut === 'shown') {
      this.isBusy = false;
      if (this.isLate) this.showTime();
    } else if (message.clearcut === 'time') {
      playBeside(false);
      showShare(shareAt(this, message.time), this);
    }
  }
}

/** What is planned so far is not wanted any more. */
function forgetBeside() {
  for (const id of beside.ids) pipeline.drop(id);
  Object.assign(beside, {panes: [], ids: [], isPlanning: false, isPlaying: false});
  element('beside').hidden = true;
  element('beside-panes').replaceChildren();
}

/** The form of the comparison for one of its strategies. @type {(form: FormData, strategy: string) => FormData} */
function formOf(form, strategy) {
  const own = new FormData();
  for (const [name, value] of form.entries()) {
    if (value instanceof File) own.append(name, value, value.name);
    else own.append(name, name === 'options' ? `${value} --strategy ${strategy}`.trim() : value);
  }
  return own;
}

/** Plans one to its end. @type {(form: FormData, strategy: string, words: string) => Promise<DoneState>} */
async function plannedOf(form, strategy, words) {
  const id = await pipeline.begin('plan', formOf(form, strategy));
  beside.ids.push(id);
  return new Promise((resolve, reject) => {
    const unfollow = pipeline.follow(id, state => {
      if (!beside.ids.includes(id)) {
        unfollow();
        return;
      }
      if (state.state === 'waiting' || state.state === 'running') {
        say(element('plan-status'), `${words}: ${progressText(state)}`);
        return;
      }
      unfollow();
      if (state.state === 'done') resolve(state);
      else reject(new Error(state.message ?? 'Cancelled.'));
    }, error => reject(error));
  });
}

async function startBeside() {
  const strategies = chosenBeside(), form = compared;
  const wasPlanning = beside.isPlanning;
  forgetBeside();
  if (wasPlanning || !form) {
    limitBeside();
    say(element('plan-status'), 'Cancelled.');
    return;
  }
  beside.isPlanning = true;
  limitBeside();
  const ids = beside.ids;
  try {
    for (const [k, strategy] of strategies.entries()) {
      const state = await plannedOf(form, strategy, `${strategy}, ${k + 1} of ${strategies.length}`);
      if (beside.ids !== ids) return;
      beside.panes.push(new Pane(strategy, state));
    }
    showBeside();
  } catch (error) {
    forgetBeside();
    say(element('plan-status'), wordsOfError(error), true);
  }
  beside.isPlanning = false;
  limitBeside();
}

function showBeside() {
  element('beside-panes').replaceChildren(...beside.panes.map(pane => pane.box));
  beside.share = 1;
  element('beside').hidden = false;
  element('beside').scrollIntoView({block: 'nearest'});
  say(element('plan-status'), `${beside.panes.length} strategies side by side.`);
}

const longestBeside = () => Math.max(...beside.panes.map(pane => pane.total), 1e-9);
const byClock = () => element('beside-by').value === 'clock';
/** When a pane is, s: at the same share of its own time, or at the same time on the clock. @type {(pane: Pane) => number} */
const timeOf = pane => byClock() ? Math.min(pane.total, beside.share * longestBeside()) : beside.share * pane.total;
/** @type {(pane: Pane, time: number) => number} */
const shareAt = (pane, time) => time / (byClock() ? longestBeside() : pane.total || 1);

/** Brings all to a share of the time; `but` is there already. @type {(share: number, but?: Pane) => void} */
function showShare(share, but) {
  beside.share = Math.max(0, Math.min(1, share));
  element('beside-scrub').value = String(Math.round(100000 * beside.share));
  const words = byClock() ? minutes(beside.share * longestBeside()) : `${(100 * beside.share).toFixed(1)} %`;
  element('beside-clock').textContent = words;
  element('beside-scrub').setAttribute('aria-valuetext', words);
  for (const pane of beside.panes) {
    if (pane !== but) pane.showTime();
    else pane.clock.textContent = `${minutes(timeOf(pane))} of ${minutes(pane.total)}`;
  }
}

const playSeconds = 30;  // from the beginning to the end, whatever the strategies take

/** @type {(on: boolean) => void} */
function playBeside(on) {
  if (on === beside.isPlaying) return;
  beside.isPlaying = on;
  element('beside-play').textContent = on ? 'Pause' : 'Play';
  if (!on) return;
  if (beside.share >= 1) beside.share = 0;
  beside.lastFrame = performance.now();
  requestAnimationFrame(playOn);
}

/** @type {(now: number) => void} */
function playOn(now) {
  if (!beside.isPlaying) return;
  const step = Math.min(0.2, (now - beside.lastFrame) / 1000) / playSeconds;
  beside.lastFrame = now;
  showShare(beside.share + step);
  if (beside.share >= 1) playBeside(false);
  else requestAnimationFrame(playOn);
}

function setUpBeside() {
  element('beside-go').addEventListener('click', startBeside);
  element('beside-play').addEventListener('click', () => playBeside(!beside.isPlaying));
  element('beside-scrub').addEventListener('input', () => {
    playBeside(false);
    showShare(Number(element('beside-scrub').value) / 100000);
  });
  element('beside-by').addEventListener('change', () => showShare(beside.share));
  window.addEventListener('message', event => beside.panes.find(pane => pane.frame.contentWindow === event.source)?.hear(event.data));
}
