// ---- What remains of the stock: a height for each cell of a grid, mm, the same for the flat picture and the view in space.
const [wx0, wy0, wx1, wy1] = job.world;
const CELLS = 1000;  // along the longer side
const depth = Math.max(job.top - job.bottom, 1e-6);
const NOTHING = -1e30;  // the height where there is no stock
const [sx0, sy0, sx1, sy1] = job.stock || job.world;
const overlay = by('overlay');

/** Made of so many cells per mm from its upper left corner; nothing is filled in yet. @type {(x0: number, y1: number, cells: number, columns: number, rows: number) => Grid} */
function newGrid(x0, y1, cells, columns, rows) {
  const column = (/** @type {number} */ x) => Math.max(0, Math.min(columns, Math.round((x - x0) * cells))),
        row = (/** @type {number} */ y) => Math.max(0, Math.min(rows, Math.round((y1 - y) * cells)));
  const size = {width: columns, height: rows};
  return {
    x0,
    y1,
    scale: cells,
    ...size,
    block: {x0: column(sx0), x1: column(sx1), y0: row(sy1), y1: row(sy0)},
    edges: [Math.max(sx0, x0), Math.max(sy0, y1 - rows / cells), Math.min(sx1, x0 + columns / cells), Math.min(sy1, y1)],
    heights: new Float32Array(columns * rows),
    ceilings: new Float32Array(earlier ? columns * rows : 0),
    ends: job.tools.map(tool => endOf(tool, cells)),
    dirty: everything(size),
    soiled: everything(size),
    relief: newCanvas(size),
    rests: null
  };
}

/** @type {(size: { width: number, height: number }) => HTMLCanvasElement} */
function newCanvas(size) {
  const canvas = document.createElement('canvas');
  canvas.width = size.width;
  canvas.height = size.height;
  return canvas;
}

/** @type {(context: Context2D, g: Grid) => void} */
function toWorld(context, g) { context.setTransform(g.scale, 0, 0, -g.scale, -g.x0 * g.scale, g.y1 * g.scale); }

/** The heights before the first move: the block less what was cut before. Of the grid that is cut. */
function fillStock() {
  if (earlier) noteHollows(earlier);
  fillBlock();
  if (earlier) cutEarlier(earlier, null);
}

function fillBlock() {
  const {heights: h, block: b, width: w} = grid;
  h.fill(NOTHING);
  for (let y = b.y0; y < b.y1; ++y) h.fill(job.top, y * w + b.x0, y * w + b.x1);
}

/** Cuts what was cut before, of the sections with that ceiling. @type {(before: Moves, below: number | null) => void} */
function cutEarlier(before, below) {
  for (let i = 0; i < before.kind.length; ++i)
    if (before.below[before.section[i]] === below) cut(i, 0, 1, before);
}

/** Notes where all is hollow under a ceiling: cutting down to it opens the hollow. @type {(before: Moves) => void} */
function noteHollows(before) {
  const h = grid.heights, found = new Float32Array(h.length).fill(-Infinity);
  grid.ceilings.fill(-Infinity);
  for (const below of new Set(before.below)) {
    if (below === null) continue;
    fillBlock();
    cutEarlier(before, below);
    for (let k = 0; k < h.length; ++k)
      if (h[k] !== NOTHING && h[k] < below) found[k] = Math.max(found[k], below);
  }
  grid.ceilings.set(found);
}

/** The heights of the whole before the first move. @type {Float32Array | null} */
let stockHeights = null;
function fullStock() {
  if (!stockHeights) {
    fillStock();
    stockHeights = heights.slice();
  }
  heights.set(stockHeights);
  under.move = -1;
}

const FINE = 16;
/** How far a cutter's end lies above its tip, by the distance from its axis in sixteenths of a cell; its reach in cells. @type {(tool: JobTool, cells: number) => CutterEnd} */
function endOf(tool, cells) {
  const radius = tool.d / 2, full = Math.ceil((radius * cells + 0.5) * FINE), above = new Float32Array(full + 1);
  for (let k = 0; k <= full; ++k) above[k] = endAt(tool, Math.min(radius, k / FINE / cells));
  return {above, full: radius * cells + 0.5, lip: above[full]};
}

/** @type {(tool: JobTool, r: number) => number} */
function endAt(tool, r) {
  if (tool.a !== null && tool.a > 0) return Math.max(0, r - tool.t / 2) / tool.a;
  const round = Math.min(tool.r, tool.d / 2), out = r - (tool.d / 2 - round);
  return out > 0 ? round - Math.sqrt(Math.max(0, round * round - out * out)) : 0;
}

// Cells that have changed since the flat picture and since the view in space were drawn last: `dirty` and `soiled`.
/** @type {(size: { width: number, height: number }) => CellBox} */
function everything(size) { return {x0: 0, y0: 0, x1: size.width, y1: size.height}; }
/** @type {(box: CellBox, x0: number, y0: number, x1: number, y1: number) => void} */
function grow(box, x0, y0, x1, y1) {
  box.x0 = Math.min(box.x0, x0);
  box.y0 = Math.min(box.y0, y0);
  box.x1 = Math.max(box.x1, x1);
  box.y1 = Math.max(box.y1, y1);
}
/** Marks what lies within a box in cells of the grid that is cut, and what a shadow of it may reach. @type {(box: CellBox) => void} */
function soil(box) {
  grow(grid.dirty, box.x0 - 9, box.y0 - 9, box.x1 + 9, box.y1 + 9);
  grow(grid.soiled, box.x0, box.y0, box.x1, box.y1);
}
function soilAll() { soil(everything(grid)); }
/** The changed cells as whole numbers within a grid, or null; from then on nothing is changed. @type {(box: CellBox, size: { width: number, height: number }) => CellPart | null} */
function taken(box, size) {
  const x0 = Math.max(0, Math.floor(box.x0)), y0 = Math.max(0, Math.floor(box.y0));
  const w = Math.min(size.width, Math.ceil(box.x1)) - x0, h = Math.min(size.height, Math.ceil(box.y1)) - y0;
  box.x0 = box.y0 = Infinity;
  box.x1 = box.y1 = -Infinity;
  return w > 0 && h > 0 ? {x0, y0, w, h} : null;
}

/** The whole stage, and the grid that is cut: it, or a finer one of what is in sight (lens.js). */
const whole = newGrid(wx0, wy1, CELLS / Math.max(wx1 - wx0, wy1 - wy0), ...sizeOfWhole());
const {scale, width, height, heights} = whole;
let grid = whole;

/** @type {() => [number, number]} */
function sizeOfWhole() {
  const cells = CELLS / Math.max(wx1 - wx0, wy1 - wy0);
  return [Math.max(1, Math.ceil((wx1 - wx0) * cells)), Math.max(1, Math.ceil((wy1 - wy0) * cells))];
}

/** What `action` cuts is cut in another grid. @type {(other: Grid, action: () => void) => void} */
function inGrid(other, action) {
  grid = other;
  try {
    action();
  } finally { grid = whole; }
}

/**
 * Plan of move i of m between fractions f and g in cells; rows grow downwards, which turns arcs the other way.
 * @type {(i: number, f: number, g: number, m: Moves) => Strip}
 */
function stripOf(i, f, g, m) {
  const p = pointAt(i, f, m), q = pointAt(i, g, m), {x0, y1, scale: cells} = grid;
  const column = (/** @type {number} */ x) => (x - x0) * cells - 0.5, row = (/** @type {number} */ y) => (y1 - y) * cells - 0.5;
  /** @type {Strip} */
  const strip = {ax: column(p.x), ay: row(p.y), bx: column(q.x), by: row(q.y), arc: null};
  if (m.turn[i] !== 0) {
    const arc = arcOf(i, m), from = -(arc.a + arc.sweep * f), to = -(arc.a + arc.sweep * g), back = to < from;
    strip.arc = {x: column(m.cx[i]), y: row(m.cy[i]), r: arc.r * cells, from: back ? to : from, sweep: Math.abs(to - from)};
  }
  return strip;
}

/** The smallest box around a strip's middle line. @type {(strip: Strip) => CellBox} */
function boxOf(strip) {
  const box = {
    x0: Math.min(strip.ax, strip.bx),
    x1: Math.max(strip.ax, strip.bx),
    y0: Math.min(strip.ay, strip.by),
    y1: Math.max(strip.ay, strip.by)
  };
  const arc = strip.arc, full = 2 * Math.PI;
  for (let quarter = 0; arc && quarter < 4; ++quarter) {
    const angle = quarter * Math.PI / 2, turned = ((angle - arc.from) % full + full) % full;
    if (turned > arc.sweep) continue;
    const x = arc.x + arc.r * Math.cos(angle), y = arc.y + arc.r * Math.sin(angle);
    grow(box, x, y, x, y);
  }
  return box;
}

/**
 * Lowers a cell to the cutter's end, whose tip is at z and whose axis passes at a distance in cells. Cutters are half a cell wider
 * than they are, and their flank rises over one cell: what two strips leave that touch is no ridge, and walls are no staircases.
 * @type {(k: number, distance: number, z: number, end: CutterEnd) => void}
 */
function lower(k, distance, z, end) {
  let h = z;
  if (distance <= end.full) {
    h += end.above[Math.round(distance * FINE)];
    if (earlier && h <= grid.ceilings[k]) h = NOTHING;
  } else if (distance < end.full + 1) h += end.lip + (job.top - z - end.lip) * (distance - end.full);
  else return;
  if (h < grid.heights[k]) grid.heights[k] = h;
}

/** @type {(box: CellBox, reach: number) => [number, number]} */
const rowsOf =
  (box, reach) => [Math.max(grid.block.y0, Math.ceil(box.y0 - reach)), Math.min(grid.block.y1 - 1, Math.floor(box.y1 + reach))];
/** @type {(from: number, to: number) => [number, number]} */
const columnsIn = (from, to) => [Math.max(grid.block.x0, Math.ceil(from)), Math.min(grid.block.x1 - 1, Math.floor(to))];

/** @type {(strip: Strip, z: number, end: CutterEnd) => void} */
function cutLine(strip, z, end) {
  const {ax, ay} = strip, {heights: present, width: across} = grid, reach = end.full + 1, length = Math.hypot(strip.bx - ax, strip.by - ay);
  const ux = length > 0 ? (strip.bx - ax) / length : 1, uy = length > 0 ? (strip.by - ay) / length : 0;
  const box = boxOf(strip), [first, last] = rowsOf(box, reach);
  for (let y = first; y <= last; ++y) {
    // Within reach of the infinite line: between two columns.
    const middle = Math.abs(uy) > 1e-9 ? ax + (y - ay) * ux / uy : ax, half = Math.abs(uy) > 1e-9 ? reach / Math.abs(uy) : Infinity;
    const [from, to] = columnsIn(Math.max(box.x0 - reach, middle - half), Math.min(box.x1 + reach, middle + half));
    for (let x = from, k = y * across + from; x <= to; ++x, ++k) {
      if (present[k] <= z) continue;
      const along = Math.max(0, Math.min(length, (x - ax) * ux + (y - ay) * uy)), dx = x - ax - along * ux, dy = y - ay - along * uy;
      lower(k, Math.sqrt(dx * dx + dy * dy), z, end);
    }
  }
}

/** @type {(strip: Strip, arc: NonNullable<Strip['arc']>, z: number, end: CutterEnd) => void} */
function cutArc(strip, arc, z, end) {
  const {heights: present, width: across} = grid, reach = end.full + 1, box = boxOf(strip), [first, last] = rowsOf(box, reach);
  const fx = Math.cos(arc.from), fy = Math.sin(arc.from), tx = Math.cos(arc.from + arc.sweep), ty = Math.sin(arc.from + arc.sweep);
  const wide = arc.sweep >= Math.PI, whole = arc.sweep >= 2 * Math.PI - 1e-9, hole = arc.r - reach;
  for (let y = first; y <= last; ++y) {
    const dy = y - arc.y, outer = (arc.r + reach) ** 2 - dy * dy, inner = hole > 0 ? hole * hole - dy * dy : 0;
    if (outer < 0) continue;
    const span = Math.sqrt(outer), gap = inner > 0 ? Math.sqrt(inner) : 0;
    const [from, to] = columnsIn(Math.max(box.x0 - reach, arc.x - span), Math.min(box.x1 + reach, arc.x + span));
    for (let x = from, k = y * across + from; x <= to; ++x, ++k) {
      const dx = x - arc.x;
      if (present[k] <= z || Math.abs(dx) < gap) continue;
      const after = fx * dy - fy * dx >= 0, before = dx * ty - dy * tx >= 0;
      const d = whole || (wide ? after || before : after && before) ?
        Math.abs(Math.sqrt(dx * dx + dy * dy) - arc.r) :
        Math.min(Math.hypot(x - strip.ax, y - strip.ay), Math.hypot(x - strip.bx, y - strip.by));
      lower(k, d, z, end);
    }
  }
}

/**
 * Takes away what move i of m cuts between fractions f and g. Slopes go down in steps, each as deep as its lower end.
 * @type {(i: number, f: number, g: number, m?: Moves) => void}
 */
function cut(i, f, g, m = moves) {
  const tool = m.tools[m.section[i]];
  if (tool < 0 || Math.min(m.z0[i], m.z1[i]) >= job.top || g <= f) return;
  const reached = reachOfMove(i, m);
  if (!meetsBlock(reached)) return;
  const end = grid.ends[tool], drop = Math.abs(m.z1[i] - m.z0[i]);
  const vertical = m.x0[i] === m.x1[i] && m.y0[i] === m.y1[i] && m.turn[i] === 0;
  const pieces = vertical ? 1 : Math.min(100, Math.max(1, Math.ceil(drop / 0.05)));
  for (let k = 0; k < pieces; ++k) {
    const a = Math.max(f, k / pieces), b = Math.min(g, (k + 1) / pieces);
    if (b <= a) continue;
    const strip = stripOf(i, a, b, m), z = Math.min(pointAt(i, a, m).z, pointAt(i, b, m).z);
    if (z >= job.top) continue;
    if (strip.arc) cutArc(strip, strip.arc, z, end);
    else cutLine(strip, z, end);
  }
  soil(reached);
}

/** Whether there is stock of the grid within a box. @type {(box: CellBox) => boolean} */
const meetsBlock = box => box.x1 >= grid.block.x0 && box.x0 < grid.block.x1 && box.y1 >= grid.block.y0 && box.y0 < grid.block.y1;

/** The cells that move i of m may change. @type {(i: number, m?: Moves) => CellBox} */
function reachOfMove(i, m = moves) {
  const box = boxOf(stripOf(i, 0, 1, m)), reach = grid.ends[m.tools[m.section[i]]].full + 2;
  return {x0: box.x0 - reach, y0: box.y0 - reach, x1: box.x1 + reach, y1: box.y1 + reach};
}

// What lay under the move that is under way. It is put back before that move goes on, so that the heights depend on the
// moment alone, not on the way there.
/** @type {{ move: number, box: CellPart, heights: Float32Array }} */
const under = {
  move: -1,
  box: {x0: 0, y0: 0, w: 0, h: 0},
  heights: new Float32Array(0)
};

/** @type {(i: number, f: number) => void} */
function cutPart(i, f) {
  putBack();
  if (moves.tools[moves.section[i]] < 0 || f <= 0) return;
  const changed = {...reachOfMove(i)}, box = taken(changed, whole);
  if (!box) return;
  under.move = i;
  under.box = box;
  if (under.heights.length < box.w * box.h) under.heights = new Float32Array(box.w * box.h);
  for (let y = 0; y < box.h; ++y) {
    const from = (box.y0 + y) * width + box.x0;
    under.heights.set(heights.subarray(from, from + box.w), y * box.w);
  }
  cut(i, 0, f);
}

function putBack() {
  if (under.move < 0) return;
  const box = under.box;
  for (let y = 0; y < box.h; ++y) heights.set(under.heights.subarray(y * box.w, (y + 1) * box.w), (box.y0 + y) * width + box.x0);
  soil(reachOfMove(under.move));
  under.move = -1;
}
