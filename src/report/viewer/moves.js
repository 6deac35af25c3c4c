'use strict';
const job = JSON.parse(document.getElementById('job').textContent);
const by = id => document.getElementById(id);
const KINDS = ['rapid', 'plunge', 'ramp', 'lead-in', 'cut', 'lead-out', 'link', 'retract'];
const css = name => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();

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

/** Degrees, the largest on each move; null where the page was made without. */
const engagements = job.engagement || null;
/** N, likewise the largest of each move; null where the material of the work is not known. */
const forces = job.force || null;
const mostForce = forces ? forces.reduce((most, force) => Math.max(most, force), 0) : 0;
const forceText = force => fixed(force, force < 10 ? 1 : 0) + ' N';

/** First move of each line of the program, -1 where it has none. */
const moveOfLine = new Int32Array(job.program.length + 1).fill(-1);
for (let i = count - 1; i >= 0; --i) if (moves.line[i] < moveOfLine.length) moveOfLine[moves.line[i]] = i;

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
