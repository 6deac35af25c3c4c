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

function show(time, keepMark) {
  selected = -1;
  if (!keepMark) unmark();
  goTo(time);
  redraw();
}
/** Shows the end of move i. */
function selectMove(i, keepMark) {
  play(false);
  if (!keepMark) unmark();
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
  if (space.on) { drawSpace(); drawSpaceOverlay(); } else { shade(); drawOverlay(); }
  // Turning and zooming change no figure, and writing the same ones again costs as much as the picture.
  const key = [at.time, selected, playing, unit.name, dark.matches, by('plot').clientWidth, by('plot').clientHeight, window.devicePixelRatio].join();
  if (key === figuresKey) return;
  figuresKey = key;
  updateNow(); drawPlot();
}
function redrawSoon() {
  if (redrawAsked) return;
  redrawAsked = true;
  requestAnimationFrame(() => { redrawAsked = false; redraw(); });
}

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

function play(on) {
  if (on === playing) return;
  if (on && at.time >= total) goTo(0);
  if (on) unmark();
  playing = on;
  lastFrame = performance.now();
  updateNow();
  if (on) requestAnimationFrame(frame);
}

/** To the end of the move under way, or one move on or back. */
function stepMove(by_) {
  const i = shownMove(), next = by_ > 0 && shownFraction() > 0 && shownFraction() < 1 ? i : i + by_;
  if (next < 0) { play(false); show(0); } else selectMove(Math.min(count - 1, next));
}

const TURN = 15;  // degrees
const TURNS = { ArrowRight: [TURN, 0], ArrowLeft: [-TURN, 0], ArrowUp: [0, TURN], ArrowDown: [0, -TURN] };
const KEYS = { ' ': () => play(!playing), ArrowRight: () => stepMove(1), ArrowLeft: () => stepMove(-1), Home: () => show(0), End: () => show(total),
  '+': () => zoom(1.5), '=': () => zoom(1.5), '-': () => zoom(1 / 1.5), '0': () => by('fit').click(), 'm': () => setMeasuring(!measure.on),
  'Escape': () => setMeasuring(false) };
function keyPressed(event) {
  const on = event.target.tagName;
  if (event.ctrlKey || event.metaKey || event.altKey || on === 'SELECT' || count === 0) return;
  if (on === 'INPUT' && (event.target.type !== 'range' || event.key !== ' ')) return;
  if (on === 'BUTTON' && event.key === ' ') return;
  const turn = event.shiftKey && space.on ? TURNS[event.key] : undefined, action = turn ? () => orbit(...turn) : KEYS[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

function listen() {
  by('play').onclick = () => play(!playing);
  by('back').onclick = () => stepMove(-1);
  by('forward').onclick = () => stepMove(1);
  by('scrub').oninput = () => show(total * by('scrub').value / 100000);
  by('path').onchange = redraw;
  by('color-by').onchange = () => {
    if (by('color-by').value !== 'kind' && by('path').value !== 'all') by('path').value = 'all';
    colorMoves(); redraw();
  };
  const filter = change => () => { change(); ++pictureVersion; redraw(); };
  by('rapids').onchange = filter(() => { filters.rapids = by('rapids').checked; });
  by('operation').onchange = filter(() => { filters.operation = Number(by('operation').value); });
  by('layer').onchange = filter(() => { filters.layer = Number(by('layer').value); });
  by('unit').onchange = () => { unit = UNITS[by('unit').value]; writeHeader(); writeFeatures(); writeLayers(); writeMeasured(); colorMoves(); chooseSection(true); redraw(); };
  window.onresize = () => { drawProgram(); redraw(); };
  window.onhashchange = openAtHash;
  dark.onchange = () => { colorMoves(); redraw(); };
  document.onkeydown = keyPressed;
}

function option(select, words, value) { element('option', words, select).value = value; }

function writeLayers() {
  by('layer').replaceChildren();
  option(by('layer'), 'all', -1);
  layerHeights.forEach((milli, k) => option(by('layer'), 'z ' + bare(milli / 1000, 2), k));
  by('layer').value = filters.layer;
}

function writeChoices() {
  for (const speed of SPEEDS) option(by('speed'), speed + '\u00d7', speed);
  by('speed').value = SPEEDS.find(speed => total / speed <= 60) || 1000;
  for (const name of Object.keys(COLORINGS)) option(by('color-by'), name, name);
  option(by('operation'), 'all', -1);
  job.sections.forEach((section, s) => option(by('operation'), section.label || 'operation ' + (s + 1), s));
  writeLayers();
}

/** Returns whether the address names a moment. */
function openAtHash() {
  const hash = new URLSearchParams(location.hash.slice(1)), line = moves.line.indexOf(Number(hash.get('line') || -1));
  if (hash.has('fault') && job.faults[hash.get('fault')]) goToFault(Number(hash.get('fault')));
  else if (hash.has('t')) show(Number(hash.get('t')) || 0);
  else if (line >= 0) selectMove(line);
  else return false;
  return true;
}

/** The view that the address names ("#view=above"), else the whole part in space. */
function openView() {
  const name = new URLSearchParams(location.hash.slice(1)).get('view');
  chooseView(name === 'above' || STANDPOINTS[name] ? name : 'iso');
}

fullStock();
listenToProgram(); writeChoices(); writeHeader(); writeVerdict(); writeFeatures(); writeTimeline(); writeNow();
listen(); listenToStage(); seekBy(by('timeline')); seekBy(by('plot'));
listenToSpace();
colorMoves();
openView();
show(0);
if (!openAtHash() && !matchMedia('(prefers-reduced-motion: reduce)').matches) play(true);
