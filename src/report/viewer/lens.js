// ---- What is in sight, where one has zoomed in: a grid of finer cells, of that window alone. It is cut anew from the moves when all
// is at rest, so it depends on the window and the moment only; while something moves, the grid of the whole is drawn.
const MOST_CELLS = 300000;  // of the window: what one processor cuts and draws in some tenths of a second
const FINEST = 1000;        // cells per mm: moves are known to a micrometre
const LONGEST = 4000;       // cells along a side, which corners of the surface have bits for
const REST = 150;           // ms without a change
/**
 * `start`: its heights before the first move; `passed`: after so many whole moves; `time`: the moment that it shows.
 * @type {{ grid: Grid | null, key: string, start: Float32Array, passed: Float32Array, moves: number, time: number, on: boolean }}
 */
const lens = {
  grid: null,
  key: '',
  start: new Float32Array(0),
  passed: new Float32Array(0),
  moves: 0,
  time: -1,
  on: false
};

/** Where the ray through a point of the stage meets a level, mm. @type {(s: Point, z: number) => Place} */
function onLevel(s, z) {
  if (!space.on) return toPlan(s);
  const near = cameraAxes().near, p = onMiddlePlane(s), t = (z - p.z) / near[2];
  return {x: p.x + near[0] * t, y: p.y + near[1] * t, z};
}

/** Plan of the stock that the stage shows; null: none, or seen from the side. @type {() => Corners | null} */
function stockInSight() {
  if (space.on && Math.abs(cameraAxes().near[2]) < 0.1) return null;
  const corners =
    [[0, 0], [view.w, 0], [0, view.h], [view.w, view.h]].flatMap(([x, y]) => [job.top, job.bottom].map(z => onLevel({x, y}, z)));
  const xs = corners.map(p => p.x), ys = corners.map(p => p.y);
  /** @type {Corners} */
  const box =
    [Math.max(sx0, Math.min(...xs)), Math.max(sy0, Math.min(...ys)), Math.min(sx1, Math.max(...xs)), Math.min(sy1, Math.max(...ys))];
  return box[2] > box[0] && box[3] > box[1] ? box : null;
}

/** The window that is to be refined, and its cells per mm; null where the cells of the whole do. @type {() => { box: Corners, cells: number, key: string } | null} */
function wantedLens() {
  const box = stockInSight();
  if (!box || change.grid) return null;  // both sides of a curtain in cells of one size
  const w = box[2] - box[0], h = box[3] - box[1], pixels = (space.on ? camera.k : view.k) * view.ratio;
  const cells = Math.min(pixels, FINEST, Math.sqrt(MOST_CELLS / (w * h)), LONGEST / Math.max(w, h));
  return cells > 1.3 * scale && w * cells > 3 && h * cells > 3 ? {box, cells, key: [...box, cells].join()} : null;
}

/** Whether the window's own grid has still to be cut. */
function lensIsDue() {
  const wanted = wantedLens();
  lens.on = wanted !== null && lens.grid !== null && lens.key === wanted.key && lens.time === at.time;
  return wanted !== null && !lens.on;
}

/** The grid to be drawn and asked. */
const gridInSight = () => lens.on && lens.grid ? lens.grid : whole;

/** Cuts the window's grid up to the moment: on from where it was, or from the beginning. */
function refine() {
  const wanted = wantedLens();
  if (!wanted || !lensIsDue()) return;
  if (lens.key !== wanted.key || !lens.grid) {
    const {box, cells} = wanted;
    lens.grid = newGrid(box[0], box[3], cells, Math.ceil((box[2] - box[0]) * cells), Math.ceil((box[3] - box[1]) * cells));
    lens.key = wanted.key;
    inGrid(lens.grid, fillStock);
    lens.start = lens.grid.heights.slice();
    lens.passed = lens.start.slice();
    lens.moves = 0;
  }
  const present = lens.grid.heights;
  if (at.move < lens.moves) {
    lens.passed.set(lens.start);
    lens.moves = 0;
  }
  present.set(lens.passed);
  inGrid(lens.grid, () => {
    for (; lens.moves < at.move; ++lens.moves) cut(lens.moves, 0, 1);
    lens.passed.set(present);
    if (at.move < count) cut(at.move, 0, at.fraction);
    soilAll();
  });
  lens.time = at.time;
  lens.on = true;
}
