'use strict';
/** @type {Job} */
const job = JSON.parse(document.getElementById('job')?.textContent ?? '');
/**
 * The element of the page with that id.
 * @template {keyof PageElements} Id @param {Id} id @returns {PageElements[Id]}
 */
function by(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`This page has no element ${id}.`);
  return /** @type {PageElements[Id]} */ (found);
}
/** @type {(canvas: HTMLCanvasElement, settings?: CanvasRenderingContext2DSettings) => Context2D} */
function contextOf(canvas, settings) {
  const context = canvas.getContext('2d', settings);
  if (!context) throw new Error('This browser draws nothing.');
  return context;
}
const KINDS = ['rapid', 'plunge', 'ramp', 'lead-in', 'cut', 'lead-out', 'link', 'retract'];
/** @type {(name: string) => string} */
const css = name => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();

// ---- Moves: columns of differences become absolute values, mm and seconds.
const moves = decodeMoves(job), count = moves.kind.length;
/** What was cut before the program begins. */
const earlier = job.earlier ? decodeMoves(job.earlier) : null;

/** Of the program or of what was cut before it. @type {(columns: MoveColumns) => Moves} */
function decodeMoves(columns) {
  const size = columns.kinds.length;
  const m = {
    kind: new Uint8Array(size),
    x0: new Float64Array(size),
    y0: new Float64Array(size),
    z0: new Float64Array(size),
    x1: new Float64Array(size),
    y1: new Float64Array(size),
    z1: new Float64Array(size),
    t: new Float64Array(size + 1),
    line: new Int32Array(size),
    feed: new Float64Array(size),
    section: new Uint32Array(size),
    cx: new Float64Array(size),
    cy: new Float64Array(size),
    turn: new Int8Array(size),
    tools: columns.sections.map(section => section.tool),
    below: columns.sections.map(section => section.below ?? null)
  };
  let x = 0, y = 0, z = 0, line = 0, ticks = 0, start = 0, feedAt = 0, feed = 0, section = -1;
  for (let i = 0; i < size; ++i) {
    if (start < columns.starts.length && columns.starts[start][0] === i) [, x, y, z] = columns.starts[start++];
    if (feedAt < columns.feeds.length && columns.feeds[feedAt][0] === i) feed = columns.feeds[feedAt++][1];
    while (section + 1 < columns.sections.length && columns.sections[section + 1].first <= i) ++section;
    m.kind[i] = columns.kinds.charCodeAt(i) - 48;
    m.x0[i] = x / 1000;
    m.y0[i] = y / 1000;
    m.z0[i] = z / 1000;
    x += columns.x[i];
    y += columns.y[i];
    z += columns.z[i];
    line += columns.line[i];
    ticks += columns.t[i];
    m.x1[i] = x / 1000;
    m.y1[i] = y / 1000;
    m.z1[i] = z / 1000;
    m.t[i + 1] = ticks / 10000;
    m.line[i] = line;
    m.feed[i] = feed;
    m.section[i] = section;
  }
  for (const [i, cx, cy, turn] of columns.arcs) {
    m.cx[i] = m.x0[i] + cx / 1000;
    m.cy[i] = m.y0[i] + cy / 1000;
    m.turn[i] = turn;
  }
  return m;
}

const total = moves.t[count];
/** @type {(i: number) => JobTool | undefined} */
const toolOf = i => job.tools[job.sections[moves.section[i]].tool];

/** Degrees, the largest on each move; null where the page was made without. */
const engagements = job.engagement || null;
/** N, likewise the largest of each move; null where the material of the work is not known. */
const forces = job.force || null;
const mostForce = forces ? forces.reduce((most, force) => Math.max(most, force), 0) : 0;
/** @type {(force: number) => string} */
const forceText = force => fixed(force, force < 10 ? 1 : 0) + ' N';

/** First move of each line of the program, -1 where it has none. */
const moveOfLine = new Int32Array(job.program.length + 1).fill(-1);
for (let i = count - 1; i >= 0; --i)
  if (moves.line[i] < moveOfLine.length) moveOfLine[moves.line[i]] = i;

/** Start angle and signed sweep of an arc move. @type {(i: number, m?: Moves) => { a: number, sweep: number, r: number }} */
function arcOf(i, m = moves) {
  const a = Math.atan2(m.y0[i] - m.cy[i], m.x0[i] - m.cx[i]);
  const b = Math.atan2(m.y1[i] - m.cy[i], m.x1[i] - m.cx[i]);
  let sweep = b - a;
  while (m.turn[i] > 0 ? sweep <= 0 : sweep >= 0) sweep += m.turn[i] * 2 * Math.PI;
  return {a, sweep, r: Math.hypot(m.x0[i] - m.cx[i], m.y0[i] - m.cy[i])};
}

/** @type {(i: number, f: number, m?: Moves) => Place} */
function pointAt(i, f, m = moves) {
  const z = m.z0[i] + (m.z1[i] - m.z0[i]) * f;
  if (m.turn[i] === 0) return {x: m.x0[i] + (m.x1[i] - m.x0[i]) * f, y: m.y0[i] + (m.y1[i] - m.y0[i]) * f, z};
  const arc = arcOf(i, m), angle = arc.a + arc.sweep * f;
  return {x: m.cx[i] + arc.r * Math.cos(angle), y: m.cy[i] + arc.r * Math.sin(angle), z};
}

/** Adds the part of move i between fractions f and g to the current path. @type {(context: Context2D, i: number, f: number, g: number) => void} */
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
