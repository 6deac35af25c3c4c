// ---- What of the part is seen: zoom, pan, a click on the path, a distance.
const view = {
  x: 0,
  y: 0,
  k: 1,
  w: 1,
  h: 1,
  ratio: 1
};                            // the middle in mm; pixels per mm; the stage in pixels
const NEAR = 8, MOST = 4000;  // pixels around a click; pixels per mm
/** @type {Map<number, Point>} */
const pointers = new Map();
let dragged = 0, fitted = true;
/** @type {{ on: boolean, from: Place | null, to: Place | null }} */
const measure = {
  on: false,
  from: null,
  to: null
};

/** @type {(p: Point & { z?: number }) => Point} */
const toScreen = p => space.on ? projected(p) : ({x: view.w / 2 + (p.x - view.x) * view.k, y: view.h / 2 - (p.y - view.y) * view.k});
/** @type {(p: Point) => Place} */
const toPlan = p => ({x: view.x + (p.x - view.w / 2) / view.k, y: view.y - (p.y - view.h / 2) / view.k, z: 0});
/** @type {(c: Context2D) => void} */
function setPlan(c) {
  const k = view.k * view.ratio;
  c.setTransform(k, 0, 0, -k, (view.w / 2 - view.x * view.k) * view.ratio, (view.h / 2 + view.y * view.k) * view.ratio);
}

/** Pixels that the buttons take at the top of the stage and at its foot. */
const BARS = 40;
/** What of the stage's height the whole is fitted into. */
const freeHeight = () => Math.max(view.h - 2 * BARS, view.h / 2);
const wholeScale = () => Math.min(0.94 * view.w / (wx1 - wx0), freeHeight() / (wy1 - wy0));
function fit() {
  view.x = (wx0 + wx1) / 2;
  view.y = (wy0 + wy1) / 2;
  view.k = wholeScale();
  fitted = true;
}

/** Reads the size of the stage; what was seen whole stays so. */
function measureStage() {
  view.w = Math.max(1, overlay.clientWidth);
  view.h = Math.max(1, overlay.clientHeight);
  view.ratio = window.devicePixelRatio || 1;
  const w = Math.round(view.w * view.ratio), h = Math.round(view.h * view.ratio);
  if (overlay.width !== w || overlay.height !== h) {
    overlay.width = w;
    overlay.height = h;
  }
  if (fitted) fit();
  if (space.on && camera.fitted) fitSpace();
}

/** @type {(factor: number, at_?: Point) => void} */
function zoom(factor, at_ = {
  x: view.w / 2,
  y: view.h / 2
}) {
  if (space.on) {
    zoomSpace(factor, at_);
    return;
  }
  const fixedPoint = toPlan(at_);
  view.k = Math.max(wholeScale() / 4, Math.min(MOST, view.k * factor));
  const now = toPlan(at_);
  view.x += fixedPoint.x - now.x;
  view.y += fixedPoint.y - now.y;
  fitted = false;
  redrawSoon();
}

/** Moves the view only if the place is outside of it. @type {(p: Place) => void} */
function bringIntoView(p) {
  const s = toScreen(p);
  if (s.x > 20 && s.y > 20 && s.x < view.w - 20 && s.y < view.h - 20) return;
  if (space.on) {
    camera.x = p.x;
    camera.y = p.y;
    camera.z = p.z;
    camera.fitted = false;
    return;
  }
  view.x = p.x;
  view.y = p.y;
  fitted = false;
}

/** mm from p to move i in plan. @type {(i: number, p: Point) => number} */
function distanceToMove(i, p) {
  const x0 = moves.x0[i], y0 = moves.y0[i], dx = moves.x1[i] - x0, dy = moves.y1[i] - y0;
  if (moves.turn[i] === 0) {
    const squared = dx * dx + dy * dy, f = squared > 0 ? Math.max(0, Math.min(1, ((p.x - x0) * dx + (p.y - y0) * dy) / squared)) : 0;
    return Math.hypot(x0 + f * dx - p.x, y0 + f * dy - p.y);
  }
  const arc = arcOf(i), angle = Math.atan2(p.y - moves.cy[i], p.x - moves.cx[i]), full = 2 * Math.PI;
  const turned = ((moves.turn[i] * (angle - arc.a)) % full + full) % full;
  if (turned <= Math.abs(arc.sweep)) return Math.abs(Math.hypot(p.x - moves.cx[i], p.y - moves.cy[i]) - arc.r);
  return Math.min(Math.hypot(x0 - p.x, y0 - p.y), Math.hypot(moves.x1[i] - p.x, moves.y1[i] - p.y));
}

/** The move that is drawn nearest to p; of several that lie on each other the one nearest in time. -1: none is near. @type {(p: Point) => number} */
function moveNear(p) {
  const limit = NEAR / view.k, same = 0.5 / view.k;
  const last = by('path').value === 'recent' ? shownMove() : count - 1,
        first = by('path').value === 'recent' ? Math.max(0, last - TRAIL) : 0;
  let best = -1, nearest = limit;
  for (let i = by('path').value === 'none' ? count : first; i <= last; ++i) {
    if (!shown(i)) continue;
    const d = distanceToMove(i, p);
    if (d > nearest + same || d > limit) continue;
    if (best < 0 || d < nearest - same || Math.abs(moves.t[i] - at.time) <= Math.abs(moves.t[best] - at.time)) best = i;
    nearest = Math.min(nearest, d);
  }
  return best;
}

/** @type {(on: boolean) => void} */
function setMeasuring(on) {
  measure.on = on;
  measure.from = measure.to = null;
  by('measure').setAttribute('aria-pressed', String(on));
  overlay.classList.toggle('measuring', on);
  writeMeasured();
  redrawSoon();
}

function writeMeasured() {
  by('measured').hidden = !measure.on;
  if (!measure.from) by('measured').textContent = space.on ? 'click on two points of the material' : 'click on two points';
  else if (!measure.to)
    by('measured').textContent = 'x ' + bare(measure.from.x, 3) + '  y ' + lengthText(measure.from.y, 3) + ', click on the second point';
  else {
    const dx = measure.to.x - measure.from.x, dy = measure.to.y - measure.from.y, dz = space.on ? measure.to.z - measure.from.z : 0;
    by('measured').textContent =
      lengthText(Math.hypot(dx, dy, dz), 3) + ' (x ' + bare(dx, 3) + ', y ' + bare(dy, 3) + (space.on ? ', z ' + bare(dz, 3) : '') + ')';
  }
}

/** @type {(s: Point) => void} */
function clickAt(s) {
  if (measure.on) {
    const p = space.on ? surfaceAt(s) : toPlan(s);
    if (!p) return;
    if (!measure.from || measure.to) {
      measure.from = p;
      measure.to = null;
    } else measure.to = p;
    writeMeasured();
    redrawSoon();
    return;
  }
  const i = space.on ? moveNearInSpace(s) : moveNear(toPlan(s));
  if (i >= 0) selectMove(i);
}

/** @type {(event: MouseEvent) => Point} */
const placeOf = event => {
  const box = overlay.getBoundingClientRect();
  return {x: event.clientX - box.left, y: event.clientY - box.top};
};

/** One pointer drags, two pinch. @type {(event: PointerEvent) => void} */
function pointerMoved(event) {
  const was = pointers.get(event.pointerId), now = placeOf(event), other = [...pointers.entries()].find(([id]) => id !== event.pointerId);
  if (!was) return;
  dragged += Math.hypot(now.x - was.x, now.y - was.y);
  pointers.set(event.pointerId, now);
  if (dragged < 4) return;
  if (other) {
    const q = other[1], before = Math.hypot(was.x - q.x, was.y - q.y), after = Math.hypot(now.x - q.x, now.y - q.y);
    if (before > 1) zoom(after / before, {x: (now.x + q.x) / 2, y: (now.y + q.y) / 2});
  }
  const share = other ? 2 : 1;
  if (space.on) {
    dragInSpace(event, (now.x - was.x) / share, (now.y - was.y) / share, Boolean(other));
    return;
  }
  view.x -= (now.x - was.x) / view.k / share;
  view.y += (now.y - was.y) / view.k / share;
  fitted = false;
  redrawSoon();
}

/** One pointer turns the part; two, Shift, or another button than the first move it. @type {(event: PointerEvent, dx: number, dy: number, moves_: boolean) => void} */
function dragInSpace(event, dx, dy, moves_) {
  if (moves_ || event.shiftKey || (event.buttons & 6)) panSpace(dx, dy);
  else orbit(-0.4 * dx, 0.4 * dy);
}

function listenToStage() {
  overlay.addEventListener('wheel', event => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)), placeOf(event));
  }, {passive: false});
  overlay.onpointerdown = event => {
    if (pointers.size === 0) dragged = 0;
    pointers.set(event.pointerId, placeOf(event));
    overlay.setPointerCapture(event.pointerId);
  };
  overlay.onpointermove = pointerMoved;
  overlay.onpointercancel = event => pointers.delete(event.pointerId);
  overlay.onpointerup = event => {
    if (pointers.delete(event.pointerId) && pointers.size === 0 && dragged < 4) clickAt(placeOf(event));
  };
  by('zoom-in').onclick = () => zoom(1.5);
  by('zoom-out').onclick = () => zoom(1 / 1.5);
  by('fit').onclick = () => {
    if (space.on) fitSpace();
    else fit();
    redrawSoon();
  };
  by('measure').onclick = () => setMeasuring(!measure.on);
}
