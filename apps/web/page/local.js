// The way to the pipeline, in the browser itself: each plan and each check is a worker that runs the command as WebAssembly. The same
// functions as by a server (apps/serve/page/server.js).

const mostMessages = 200;
const local = { wasm: null, works: new Map(), last: 0 };

/** The command, fetched and compiled once. */
function compiledCommand() {
  local.wasm ??= fetch('clearcut.wasm')
    .then(answer => { if (!answer.ok) throw new Error(); return answer.arrayBuffer(); })
    .then(bytes => WebAssembly.compile(bytes))
    .catch(() => { local.wasm = null; throw new Error('The planner cannot be loaded. Is there a network? Once loaded, it works without one.'); });
  return local.wasm;
}

/** A file's name that is no option. */
const plainName = name => name.startsWith('-') ? `./${name}` : name;

async function filesOf(form) {
  const chosen = [...form.entries()].filter(([, value]) => value instanceof File);
  return Promise.all(chosen.map(async ([, file]) => [file.name, new Uint8Array(await file.arrayBuffer())]));
}

const nameIn = (form, role) => plainName(form.get(role).name);

/** What the command says while it runs: progress, or a message. */
function hearLine(work, line) {
  if (line.startsWith('{"progress"')) {
    work.state.progress = JSON.parse(line).progress;
  } else if (line && work.state.messages.length < mostMessages) {
    work.state.messages.push(line.replace(/^clearcut: /, ''));
  }
  tellWork(work);
}

function tellWork(work) {
  if (work.state.state === 'running') work.state.seconds = (performance.now() - work.began) / 1000;
  work.hear?.(work.state);
}

function closeWork(work, state) {
  clearInterval(work.clock);
  work.worker?.terminate();
  tellWork(work);
  Object.assign(work.state, state);
  tellWork(work);
  work.ended(work.state);
}

const resultTypes = { 'program.ngc': 'text/plain', 'certificate.json': 'application/json', 'report.html': 'text/html', 'picture.svg': 'image/svg+xml', 'setup-sheet.html': 'text/html' };

/** Files of the folder of results as [name, bytes, type]; the name of a set-up's own ends in its number, "program-2". */
function namedResults(files) {
  const found = [];
  for (const [file, bytes] of Object.entries(files)) {
    const [, stem, number, ending] = /^([a-z-]+?)(-\d+)?(\.[a-z]+)$/.exec(file) ?? [], type = resultTypes[stem + ending];
    if (type) found.push([stem + (number ?? ''), bytes, type]);
  }
  return found;
}

const severity = verdict => verdict.startsWith('FAULTY') ? 2 : verdict.startsWith('CONDITIONAL') ? 1 : 0;

/** Of a command that prints JSON about a part. */
function stateOfAnswer(work, end) {
  if (end.code > 1 || !end.text.startsWith('{')) return { state: 'failed', message: work.state.messages.at(-1) ?? 'ended without an answer' };
  return { state: 'done', [work.answers]: JSON.parse(end.text) };
}

/** The last state of a command that ended by itself. */
function stateOfEnd(work, end) {
  if (work.answers) return stateOfAnswer(work, end);
  const { messages } = work.state, named = namedResults(end.results);
  const certificates = named.filter(([name]) => name.startsWith('certificate')).map(([, bytes]) => JSON.parse(new TextDecoder().decode(bytes)));
  if (end.code > 1 || certificates.length === 0) return { state: 'failed', message: messages.at(-1) ?? 'ended without a result' };
  const worst = certificates.reduce((a, b) => severity(b.verdict) > severity(a.verdict) ? b : a);
  const state = { state: 'done', certificate: worst, verdict: worst.verdict, text: end.text, results: {} };
  const link = (name, bytes, type) => { state.results[name] = URL.createObjectURL(new Blob([bytes], { type: `${type};charset=utf-8` })); };
  if (!work.keepsLinks) return state;
  for (const [name, bytes, type] of named) link(name, bytes, type);
  link('text', end.text, 'text/plain');
  return state;
}

const broken = reason => ({ state: 'failed', message: `The planner broke down (${reason}); this browser may give it too little memory.` });

/** Runs the command in a worker of its own. */
function startWork(words, files, keepsLinks) {
  const work = { state: { state: 'running', messages: [], seconds: 0 }, began: performance.now(), keepsLinks };
  work.end = new Promise(resolve => { work.ended = resolve; });
  work.clock = setInterval(() => tellWork(work), 500);
  compiledCommand().then(wasm => {
    if (work.isDropped) return;
    work.worker = new Worker('worker.js');
    work.worker.onmessage = ({ data }) => {
      if (data.line !== undefined) hearLine(work, data.line);
      else closeWork(work, data.end ? stateOfEnd(work, data.end) : broken(data.broken));
    };
    work.worker.onerror = event => closeWork(work, broken(event.message));
    work.worker.postMessage({ wasm, words, files });
  }).catch(error => closeWork(work, { state: 'failed', message: error.message }));
  return work;
}

const pipeline = {
  promise: 'Nothing is uploaded: this page plans and checks in your browser, also without a network.',
  async options() {
    const answer = await fetch('options.json').catch(() => null);
    if (!answer?.ok) throw new Error('The list of options cannot be loaded. Is there a network?');
    return answer.json();
  },
  async plan(form) {
    const words = ['plan', nameIn(form, 'part'), ...wordsOf(form.get('options')), '--output=results/program.ngc',
      '--certificate=results/certificate.json', '--svg=results/picture.svg', '--report=results/report.html', '--setup-sheet=results/setup-sheet.html'];
    const id = String(++local.last);
    local.works.set(id, startWork(words, await filesOf(form), true));
    return id;
  },
  async drop(id) {
    const work = local.works.get(id);
    if (!work) return;
    local.works.delete(id);
    work.isDropped = true;
    work.hear = null;
    clearInterval(work.clock);
    work.worker?.terminate();
    for (const link of Object.values(work.state.results ?? {})) URL.revokeObjectURL(link);
  },
  follow(id, hear) {
    const work = local.works.get(id);
    work.hear = hear;
    setTimeout(() => tellWork(work));
    return () => { work.hear = null; };
  },
  async check(form) {
    const part = form.get('part') ? [`--part=${nameIn(form, 'part')}`] : [];
    const words = ['verify', nameIn(form, 'program'), ...part, ...wordsOf(form.get('options')), '--json=results/certificate.json',
      '--report=results/report.html'];
    for (const link of Object.values(local.checked ?? {})) URL.revokeObjectURL(link);
    const state = await startWork(words, await filesOf(form), true).end;
    local.checked = state.results;
    return state;
  },
  async info(form) {
    const work = startWork(['info', nameIn(form, 'part'), ...wordsOf(form.get('options')), '--json'], await filesOf(form), false);
    work.answers = 'info';
    return work.end;
  },
  compare: async () => ({ state: 'failed', message: 'This page plans one strategy at a time; to compare all, run clearcut compare.' }),
};

if ('serviceWorker' in navigator) navigator.serviceWorker.register('offline.js').catch(() => {});  // then it works with a network only
