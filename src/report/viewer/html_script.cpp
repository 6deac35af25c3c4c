#include "report/viewer/html_page.h"

namespace clearcut::report {

// Heights live in a grey canvas, white at the top of the part and black at its lowest cut: a strip painted in
// the mode "darken" leaves the lower of what was there and what is cut, which is what a cutter does.
const char* const kHtmlScript = R"js(
'use strict';
const job = JSON.parse(document.getElementById('job').textContent);
const by = id => document.getElementById(id);
const KINDS = ['rapid', 'plunge', 'ramp', 'lead-in', 'cut', 'lead-out', 'link', 'retract'];
const css = name => getComputedStyle(document.documentElement).getPropertyValue('--' + name);
const LINE_COLORS = ['rapid', 'entry', 'entry', 'cut', 'cut', 'cut', 'link', 'link'].map(css);

// ---- Moves: columns of differences become absolute values, mm and seconds.
const count = job.kinds.length;
const moves = decodeMoves();

function decodeMoves() {
  const m = { kind: new Uint8Array(count), x0: new Float64Array(count), y0: new Float64Array(count), z0: new Float64Array(count),
    x1: new Float64Array(count), y1: new Float64Array(count), z1: new Float64Array(count), t: new Float64Array(count + 1),
    line: new Int32Array(count), feed: new Float64Array(count), section: new Uint32Array(count),
    cx: new Float64Array(count), cy: new Float64Array(count), turn: new Int8Array(count) };
  let x = 0, y = 0, z = 0, line = 0, ticks = 0, start = 0, feedAt = 0, feed = 0, section = -1;
  for (let i = 0; i < count; ++i) {
    if (start < job.starts.length && job.starts[start][0] === i) [, x, y, z] = job.starts[start++];
    if (feedAt < job.feeds.length && job.feeds[feedAt][0] === i) feed = job.feeds[feedAt++][1];
    while (section + 1 < job.sections.length && job.sections[section + 1].first <= i) ++section;
    m.kind[i] = job.kinds.charCodeAt(i) - 48;
    m.x0[i] = x / 1000; m.y0[i] = y / 1000; m.z0[i] = z / 1000;
    x += job.x[i]; y += job.y[i]; z += job.z[i]; line += job.line[i]; ticks += job.t[i];
    m.x1[i] = x / 1000; m.y1[i] = y / 1000; m.z1[i] = z / 1000;
    m.t[i + 1] = ticks / 10000; m.line[i] = line; m.feed[i] = feed; m.section[i] = section;
  }
  for (const [i, cx, cy, turn] of job.arcs) { m.cx[i] = m.x0[i] + cx / 1000; m.cy[i] = m.y0[i] + cy / 1000; m.turn[i] = turn; }
  return m;
}

const total = moves.t[count];
const toolOf = i => job.tools[job.sections[moves.section[i]].tool];

/** Start angle and signed sweep of an arc move. */
function arcOf(i) {
  const a = Math.atan2(moves.y0[i] - moves.cy[i], moves.x0[i] - moves.cx[i]);
  const b = Math.atan2(moves.y1[i] - moves.cy[i], moves.x1[i] - moves.cx[i]);
  let sweep = b - a;
  while (moves.turn[i] > 0 ? sweep <= 0 : sweep >= 0) sweep += moves.turn[i] * 2 * Math.PI;
  return { a, sweep, r: Math.hypot(moves.x0[i] - moves.cx[i], moves.y0[i] - moves.cy[i]) };
}

function pointAt(i, f) {
  const z = moves.z0[i] + (moves.z1[i] - moves.z0[i]) * f;
  if (moves.turn[i] === 0) {
    return { x: moves.x0[i] + (moves.x1[i] - moves.x0[i]) * f, y: moves.y0[i] + (moves.y1[i] - moves.y0[i]) * f, z };
  }
  const arc = arcOf(i), angle = arc.a + arc.sweep * f;
  return { x: moves.cx[i] + arc.r * Math.cos(angle), y: moves.cy[i] + arc.r * Math.sin(angle), z };
}

/** Adds the part of move i between fractions f and g to the current path. */
function trace(context, i, f, g) {
  const p = pointAt(i, f);
  context.moveTo(p.x, p.y);
  if (moves.turn[i] === 0) {
    const q = pointAt(i, g);
    context.lineTo(q.x, q.y);
  } else {
    const arc = arcOf(i);
    context.arc(moves.cx[i], moves.cy[i], arc.r, arc.a + arc.sweep * f, arc.a + arc.sweep * g, moves.turn[i] < 0);
  }
}

// ---- The heights.
const [wx0, wy0, wx1, wy1] = job.world;
const PIXELS = 1000;
const scale = PIXELS / Math.max(wx1 - wx0, wy1 - wy0);
const width = Math.max(1, Math.ceil((wx1 - wx0) * scale)), height = Math.max(1, Math.ceil((wy1 - wy0) * scale));
const depth = Math.max(job.top - job.bottom, 1e-6);
const heights = newCanvas(), heightContext = heights.getContext('2d', { willReadFrequently: true });
const relief = by('relief'), overlay = by('overlay');
relief.width = width; relief.height = height;
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

// ---- Time: where the machine is, with snapshots to go back to.
const at = { move: 0, fraction: 0, time: 0 };
const SNAPSHOTS = 16;
const snapshots = [];

function takeSnapshot() {
  const due = total * (snapshots.length + 1) / (SNAPSHOTS + 1);
  if (snapshots.length >= SNAPSHOTS || moves.t[at.move] < due) return;
  const canvas = newCanvas();
  canvas.getContext('2d').drawImage(heights, 0, 0);
  snapshots.push({ move: at.move, canvas });
}

function rewind(time) {
  fullStock();
  at.move = 0; at.fraction = 0;
  for (const snapshot of snapshots) {
    if (moves.t[snapshot.move] > time || snapshot.move === 0) continue;
    at.move = snapshot.move;
    heightContext.save();
    heightContext.setTransform(1, 0, 0, 1, 0, 0);
    heightContext.globalCompositeOperation = 'source-over';
    heightContext.drawImage(snapshot.canvas, 0, 0);
    heightContext.restore();
  }
  soilAll();
}

function goTo(time) {
  time = Math.max(0, Math.min(total, time));
  if (time < at.time) rewind(time);
  while (at.move < count && moves.t[at.move + 1] <= time) {
    cut(at.move, at.fraction, 1);
    ++at.move; at.fraction = 0;
    takeSnapshot();
  }
  if (at.move < count) {
    const f = (time - moves.t[at.move]) / (moves.t[at.move + 1] - moves.t[at.move]);
    cut(at.move, at.fraction, f);
    at.fraction = f;
  }
  at.time = time;
}

// ---- Pictures.
const shades = job.shades.map(color => [1, 3, 5].map(k => parseInt(color.slice(k, k + 2), 16)));

/** Colours the dirty part of the relief: shade of the depth, light from the upper left, shadow at the foot of walls. */
function shade() {
  const x0 = Math.max(0, Math.floor(dirty.x0)), y0 = Math.max(0, Math.floor(dirty.y0));
  const w = Math.min(width, Math.ceil(dirty.x1)) - x0, h = Math.min(height, Math.ceil(dirty.y1)) - y0;
  dirty.x0 = dirty.y0 = Infinity; dirty.x1 = dirty.y1 = -Infinity;
  if (!(w > 0 && h > 0)) return;
  const REACH = 8;
  const gx = Math.max(0, x0 - REACH), gy = Math.max(0, y0 - REACH);
  const gw = Math.min(width, x0 + w + 1) - gx, gh = Math.min(height, y0 + h + 1) - gy;
  const source = heightContext.getImageData(gx, gy, gw, gh).data, picture = reliefContext.createImageData(w, h), out = picture.data;
  const z = (x, y) => source[4 * (Math.max(0, Math.min(gh - 1, y - gy)) * gw + Math.max(0, Math.min(gw - 1, x - gx)))];
  const mmPerLevel = depth / 255, slope = mmPerLevel * scale;
  for (let y = y0; y < y0 + h; ++y) {
    for (let x = x0; x < x0 + w; ++x) {
      const k = 4 * ((y - y0) * w + x - x0);
      out[k + 3] = source[4 * ((y - gy) * gw + x - gx) + 3];
      if (out[k + 3] === 0) continue;
      const here = z(x, y);
      let light = 1 + Math.max(-0.25, Math.min(0.25, 0.03 * slope * (z(x + 1, y) - z(x - 1, y) + z(x, y + 1) - z(x, y - 1))));
      let shadow = 0;
      for (const step of [2, 4, 7]) {
        shadow = Math.max(shadow, Math.min(1, Math.max(0, (z(x - step, y - step) - here) * mmPerLevel - step * 0.25 / scale) / 3) * (1 - step / 10));
      }
      light *= 1 - 0.4 * shadow;
      const color = shades[here];
      out[k] = color[0] * light; out[k + 1] = color[1] * light; out[k + 2] = color[2] * light;
    }
  }
  reliefContext.putImageData(picture, x0, y0);
}

const outlines = job.features.map(feature => new Path2D(feature.path));
const TRAIL = 500;
let marked = null;

/** Where the cutter of a feature that is not clean could be, over its floor. */
function reachOf(feature) {
  const canvas = newCanvas(), c = canvas.getContext('2d');
  toWorld(c, 1);
  c.clip(new Path2D(feature.path), 'evenodd');
  c.lineWidth = feature.reach.d; c.lineJoin = c.lineCap = 'round';
  const centers = new Path2D(feature.reach.centers);
  c.fill(centers, 'evenodd'); c.stroke(centers); c.stroke(new Path2D(feature.reach.lines));
  return c.getImageData(0, 0, width, height).data;
}

/** Red where something is left within reach: how the program ends. A rest thinner than a pixel is not seen. */
let rests = null;
function restsAtTheEnd() {
  if (rests) return rests;
  rests = newCanvas();
  const c = rests.getContext('2d'), left = heightContext.getImageData(0, 0, width, height).data;
  let pixels = 0;
  const picture = c.createImageData(width, height), red = [1, 3, 5].map(k => parseInt(css('bad').trim().slice(k, k + 2), 16));
  for (const feature of job.features.filter(feature => feature.reach)) {
    const reach = reachOf(feature), floor = Math.round(255 * (feature.floor - job.bottom) / depth) + 1;
    for (let k = 0; k < left.length; k += 4) {
      if (reach[k + 3] < 255 || left[k + 3] < 255 || left[k] <= floor) continue;
      picture.data.set([...red, 255], k);
      ++pixels;
    }
  }
  c.putImageData(picture, 0, 0);
  overlay.dataset.leftMm2 = fixed(pixels / scale / scale, 1);
  return rests;
}

/** What is left in red, and the places of all faults. */
function drawRests(c, k, px) {
  c.save();
  c.setTransform(k, 0, 0, k, 0, 0);
  c.drawImage(restsAtTheEnd(), 0, 0);
  c.restore();
  for (const fault of job.faults) if (fault.x !== null && fault.y !== null) drawMark(c, px, fault);
}

function drawOverlay() {
  const ratio = window.devicePixelRatio || 1, k = overlay.clientWidth * ratio / width;
  overlay.width = Math.max(1, Math.round(width * k)); overlay.height = Math.max(1, Math.round(height * k));
  const c = overlay.getContext('2d'), px = 1 / (scale * k) * ratio;
  toWorld(c, k);
  c.lineJoin = c.lineCap = 'round';
  c.lineWidth = 0.8 * px; c.strokeStyle = 'rgba(28,39,51,0.45)';
  c.save();
  if (job.stock) {
    c.beginPath();
    c.rect(job.stock[0], job.stock[1], job.stock[2] - job.stock[0], job.stock[3] - job.stock[1]);
    c.stroke();
    c.clip();
  }
  for (const outline of outlines) c.stroke(outline);
  c.restore();
  if (at.time >= total && !job.clean) drawRests(c, k, px);
  if (by('path').checked) drawTrail(c, px);
  drawTool(c, px);
  if (marked) drawMark(c, px, marked);
}

function drawTrail(c, px) {
  c.lineWidth = 1.2 * px;
  const last = Math.min(at.move, count - 1);
  for (let i = Math.max(0, last - TRAIL); i <= last; ++i) {
    c.beginPath();
    trace(c, i, 0, i === at.move ? at.fraction : 1);
    c.setLineDash(moves.kind[i] === 0 ? [4 * px, 4 * px] : []);
    c.strokeStyle = LINE_COLORS[moves.kind[i]];
    c.globalAlpha = 0.25 + 0.75 * Math.max(0, 1 - (last - i) / TRAIL);
    c.stroke();
  }
  c.setLineDash([]);
  c.globalAlpha = 1;
}

function drawTool(c, px) {
  if (count === 0) return;
  const i = Math.min(at.move, count - 1), tool = toolOf(i), p = pointAt(i, at.move < count ? at.fraction : 1);
  const radius = tool ? tool.d / 2 : 3 * px, cuts = p.z < job.top && moves.kind[i] !== 0;
  c.beginPath();
  c.arc(p.x, p.y, radius, 0, 2 * Math.PI);
  c.fillStyle = cuts ? 'rgba(232,118,12,0.28)' : 'rgba(120,130,140,0.18)';
  c.fill();
  c.lineWidth = 2 * px; c.strokeStyle = cuts ? css('entry') : css('rapid');
  c.stroke();
  c.beginPath();
  c.moveTo(p.x - 5 * px, p.y); c.lineTo(p.x + 5 * px, p.y); c.moveTo(p.x, p.y - 5 * px); c.lineTo(p.x, p.y + 5 * px);
  c.stroke();
}

function drawMark(c, px, place) {
  for (const [color, w] of [['#fff', 6], [css('bad'), 3]]) {
    c.beginPath();
    c.arc(place.x, place.y, 12 * px, 0, 2 * Math.PI);
    c.lineWidth = w * px; c.strokeStyle = color;
    c.stroke();
  }
}

// ---- Words.
const fixed = (v, n) => v === null || !isFinite(v) ? '?' : v.toFixed(n);
function clock(s) {
  if (s === null || !isFinite(s)) return '?';
  s = Math.round(s);
  const two = v => String(v).padStart(2, '0');
  const hours = Math.floor(s / 3600), minutes = Math.floor(s / 60) % 60;
  return (hours ? hours + ':' + two(minutes) : minutes) + ':' + two(s % 60);
}
function element(name, text, parent, type) {
  const e = document.createElement(name);
  if (text !== undefined) e.textContent = text;
  if (type) e.className = type;
  if (parent) parent.append(e);
  return e;
}

function writeHeader() {
  by('title').textContent = job.name;
  const faults = job.faults.length;
  by('verdict').textContent = job.clean ? 'certified clean' : faults ? 'not clean: ' + faults + (faults === 1 ? ' fault' : ' faults') : 'not clean';
  by('verdict').style.background = css(job.clean ? 'good' : 'bad');
  const f = job.figures, has = kind => job.faults.some(fault => fault.kind === kind);
  for (const [figure, words, bad] of [[clock(f.time_s), 'machining time'], [fixed(f.feed_mm, 0) + ' mm', 'feed'],
    [fixed(f.rapid_mm, 0) + ' mm', 'rapid'], [f.retracts, 'retracts'],
    [fixed(f.uncut_thickness_mm, 4) + ' mm', 'left at most, proven', has('uncut')],
    [fixed(f.gouge_mm, 4) + ' mm', 'deepest gouge', has('gouge')],
    [f.rapid_in_material, 'rapids in material', f.rapid_in_material > 0], [fixed(f.max_deg, 0) + '\u00b0', 'largest engagement']]) {
    const tile = element('div', undefined, by('tiles'), bad ? 'bad' : '');
    element('b', figure, tile);
    tile.append(words);
  }
}

function sectionTime(s) { return moves.t[Math.min(job.sections[s].first, count)]; }
function sectionEnd(s) { return s + 1 < job.sections.length ? sectionTime(s + 1) : total; }
const shadeOf = feature => job.shades[Math.max(0, Math.min(255, Math.round(255 * (feature.floor - job.bottom) / depth)))];

function writeFeatures() {
  const head = element('tr', undefined, by('features'));
  for (const words of ['', 'floor z', 'time', 'left mm', '']) element('th', words, head);
  job.features.forEach((feature, i) => {
    const row = element('tr', undefined, by('features')), name = element('td', undefined, row);
    element('span', undefined, name, 'swatch').style.background = shadeOf(feature);
    name.append(feature.name);
    element('td', fixed(feature.floor, 2), row);
    element('td', clock(feature.time), row);
    element('td', fixed(feature.left, 4), row);
    element('span', undefined, element('td', undefined, row), 'dot ' + (feature.clean === null ? '' : feature.clean ? 'good' : 'bad-dot'));
    const s = job.sections.findIndex(section => section.feature === i);
    row.dataset.feature = i;
    if (s >= 0) {
      row.dataset.t = sectionTime(s);
      row.onclick = () => show(sectionTime(s) + 1e-3);
    }
  });
}

/** When a fault can be seen: at its line, else when its feature is done, else at the end. */
function timeOfFault(fault) {
  const i = fault.line > 0 ? moves.line.indexOf(fault.line) : -1;
  if (i >= 0) return moves.t[i + 1];
  for (let s = job.sections.length - 1; s >= 0; --s) {
    const feature = job.features[job.sections[s].feature];
    if (feature && feature.name === fault.feature) return sectionEnd(s);
  }
  return total;
}

function writeFaults() {
  by('faults-box').hidden = job.faults.length === 0;
  for (const fault of job.faults) {
    const item = element('li', undefined, by('faults'));
    element('b', fault.head, item);
    item.append((fault.feature ? ' in ' + fault.feature : '') + (fault.line ? ', line ' + fault.line : ''));
    element('div', fault.text, item);
    item.onclick = () => { marked = fault.x === null || fault.y === null ? null : fault; show(timeOfFault(fault)); };
  }
}

function writeTimeline() {
  job.sections.forEach((section, s) => {
    const piece = element('span', undefined, by('timeline')), feature = job.features[section.feature];
    piece.style.flex = Math.max(sectionEnd(s) - sectionTime(s), 0) + ' 0 0';
    piece.style.background = feature ? shadeOf(feature) : css('rule');
    piece.style.borderRight = '1px solid #fff';
    piece.title = section.label;
  });
  for (const fault of job.faults) element('i', undefined, by('timeline')).style.left = 100 * timeOfFault(fault) / (total || 1) + '%';
  by('timeline').onclick = event => {
    const box = by('timeline').getBoundingClientRect();
    show(total * (event.clientX - box.left) / box.width);
  };
}

const nowCells = {};
function writeNow() {
  for (const words of ['feature', 'tool', 'move', 'feed', 'position', 'line']) {
    const row = element('tr', undefined, by('now'));
    element('td', words, row);
    nowCells[words] = element('td', '', row);
  }
  by('code').hidden = job.program.length === 0;
}

function updateNow() {
  by('clock').textContent = clock(at.time) + ' / ' + clock(total);
  by('scrub').value = total > 0 ? Math.round(100000 * at.time / total) : 0;
  by('play').textContent = playing ? 'Pause' : 'Play';
  if (count === 0) return;
  const i = Math.min(at.move, count - 1), section = job.sections[moves.section[i]], tool = toolOf(i);
  const p = pointAt(i, at.move < count ? at.fraction : 1);
  nowCells.feature.textContent = section.label;
  nowCells.tool.textContent = tool ? tool.w : '?';
  nowCells.move.textContent = KINDS[moves.kind[i]] || '?';
  nowCells.feed.textContent = moves.feed[i] > 0 ? fixed(moves.feed[i], 0) + ' mm/min' : 'rapid';
  nowCells.position.textContent = 'x ' + fixed(p.x, 2) + '  y ' + fixed(p.y, 2) + '  z ' + fixed(p.z, 2);
  nowCells.line.textContent = moves.line[i] > 0 ? moves.line[i] : 'planned';
  for (const row of by('features').rows) row.classList.toggle('now', row.dataset.feature === String(section.feature));
  updateCode(moves.line[i]);
}

function updateCode(line) {
  if (job.program.length === 0) return;
  const around = 4, first = Math.max(1, Math.min(line - around, job.program.length - 2 * around));
  by('code').replaceChildren();
  for (let k = first; k <= Math.min(first + 2 * around, job.program.length); ++k) {
    const text = String(k).padStart(6) + '  ' + job.program[k - 1];
    if (k === line) element('b', text, by('code'));
    else by('code').append(text + '\n');
  }
}

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
)js";

}  // namespace clearcut::report
