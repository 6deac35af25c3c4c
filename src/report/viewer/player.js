// ---- Playing.
const SPEEDS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
let playing = false, lastFrame = 0;

function show(time) { goTo(time); redraw(); }
function redraw() { shade(); drawOverlay(); updateNow(); }

function frame(now) {
  if (!playing) return;
  const step = Math.min(0.1, (now - lastFrame) / 1000) * Number(by('speed').value);
  lastFrame = now;
  goTo(at.time + step);
  if (at.time >= total) playing = false;
  redraw();
  requestAnimationFrame(frame);
}

function play(on) {
  if (on && at.time >= total) goTo(0);
  playing = on;
  lastFrame = performance.now();
  updateNow();
  if (on) requestAnimationFrame(frame);
}

/** One move on or back, to the end of a move. */
function stepMove(by_) {
  play(false);
  const i = by_ > 0 ? at.move + 1 : at.fraction > 1e-9 ? at.move : at.move - 1;
  show(moves.t[Math.max(0, Math.min(count, i))]);
}

function listen() {
  for (const speed of SPEEDS) element('option', speed + '\u00d7', by('speed')).value = speed;
  by('speed').value = SPEEDS.find(speed => total / speed <= 60) || 1000;
  by('play').onclick = () => play(!playing);
  by('scrub').oninput = () => show(total * by('scrub').value / 100000);
  by('path').onchange = redraw;
  window.onresize = redraw;
  window.onhashchange = openAtHash;
  document.onkeydown = event => {
    if (event.target.tagName === 'SELECT' || event.target.tagName === 'INPUT') return;
    if (event.key === ' ' && event.target.tagName !== 'BUTTON') { play(!playing); event.preventDefault(); }
    if (event.key === 'ArrowRight') stepMove(1);
    if (event.key === 'ArrowLeft') stepMove(-1);
  };
}

/** Returns whether the address names a moment. */
function openAtHash() {
  const hash = new URLSearchParams(location.hash.slice(1)), line = moves.line.indexOf(Number(hash.get('line') || -1));
  if (hash.has('fault') && job.faults[hash.get('fault')]) by('faults').children[hash.get('fault')].click();
  else if (hash.has('t')) show(Number(hash.get('t')) || 0);
  else if (line >= 0) show(moves.t[line + 1]);
  else return false;
  return true;
}

by('stage').style.aspectRatio = width + ' / ' + height;
by('stage').style.maxHeight = '78vh';
by('stage').style.margin = '0 auto';
by('stage').style.maxWidth = 'calc(78vh * ' + width / height + ')';
fullStock();
writeHeader(); writeFeatures(); writeFaults(); writeTimeline(); writeNow(); listen();
show(0);
if (!openAtHash() && !matchMedia('(prefers-reduced-motion: reduce)').matches) play(true);
