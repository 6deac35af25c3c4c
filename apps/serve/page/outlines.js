// What a part holds: what was found and mended, what has to be said, and what each outline of a drawing is for.

/** `isAsked`: which reading is meant is still to be said; `isOfSetups`: the part is a job of several set-ups. @type {PartRead} */
const part = {
  asked: 0,
  outlines: [],
  features: [],
  stock: null,
  isAsked: false,
  isOfSetups: false,
  isReady: false,
  readBy: ''
};
const outlineKinds =
  ['pocket', 'step', 'profile', 'inside', 'drill', 'engrave', 'tslot', 'vcarve', 'isolate', 'chamfer', 'face', 'island', 'ignore'];
const mostOutlines = 300;  // that are listed
/** @type {(value: number, digits: number) => number} */
const round = (value, digits) => Number(value.toFixed(digits));

/** Nothing says yet what it is for. @type {(outline: OutlineInfo) => boolean} */
const isOpen = outline => part.isAsked && !outline.says_role;
/** What the list says of an outline where nobody chose. @type {(outline: OutlineInfo) => string} */
const roleAsRead = outline => outline.role && !isOpen(outline) ? `${outline.role} (read)` : 'not said yet';

/** The options that say what outlines are for: the answers, and what was changed in the list. @type {(now?: Project) => string[]} */
function outlineOptions(now = project.now) {
  const words = now.given.map(optionOfAnswer);
  for (const [number, {kind, depth, role: read}] of Object.entries(now.outlines)) {
    const role = kind || read;
    if (role) words.push(`--op ${role}${depth ? `_d${depth}` : ''}:${number}`);
  }
  return words;
}

/** What was said of an outline so far, with what it is read as. @type {(number: number) => OutlineSaid} */
const saidOfOutline = number =>
  project.now.outlines[number] ?? {kind: '', depth: '', role: part.outlines.find(one => one.number === number)?.role ?? ''};

/** @type {(number: number, said: Partial<OutlineSaid>, what: string) => void} */
function changeOutline(number, said, what) {
  const next = {...saidOfOutline(number), ...said};
  /** @type {Record<string, OutlineSaid>} */
  const outlines = {...project.now.outlines, [number]: next};
  if (!next.kind && !next.depth) delete outlines[number];
  change(`outline ${number} ${what}`, {outlines});
}

/** @type {(outline: OutlineInfo) => string} */
function sizeOf(outline) {
  if (outline.diameter_mm) return `Ø ${shownLength(outline.diameter_mm, 2)}`;
  if (!outline.extent_mm) return '';
  const {x, y} = outline.extent_mm;
  return `${shownLength(x[1] - x[0], 2)} × ${shownLength(y[1] - y[0], 2)}`;
}

/** @type {(outline: OutlineInfo, index: number) => HTMLElement} */
function outlineRow(outline, index) {
  const row = made('tr', '', {'data-index': index});
  const kind = made('select', '', {'aria-label': `What outline ${outline.number} is for`});
  fillSelect(kind, outlineKinds, roleAsRead(outline));
  const depth = made('input', '', {
    'aria-label': `Depth of outline ${outline.number}, ${lengthName()}`,
    inputmode: 'decimal',
    size: '4',
    placeholder: outline.depth_mm === null ? '' : String(shownLength(outline.depth_mm, 3))
  });
  const layer = made('td', outline.layer, {title: outline.within ? `within outline ${outline.within}` : 'within no other'});
  row.append(made('td', String(outline.number)), layer, made('td', sizeOf(outline)), made('td'), made('td'));
  kind.addEventListener('change', () => changeOutline(outline.number, {kind: kind.value}, 'kind'));
  depth.addEventListener('change', () => changeOutline(outline.number, {depth: inMm(depth.value)}, 'depth'));
  row.children[3].append(kind);
  row.children[4].append(depth);
  return row;
}

/** The same outlines, read anew after something was said: what was chosen in the list stays, and so do the names of layers. @type {(outlines: OutlineInfo[]) => void} */
function renewOutlines(outlines) {
  part.outlines = outlines.map((one, index) => ({...one, layer: part.outlines[index].layer, layerNow: one.layer}));
  for (const row of theOne('tbody', element('outlines')).rows)
    theOne('option', row).textContent = roleAsRead(part.outlines[Number(row.dataset.index)]);
  relabelOutlines();
}

/** @type {(outlines: OutlineInfo[]) => void} */
function showOutlines(outlines) {
  part.outlines = outlines.map(one => ({...one, layerNow: one.layer}));
  element('outlines-box').hidden = outlines.length === 0;
  theOne('tbody', element('outlines')).replaceChildren(...part.outlines.slice(0, mostOutlines).map(outlineRow));
  element('outlines-title').textContent =
    `Outlines of the drawing: ${outlines.length}${outlines.length > mostOutlines ? `, the first ${mostOutlines} listed` : ''}`;
  showDrawing();
}

/** After another unit was chosen; what is said of the outlines stays. */
function relabelOutlines() {
  for (const row of theOne('tbody', element('outlines')).rows) {
    const outline = part.outlines[Number(row.dataset.index)], depth = theOne('input', row);
    row.children[2].textContent = sizeOf(outline);
    depth.setAttribute('aria-label', `Depth of outline ${outline.number}, ${lengthName()}`);
    depth.placeholder = outline.depth_mm === null ? '' : String(shownLength(outline.depth_mm, 3));
  }
  showSaidOutlines();
  showDrawing();
}

/** What was said of the outlines, in their fields. */
function showSaidOutlines() {
  for (const row of theOne('tbody', element('outlines')).rows) {
    const said = project.now.outlines[part.outlines[Number(row.dataset.index)].number], depth = said?.depth ?? '';
    if (isTypedIn(row)) continue;
    theOne('select', row).value = said?.kind ?? '';
    theOne('input', row).value = lengths.inch ? changedNumbers(depth, mmToInch) : depth;
  }
}

/** @type {(feature: FeatureInfo) => string} */
function featureText(feature) {
  const {x, y} = feature.extent_mm ?? {x: [0, 0], y: [0, 0]};
  return `${feature.name}: ${feature.kind.replaceAll('_', ' ')}, ${shownLength(x[1] - x[0], 1)} × ${shownLength(y[1] - y[0], 1)} ${
    lengthName()}, z ${shownLength(feature.top_z, 3)} to ${shownLength(feature.floor_z, 3)}`;
}

/** @type {(info: PartInfo) => string[]} */
const textsOf = info => [...info.asks.map(text => `To say: ${text}`),
  ...info.found.map(one => `${one.kind}: ${one.where ? `${one.where}: ` : ''}${one.what}`), ...info.features.map(featureText)];

/** The set-ups of a job as one part, each text with its set-up. @type {(setups: PartInfo[]) => PartInfo} */
function joinedSetups(setups) {
  const named = setups.map((one, i) => ({one, setup: `set-up ${i + 1}: `}));
  return {
    answers: [],
    tools: [],
    asks: named.flatMap(({one, setup}) => one.asks.map(ask => setup + ask)),
    found: named.flatMap(({one, setup}) => one.found.map(item => ({...item, what: setup + item.what}))),
    features: named.flatMap(({one, setup}) => one.features.map(feature => ({...feature, name: setup + feature.name}))),
    stock: null,
    outlines: []
  };
}

/** What is missing, in the words of the page. @type {(ask: string, hasReadings: boolean) => string} */
const askInPage = (ask, hasReadings) => hasReadings     ? 'which reading below is meant, by a click on it' :
  /(^how deep; |no depth given; add )--depth/.test(ask) ? 'how deep it is, in the field Depth' :
                                                          ask;

/** Whether the part can be planned as it is, and what is missing. @type {(name: string, info: PartInfo | null | undefined, texts: string[]) => string} */
function readiness(name, info, texts) {
  if (!info) return texts[0];
  const warning = info.asks.length === 0 && info.found.find(one => one.kind === 'warning');
  if (info.asks.length === 0) return `${name} is ready to be planned.${warning ? ` See first: ${warning.what}.` : ''}`;
  return `Before ${name} can be planned, say: ${
    info.asks.map((ask, k) => askInPage(ask, k === 0 && info.answers.length > 0))
      .map((ask, k) => info.asks.length > 1 ? `(${k + 1}) ${ask}` : ask)
      .join('; ')}`;
}

/** @type {(info: PartInfo | null | undefined) => string} */
function titleOfFound(info) {
  if (!info) return 'The part cannot be read as it is';
  return info.asks.length > 0 ? 'What was found, and what has to be said' :
                                `What was found: ${info.features.length} ${info.features.length === 1 ? 'feature' : 'features'}`;
}

/** @type {(info: PartInfo | null | undefined, texts: string[], isAgain: boolean) => void} */
function showFound(info, texts, isAgain) {
  fillList(element('found'), texts.slice(0, mostOutlines));
  element('found-box').hidden = texts.length === 0;
  element('found-title').textContent = titleOfFound(info);
  if (!isAgain) element('found-box').open = !info || info.asks.length > 0 || info.found.some(one => one.kind === 'warning');
  const isWanted = info?.asks.some(ask => ask.includes('--depth')) ?? false;
  document.getElementById('option-depth')?.classList.toggle('wanted', isWanted);
  if (isWanted) element('drawing-card').open = true;
}

/** What was read, for everybody who asks. @type {(answer: InfoAnswer, info: PartInfo | null | undefined) => void} */
function takePart(answer, info) {
  part.isOfSetups = Boolean(answer.info && 'setups' in answer.info);
  part.features = info?.features ?? [];
  part.stock = info?.stock ?? null;
  part.isReady = info?.asks.length === 0;
  readTools.library = info?.tools ?? [];
  if (info) part.isAsked = info.answers.length > 0;
}

/** `isAgain`: the same part, after something was said. @type {(name: string, answer: InfoAnswer, isAgain: boolean) => void} */
function showPart(name, answer, isAgain) {
  const info = answer.info && 'setups' in answer.info ? joinedSetups(answer.info.setups) : answer.info;
  const texts = info ? textsOf(info) : [answer.message ?? 'The part cannot be read.'],
        outlines = info?.outlines ?? (isAgain ? part.outlines : []);
  takePart(answer, info);
  showFound(info, texts, isAgain);
  if (!plan.run.isOn || !part.isReady) say(element('plan-status'), shownText(readiness(name, info, texts)), !info);
  if (isAgain && outlines.length === part.outlines.length) renewOutlines(outlines);
  else showOutlines(outlines);
  showSaidOutlines();
  colourDrawing();
  offerReadings(info);
  showTools();
  showOperations();
  if (part.isReady) planSoon();
  else showMiddle('drawing');
}

/** Options of `clearcut info`. @type {Set<string>} */
const readNames = new Set();

/** What is said of the part so far, as the command takes it. @type {() => string} */
function readOptions() {
  const {answers} = project.now, own = Object.fromEntries(Object.entries(answers).filter(([name]) => readNames.has(name)));
  const library = project.now.files.find(one => one.role === 'tools');
  return [...wordsOfAnswers(own), ...library ? [optionWord('--tools', library.file.name)] : [], ...outlineOptions()].join(' ');
}

/** Another part: what was said of the last one is void. @type {() => Promise<void>} */
async function readNewPart() {
  part.isAsked = part.isReady = false;
  part.features = [];
  part.stock = null;
  readTools.library = [];
  showOperations();
  element('found-box').hidden = element('outlines-box').hidden = element('readings').hidden = element('given').hidden = true;
  showOutlines([]);
  await readPart(false);
}

/** Asks the server what the part holds; a later question makes an earlier one void. @type {(isAgain?: boolean) => Promise<void>} */
async function readPart(isAgain = true) {
  const mine = ++part.asked, chosen = fileOf(project.now, 'part');
  part.readBy = readOptions();
  if (!chosen) return;
  if (!plan.run.isOn && !isAgain) say(element('plan-status'), `Reading ${chosen.name} …`);
  try {
    const answer = await pipeline.info(formOfPlan({input: chosen.name, options: readOptions(), files: []}));
    if (mine !== part.asked) return;
    showPart(chosen.name, answer, isAgain);
  } catch (error) {
    if (mine !== part.asked) return;
    showPart(chosen.name, {message: wordsOfError(error)}, isAgain);
  }
  showPlanCommand();
}
