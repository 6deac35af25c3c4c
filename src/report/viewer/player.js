// ---- Playing.
const SPEEDS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
let figuresKey = '', playing = false, lastFrame = 0, selected = -1, redrawAsked = false;

/** The move under way, or the one selected, which has just ended; -1 before the first. */
function shownMove() {
  if (selected >= 0) return selected;
  return at.move < count && at.fraction > 1e-9 ? at.move : at.move - 1;
}
function shownFraction() {
  if (shownMove() < 0) return 0;
  return selected < 0 && at.move < count && at.fraction > 1e-9 ? at.fraction : 1;
}

/** @type {(time: number, keepMark?: boolean) => void} */
function show(time, keepMark) {
  selected = -1;
  if (!keepMark) unmark();
  leaveChange();
  goTo(time);
  redraw();
}
/** Shows the end of move i. @type {(i: number, keepMark?: boolean) => void} */
function selectMove(i, keepMark) {
  play(false);
  if (!keepMark) unmark();
  leaveChange();
  goTo(moves.t[i + 1]);
  selected = i;
  bringIntoView(pointAt(i, 1));
  redraw();
}
function unmark() {
  marked = null;
  for (const button of by('faults').querySelectorAll('.chosen')) button.classList.remove('chosen');
}
function redraw() {
  by('finished').setAttribute('aria-pressed', String(isFinishedShown()));
  measureStage();
  lensIsDue();
  if (space.on) {
    drawSpace();
    drawSpaceOverlay();
  } else {
    detail.settled = true;
    drawOverlay();
  }
  restSoon();
  // Turning and zooming change no figure, and writing the same ones again costs as much as the picture.
  const key =
    [at.time, selected, playing, unit.name, dark.matches, by('plot').clientWidth, by('plot').clientHeight, window.devicePixelRatio].join();
  if (key !== figuresKey) {
    figuresKey = key;
    updateNow();
    drawPlot();
  }
  tellChanges();
}
function redrawSoon() {
  if (redrawAsked) return;
  redrawAsked = true;
  requestAnimationFrame(() => {
    redrawAsked = false;
    redraw();
  });
}

/** @type {(now: number) => void} */
function frame(now) {
  if (!playing) return;
  const step = Math.min(0.1, (now - lastFrame) / 1000) * Number(by('speed').value);
  lastFrame = now;
  selected = -1;
  goTo(at.time + step);
  if (at.time >= total) playing = false;
  redraw();
  requestAnimationFrame(frame);
}

/** @type {(on: boolean) => void} */
function play(on) {
  if (on === playing) return;
  if (on && at.time >= total) goTo(0);
  if (on) {
    unmark();
    leaveChange();
  }
  playing = on;
  lastFrame = performance.now();
  updateNow();
  if (on) requestAnimationFrame(frame);
}

const isFinishedShown = () => at.time >= total && by('path').value === 'none';
/** Which part of the path was shown before the finished part was. */
let pathBefore = 'recent';
/** The part at the end, without path and cutter; asked again, the beginning and the path as it was. */
function showFinished() {
  const isShown = isFinishedShown();
  if (!isShown) pathBefore = by('path').value;
  by('path').value = isShown ? pathBefore : 'none';
  play(false);
  show(isShown ? 0 : total);
}

/** To the end of the move under way, or one move on or back. @type {(by_: number) => void} */
function stepMove(by_) {
  const i = shownMove(), next = by_ > 0 && shownFraction() > 0 && shownFraction() < 1 ? i : i + by_;
  if (next < 0) {
    play(false);
    show(0);
  } else selectMove(Math.min(count - 1, next));
}

const TURN = 15;  // degrees
/** @type {Record<string, [number, number]>} */
const TURNS = {
  ArrowRight: [TURN, 0],
  ArrowLeft: [-TURN, 0],
  ArrowUp: [0, TURN],
  ArrowDown: [0, -TURN]
};
/** @type {Record<string, () => void>} */
const KEYS = {
  ' ': () => play(!playing),
  ArrowRight: () => stepMove(1),
  ArrowLeft: () => stepMove(-1),
  Home: () => show(0),
  End: () => show(total),
  '+': () => zoom(1.5),
  '=': () => zoom(1.5),
  '-': () => zoom(1 / 1.5),
  '0': () => by('fit').click(),
  'm': () => setMeasuring(!measure.on),
  'b': blinkChange,
  'f': showFinished,
  'Escape': () => setMeasuring(false)
};
/** Whether a key means something else where it is pressed: in a list, a field, or to a button. @type {(event: KeyboardEvent) => boolean} */
function isKeyOfElement({target, key}) {
  if (target instanceof HTMLInputElement) return target.type !== 'range' || key !== ' ';
  return target instanceof HTMLSelectElement || target instanceof HTMLButtonElement && key === ' ';
}

/** @type {(event: KeyboardEvent) => void} */
function keyPressed(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || count === 0 || isKeyOfElement(event)) return;
  const turn = event.shiftKey && space.on ? TURNS[event.key] : undefined, action = turn ? () => orbit(...turn) : KEYS[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

function listen() {
  by('play').onclick = () => play(!playing);
  by('back').onclick = () => stepMove(-1);
  by('forward').onclick = () => stepMove(1);
  by('scrub').oninput = () => show(total * Number(by('scrub').value) / 100000);
  by('path').onchange = redraw;
  by('finished').onclick = showFinished;
  by('color-by').onchange = () => {
    if (by('color-by').value !== 'kind' && by('path').value !== 'all') by('path').value = 'all';
    colorMoves();
    redraw();
  };
  const filter = (/** @type {() => void} */ change) => () => {
    change();
    ++pictureVersion;
    redraw();
  };
  by('rapids').onchange = filter(() => {
    filters.rapids = by('rapids').checked;
  });
  by('operation').onchange = filter(() => {
    filters.operation = Number(by('operation').value);
  });
  by('layer').onchange = filter(() => {
    filters.layer = Number(by('layer').value);
  });
  by('unit').onchange = () => {
    unit = UNITS[by('unit').value];
    writeHeader();
    writeVerdict();
    writeFeatures();
    writeLayers();
    writeMeasured();
    colorMoves();
    chooseSection(true);
    redraw();
  };
  window.onresize = () => {
    drawProgram();
    redraw();
  };
  window.onhashchange = openAtHash;
  dark.onchange = () => {
    colorMoves();
    redraw();
  };
  document.onkeydown = keyPressed;
}

/** @type {(select: HTMLSelectElement, words: string, value: string | number) => void} */
function option(select, words, value) { element('option', words, select).value = String(value); }

function writeLayers() {
  by('layer').replaceChildren();
  option(by('layer'), 'all', -1);
  layerHeights.forEach((milli, k) => option(by('layer'), 'z ' + bare(milli / 1000, 2), k));
  by('layer').value = String(filters.layer);
}

function writeChoices() {
  for (const speed of SPEEDS) option(by('speed'), speed + '\u00d7', speed);
  by('speed').value = String(SPEEDS.find(speed => total / speed <= 60) || 1000);
  for (const name of Object.keys(COLORINGS)) option(by('color-by'), name, name);
  option(by('operation'), 'all', -1);
  job.sections.forEach((_, s) => option(by('operation'), operationName(s), s));
  writeLayers();
}

/** Returns whether the address names a moment. */
function openAtHash() {
  const hash = new URLSearchParams(location.hash.slice(1)), line = moves.line.indexOf(Number(hash.get('line') || -1)),
        fault = Number(hash.get('fault') ?? -1);
  if (job.faults[fault]) goToFault(fault);
  else if (hash.has('t')) show(Number(hash.get('t')) || 0);
  else if (line >= 0) selectMove(line);
  else return false;
  return true;
}

/** The unit that the address names ("#unit=inch"), else mm. */
function openUnit() {
  if (new URLSearchParams(location.hash.slice(1)).get('unit') !== 'inch') return;
  unit = UNITS.inch;
  by('unit').value = 'inch';
}

/** The view that the address names ("#view=above"), else the whole part in space. */
function openView() {
  const name = new URLSearchParams(location.hash.slice(1)).get('view') ?? 'iso';
  chooseView(name === 'above' || Object.hasOwn(STANDPOINTS, name) ? name : 'iso');
}

if (new URLSearchParams(location.hash.slice(1)).has('framed')) document.body.classList.add('framed');
fullStock();
openUnit();
listenToProgram();
writeChoices();
writeHeader();
writeVerdict();
writeFeatures();
writeTimeline();
writeNow();
listen();
listenToStage();
seekBy(by('timeline'));
seekBy(by('plot'));
listenToSpace();
listenToChange();
colorMoves();
openView();
show(0);
if (!openAtHash() && !beLinked() && !matchMedia('(prefers-reduced-motion: reduce)').matches) play(true);
