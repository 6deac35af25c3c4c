// The way to the pipeline, in the browser itself: each plan and each check is a worker that runs the command as WebAssembly. The same
// functions as by a server (apps/serve/page/server.js).

const mostMessages = 200;
/** @type {{ wasm: Promise<WebAssembly.Module> | null, works: Map<string, LocalWork | LocalComparison>, last: number }} */
const local = {
  wasm: null,
  works: new Map(),
  last: 0
};

/** The command, fetched and compiled once. @type {() => Promise<WebAssembly.Module>} */
function compiledCommand() {
  local.wasm ??= fetch('clearcut.wasm')
                   .then(answer => {
                     if (!answer.ok) throw new Error();
                     return answer.arrayBuffer();
                   })
                   .then(bytes => WebAssembly.compile(bytes))
                   .catch(() => {
                     local.wasm = null;
                     throw new Error('The planner cannot be loaded. Is there a network? Once loaded, it works without one.');
                   });
  return local.wasm;
}

/** A file's name that is no option. @type {(name: string) => string} */
const plainName = name => name.startsWith('-') ? `./${name}` : name;

/** @type {(form: FormData) => Promise<NamedBytes[]>} */
function filesOf(form) {
  const chosen = [...form.values()].filter(value => value instanceof File);
  return Promise.all(chosen.map(async file => /** @type {NamedBytes} */ ([file.name, new Uint8Array(await file.arrayBuffer())])));
}

/** The name of the file with that role, as the command takes it. @type {(form: FormData, role: string) => string} */
function nameIn(form, role) {
  const file = form.get(role);
  return file instanceof File ? plainName(file.name) : '';
}

/** @type {(form: FormData) => string[]} */
const optionsIn = form => wordsOf(String(form.get('options') ?? ''));

/** @type {Record<string, string>} */
const resultTypes = {
  'program.ngc': 'text/plain',
  'certificate.json': 'application/json',
  'report.html': 'text/html',
  'picture.svg': 'image/svg+xml',
  'setup-sheet.html': 'text/html',
  'points.csv': 'text/csv',
  'tour.json': 'application/json'
};

/**
 * Files of the folder of results as [name, bytes, type]; the name of a set-up's own ends in its number, "program-2".
 * @type {(files: CommandEnd['results']) => [string, Uint8Array<ArrayBuffer>, string][]}
 */
function namedResults(files) {
  /** @type {[string, Uint8Array<ArrayBuffer>, string][]} */
  const found = [];
  for (const [file, bytes] of Object.entries(files)) {
    const [, stem, number, ending] = /^([a-z-]+?)(-\d+)?(\.[a-z]+)$/.exec(file) ?? [], type = resultTypes[stem + ending];
    if (type) found.push([stem + (number ?? ''), bytes, type]);
  }
  return found;
}

/** @type {(verdict: string) => number} */
const severity = verdict => verdict.startsWith('FAULTY') ? 2 : verdict.startsWith('CONDITIONAL') ? 1 : 0;

/** An address that this page alone knows. @type {(content: BlobPart, type: string) => string} */
const linkTo = (content, type) => URL.createObjectURL(new Blob([content], {type: `${type};charset=utf-8`}));

/** The last state of a plan or a check that ended by itself. @type {(work: LocalWork, end: CommandEnd) => WorkState} */
function stateOfEnd(work, end) {
  const named = namedResults(end.results);
  /** @type {Certificate[]} */
  const certificates =
    named.filter(([name]) => name.startsWith('certificate')).map(([, bytes]) => JSON.parse(new TextDecoder().decode(bytes)));
  if (end.code > 1 || work.isJudged && certificates.length === 0)
    return {state: 'failed', message: work.messages.at(-1) ?? 'ended without a result'};
  const worst = certificates.sort((a, b) => severity(b.verdict) - severity(a.verdict)).at(0);
  const results = Object.fromEntries(named.map(([name, bytes, type]) => [name, linkTo(bytes, type)]));
  results.text = linkTo(end.text, 'text/plain');
  return {state: 'done', seconds: work.seconds, verdict: worst?.verdict ?? '', messages: work.messages, results, certificate: worst};
}

const broken = (/** @type {string} */ reason) =>
  new Error(`The planner broke down (${reason}); this browser may give it too little memory.`);

/** A run of the command in a worker of its own. */
class LocalWork {
  /** @param {string[]} words @param {NamedBytes[]} files */
  constructor(words, files) {
    this.began = performance.now();
    /** What was noticed. @type {string[]} */
    this.messages = [];
    /** @type {WorkState} */
    this.state = {state: 'running', seconds: 0};
    /** Who follows it. @type {((state: WorkState) => void) | null} */
    this.hear = null;
    /** @type {Worker | null} */
    this.worker = null;
    this.isDropped = false;
    /** Whether a certificate says what came of it. */
    this.isJudged = words[0] !== 'tour';
    this.clock = setInterval(() => this.tell(), 500);
    /** Rejected where the worker breaks down; of a run that was dropped nothing comes any more. */
    this.end = compiledCommand().then(wasm => this.run({wasm, words, files})).finally(() => this.stop());
  }

  /** s since it began. */
  get seconds() { return (performance.now() - this.began) / 1000; }

  /** @type {(task: WorkerTask) => Promise<CommandEnd>} */
  run(task) {
    return new Promise((resolve, reject) => {
      if (this.isDropped) return;
      this.worker = new Worker('worker.js');
      this.worker.onmessage = event => {
        /** @type {WorkerMessage} */
        const told = event.data;
        if ('line' in told) this.hearLine(told.line);
        else if ('end' in told) resolve(told.end);
        else reject(broken(told.broken));
      };
      this.worker.onerror = event => reject(broken(event.message));
      this.worker.postMessage(task);
    });
  }

  /** What the command says while it runs: progress, or a message. @type {(line: string) => void} */
  hearLine(line) {
    if (line.startsWith('{"progress"')) {
      if (this.state.state === 'running') this.state.progress = JSON.parse(line).progress;
    } else if (line && this.messages.length < mostMessages) {
      this.messages.push(line.replace(/^clearcut: /, ''));
    }
    this.tell();
  }

  tell() {
    if (this.state.state === 'running') this.state.seconds = this.seconds;
    this.hear?.(this.state);
  }

  stop() {
    clearInterval(this.clock);
    this.worker?.terminate();
  }

  drop() {
    this.isDropped = true;
    this.hear = null;
    this.stop();
    if (this.state.state === 'done') forgetLinks(this.state.results);
  }

  /** The last state of a plan or a check. @type {() => Promise<WorkState>} */
  async last() {
    try {
      this.state = stateOfEnd(this, await this.end);
    } catch (error) { this.state = {state: 'failed', message: wordsOfError(error)}; }
    this.tell();
    return this.state;
  }
}

/** @type {(links: Record<string, string>) => void} */
function forgetLinks(links) {
  for (const link of Object.values(links)) URL.revokeObjectURL(link);
}

/** What came of a part that was planned and certified by one strategy. @type {(strategy: string, state: WorkState) => StrategyRun} */
function runOf(strategy, state) {
  if (state.state === 'done') forgetLinks(state.results);
  if (state.state !== 'done' || !state.certificate)
    return {strategy, planned: false, refusal: state.state === 'failed' && state.message || 'ended without a result'};
  const {time_s, feed_mm, retracts, engagement, uncut_thickness_mm, features} = state.certificate;
  return {
    strategy,
    planned: true,
    clean: features.every(feature => feature.clean),
    fastest: false,
    time_s,
    feed_mm,
    retracts,
    engagement_max_deg: engagement.max_deg,
    uncut_thickness_mm
  };
}

/** The first of those that take the least time and are clean. @type {(runs: StrategyRun[]) => PlannedRun | undefined} */
function fastestOf(runs) {
  const seconds = (/** @type {PlannedRun} */ run) => run.time_s ?? Infinity;
  return runs.filter(run => run.planned)
    .filter(run => run.clean)
    .reduce((/** @type {PlannedRun | undefined} */ best, run) => best && seconds(best) <= seconds(run) ? best : run, undefined);
}

/** Every strategy on a part, two at a time, each in a worker of its own. */
class LocalComparison {
  /** @param {FormData} form @param {NamedBytes[]} files @param {string[]} names */
  constructor(form, files, names) {
    this.words =
      ['plan', nameIn(form, 'part'), ...optionsIn(form), '--output=results/program.ngc', '--certificate=results/certificate.json'];
    this.files = files;
    this.names = names;
    /** Strategies that nobody has begun. */
    this.left = [...names.keys()];
    /** @type {StrategyRun[]} */
    this.runs = [];
    /** What is under way. @type {Set<LocalWork>} */
    this.works = new Set();
    this.began = performance.now();
    /** How many are done, and after how many s the last one was. */
    this.done = {count: 0, seconds: 0};
    /** @type {WorkState} */
    this.state = {state: 'running', seconds: 0};
    /** Who follows it. @type {((state: WorkState) => void) | null} */
    this.hear = null;
    this.clock = setInterval(() => this.tell(), 500);
  }

  /** s since it began. */
  get seconds() { return (performance.now() - this.began) / 1000; }

  tell() {
    if (this.state.state === 'running') {
      const {count, seconds} = this.done, left = timeLeft(count, this.names.length, seconds, this.seconds - seconds);
      this.state = {
        state: 'running',
        seconds: this.seconds,
        progress: {stage: 'counting', things: 'strategies', done: count, most: this.names.length, ...left === null ? {} : {left_s: left}}
      };
    }
    this.hear?.(this.state);
  }

  async planSome() {
    for (let k = this.left.shift(); k !== undefined; k = this.left.shift()) {
      const work = new LocalWork([...this.words, `--strategy=${this.names[k]}`], this.files);
      this.works.add(work);
      this.runs[k] = runOf(this.names[k], await work.last());
      this.works.delete(work);
      this.done = {count: this.done.count + 1, seconds: this.seconds};
      this.tell();
    }
  }

  /** @type {() => Promise<void>} */
  async last() {
    await Promise.all([this.planSome(), this.planSome()]);
    clearInterval(this.clock);
    const fastest = fastestOf(this.runs), refused = this.runs.find(run => !run.planned);
    if (fastest) fastest.fastest = true;
    this.state = this.runs.some(run => run.planned) ? {
      state: 'done',
      seconds: this.seconds,
      verdict: '',
      messages: [],
      results: {text: linkTo(JSON.stringify({strategies: this.runs}), 'application/json')}
    } :
                                                      {state: 'failed', message: refused && !refused.planned ? refused.refusal : ''};
    this.tell();
  }

  drop() {
    this.hear = null;
    this.left = [];
    clearInterval(this.clock);
    for (const work of this.works) work.drop();
    if (this.state.state === 'done') forgetLinks(this.state.results);
  }
}

/** s, as the command says it: it falls until the next one ends, and is not known before a sixth is done. @type {(done: number, most: number, spent: number, since: number) => number | null} */
function timeLeft(done, most, spent, since) {
  const left = done > 0 ? Math.round(spent * (most - done) / done - since) : 0;
  return done < most / 6 || done >= most || left < 0 ? null : left;
}

const ofProgram = ['--output=results/program.ngc', '--certificate=results/certificate.json', '--svg=results/picture.svg'];
/** @type {() => Promise<string[]>} */
const strategyNames = async () => (await pipeline.options()).plan.find(one => one.names.includes('--strategy'))?.values ?? [];
/** What is one run of the command. @typedef {Exclude<RunTab, 'compare'>} CommandTab */
/** Options that name the results. @type {Record<CommandTab, string[]>} */
const resultsWanted = {
  plan: [...ofProgram, '--report=results/report.html', '--setup-sheet=results/setup-sheet.html'],
  check: ['--json=results/certificate.json', '--svg=results/picture.svg', '--report=results/report.html'],
  elements: [...ofProgram, '--html=results/report.html', '--points=results/points.csv'],
  tour: ['--json=results/tour.json', '--svg=results/picture.svg'],
};
/** The command and what it is given. @type {Record<CommandTab, (form: FormData) => string[]>} */
const inputOf = {
  plan: form => ['plan', nameIn(form, 'part')],
  check: form => ['verify', nameIn(form, 'program'), ...(form.get('part') ? [`--part=${nameIn(form, 'part')}`] : [])],
  elements: form => ['elements', nameIn(form, 'job')].filter(word => word),
  tour: form => ['tour', nameIn(form, 'points') || String(form.get('lattice') ?? '')],
};

/** See Pipeline for what each does. @type {Pipeline} */
const pipeline = {
  promise: 'Nothing is uploaded: this page plans and checks in your browser, also without a network.',
  noSolids: 'STEP solids are not read in the browser: take clearcut or its server, or export a DXF of their outlines.',
  async options() {
    const answer = await fetch('options.json').catch(() => null);
    if (!answer?.ok) throw new Error('The list of options cannot be loaded. Is there a network?');
    return answer.json();
  },
  async begin(what, form) {
    const files = await filesOf(form);
    const work = what === 'compare' ? new LocalComparison(form, files, await strategyNames()) :
                                      new LocalWork([...inputOf[what](form), ...optionsIn(form), ...resultsWanted[what]], files),
          id = String(++local.last);
    local.works.set(id, work);
    work.last();
    return id;
  },
  async drop(id) {
    local.works.get(id)?.drop();
    local.works.delete(id);
  },
  follow(id, hear, lost) {
    const work = local.works.get(id);
    if (!work) {
      lost(new Error('There is no plan of that name, or no more.'));
      return () => {};
    }
    work.hear = hear;
    setTimeout(() => work.tell());
    return () => {
      work.hear = null;
    };
  },
  async info(form) {
    const work = new LocalWork(['info', nameIn(form, 'part'), ...optionsIn(form), '--json'], await filesOf(form)), end = await work.end;
    if (end.code > 1 || !end.text.startsWith('{')) return {state: 'failed', message: work.messages.at(-1) ?? 'ended without an answer'};
    return {state: 'done', info: JSON.parse(end.text)};
  },
};

if ('serviceWorker' in navigator) navigator.serviceWorker.register('offline.js').catch(() => {});  // then it works with a network only
