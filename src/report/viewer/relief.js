// ---- The heights.
const [wx0, wy0, wx1, wy1] = job.world;
const PIXELS = 1000;
const scale = PIXELS / Math.max(wx1 - wx0, wy1 - wy0);
const width = Math.max(1, Math.ceil((wx1 - wx0) * scale)), height = Math.max(1, Math.ceil((wy1 - wy0) * scale));
const depth = Math.max(job.top - job.bottom, 1e-6);
const heights = newCanvas(), heightContext = heights.getContext('2d', { willReadFrequently: true });
const relief = newCanvas(), overlay = by('overlay');
const reliefContext = relief.getContext('2d');

function newCanvas() {
  const canvas = document.createElement('canvas');
  canvas.width = width; canvas.height = height;
  return canvas;
}

function toWorld(context, k) { context.setTransform(scale * k, 0, 0, -scale * k, -wx0 * scale * k, wy1 * scale * k); }

function grey(z) {
  const level = Math.max(0, Math.min(255, Math.round(255 * (z - job.bottom) / depth)));
  return 'rgb(' + level + ',' + level + ',' + level + ')';
}

function fullStock() {
  const c = heightContext;
  c.restore(); c.save();
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.globalCompositeOperation = 'source-over';
  c.clearRect(0, 0, width, height);
  toWorld(c, 1);
  c.beginPath();
  if (job.stock) c.rect(job.stock[0], job.stock[1], job.stock[2] - job.stock[0], job.stock[3] - job.stock[1]);
  else c.rect(wx0, wy0, wx1 - wx0, wy1 - wy0);
  c.fillStyle = '#fff';
  c.fill();
  c.clip();
  c.globalCompositeOperation = 'darken';
  c.lineCap = c.lineJoin = 'round';
}

/** Discs that make up the end of a tool: radius and height above the tip, largest first. */
const endsOfTools = job.tools.map(tool => {
  const r = Math.min(tool.r || 0, tool.d / 2), steps = r > 0 ? 8 : 0, discs = [];
  for (let k = steps; k >= 0; --k) {
    const a = steps ? k / steps * Math.PI / 2 : 0;
    discs.push([tool.d / 2 - r + r * Math.sin(a), r - r * Math.cos(a)]);
  }
  return discs.filter(disc => disc[0] > 0);
});

const dirty = { x0: 0, y0: 0, x1: width, y1: height };
function soil(x0, y0, x1, y1) {
  dirty.x0 = Math.min(dirty.x0, x0); dirty.y0 = Math.min(dirty.y0, y0);
  dirty.x1 = Math.max(dirty.x1, x1); dirty.y1 = Math.max(dirty.y1, y1);
}
function soilAll() { soil(0, 0, width, height); }

function soilMove(i, radius) {
  let x0 = Math.min(moves.x0[i], moves.x1[i]), x1 = Math.max(moves.x0[i], moves.x1[i]);
  let y0 = Math.min(moves.y0[i], moves.y1[i]), y1 = Math.max(moves.y0[i], moves.y1[i]);
  if (moves.turn[i] !== 0) {
    const r = arcOf(i).r;
    x0 = moves.cx[i] - r; x1 = moves.cx[i] + r; y0 = moves.cy[i] - r; y1 = moves.cy[i] + r;
  }
  soil((x0 - radius - wx0) * scale - 9, (wy1 - y1 - radius) * scale - 9, (x1 + radius - wx0) * scale + 9, (wy1 - y0 + radius) * scale + 9);
}

/**
 * Takes away what move i cuts between fractions f and g. Ramps go down in steps of a quarter of a millimetre. Strips are
 * a pixel wider than the cutter, so that the soft edges of two strips that meet leave no ridge that is not there.
 */
function cut(i, f, g) {
  const tool = job.sections[moves.section[i]].tool;
  if (tool < 0 || Math.min(moves.z0[i], moves.z1[i]) >= job.top || g <= f) return;
  const c = heightContext, drop = Math.abs(moves.z1[i] - moves.z0[i]) * (g - f);
  const vertical = moves.x0[i] === moves.x1[i] && moves.y0[i] === moves.y1[i] && moves.turn[i] === 0;
  const pieces = vertical ? 1 : Math.min(80, Math.max(1, Math.ceil(drop / 0.25)));
  for (const [radius, above] of endsOfTools[tool]) {
    for (let k = 0; k < pieces; ++k) {
      const a = f + (g - f) * k / pieces, b = f + (g - f) * (k + 1) / pieces;
      c.beginPath();
      if (vertical) {
        c.arc(moves.x0[i], moves.y0[i], radius + 0.5 / scale, 0, 2 * Math.PI);
        c.fillStyle = grey(Math.min(pointAt(i, a).z, pointAt(i, b).z) + above);
        c.fill();
      } else {
        trace(c, i, a, b);
        c.lineWidth = 2 * radius + 1 / scale;
        c.strokeStyle = grey((pointAt(i, a).z + pointAt(i, b).z) / 2 + above);
        c.stroke();
      }
    }
  }
  soilMove(i, job.tools[tool].d / 2);
}
