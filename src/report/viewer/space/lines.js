// ---- Lines in space: the path in its colours, the outlines of the part, the edges of the stock.
const STRIDE = 20;  // bytes of a corner: three floats, a colour, the move that it belongs to
const pathLines = { program: null, array: null, buffer: null, first: null, version: -1, places: null };
const partLines = { array: null, buffer: null, count: 0, key: '' };

function makeLines() {
  pathLines.program = programOf(LINE_VERTEX, LINE_FRAGMENT, ['position', 'tint', 'owner']);
  for (const lines of [pathLines, partLines]) {
    lines.array = gl.createVertexArray();
    gl.bindVertexArray(lines.array);
    lines.buffer = bufferOf(gl.ARRAY_BUFFER);
    gl.enableVertexAttribArray(0); gl.enableVertexAttribArray(1); gl.enableVertexAttribArray(2);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, STRIDE, 0);
    gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, STRIDE, 12);
    gl.vertexAttribIPointer(2, 1, gl.INT, STRIDE, 16);
  }
  gl.bindVertexArray(null);
  pathLines.version = -1; partLines.key = '';
}

/** Chords that stand for move i: an arc deviates from them by less than a third of a cell. */
function chordsOf(i) {
  if (moves.turn[i] === 0) return 1;
  const arc = arcOf(i), least = 2 * Math.acos(Math.max(-1, 1 - Math.min(1, 0.3 / scale / Math.max(arc.r, 1e-9))));
  return Math.min(200, Math.max(1, Math.ceil(Math.abs(arc.sweep) / least)));
}

/** The ends of all chords in space, x, y, z in a row, and where each move's begin. Does not change. */
function placesOfPath() {
  if (pathLines.places) return;
  pathLines.first = new Uint32Array(count + 1);
  for (let i = 0; i < count; ++i) pathLines.first[i + 1] = pathLines.first[i] + chordsOf(i) + 1;
  pathLines.places = new Float32Array(3 * pathLines.first[count]);
  for (let i = 0; i < count; ++i) {
    const chords = pathLines.first[i + 1] - pathLines.first[i] - 1;
    for (let k = 0; k <= chords; ++k) {
      const p = pointAt(i, k / chords);
      pathLines.places.set([p.x, p.y, p.z], 3 * (pathLines.first[i] + k));
    }
  }
}

/** Corners for lines of two each, of the moves that are shown. */
function writePath() {
  placesOfPath();
  pathLines.version = pictureVersion;
  const most = 2 * (pathLines.first[count] - count), bytes = new ArrayBuffer(STRIDE * most), floats = new Float32Array(bytes), words = new Int32Array(bytes), tints = new Uint8Array(bytes);
  const inks = classColors.map(color => rgb(color).map(v => 255 * v)), none = rgb(noColor).map(v => 255 * v);
  pathLines.start = new Uint32Array(count + 1);
  let n = 0;
  for (let i = 0; i < count; ++i) {
    pathLines.start[i] = n;
    if (!shown(i)) continue;
    const ink = classOf[i] === NO_VALUE ? none : inks[classOf[i]] || none;
    for (let k = pathLines.first[i]; k < pathLines.first[i + 1] - 1; ++k) {
      for (let end = 0; end < 2; ++end, ++n) {
        floats.set(pathLines.places.subarray(3 * (k + end), 3 * (k + end) + 3), 5 * n);
        tints.set(ink, STRIDE * n + 12);
        tints[STRIDE * n + 15] = moves.kind[i] === 0 ? 150 : 255;
        words[5 * n + 4] = i;
      }
    }
  }
  pathLines.start[count] = n;
  gl.bindBuffer(gl.ARRAY_BUFFER, pathLines.buffer);
  gl.bufferData(gl.ARRAY_BUFFER, new Uint8Array(bytes, 0, STRIDE * n), gl.DYNAMIC_DRAW);
}

/** What is in front of the material is drawn in full, what lies behind or under it faintly. */
function drawLines(lines, from, to, values, hidden) {
  if (to <= from) return;
  gl.bindVertexArray(lines.array);
  for (const [test, strength] of [[gl.LEQUAL, 1], [gl.GREATER, hidden]]) {
    if (strength === 0) continue;
    gl.depthFunc(test);
    use(pathLines.program, { ...values, strength });
    gl.drawArrays(gl.LINES, from, to - from);
  }
  gl.depthFunc(gl.LEQUAL);
  gl.bindVertexArray(null);
}

function drawPathInSpace(values) {
  const mode = by('path').value;
  if (mode === 'none' || count === 0) return;
  if (pathLines.version !== pictureVersion) writePath();
  const last = mode === 'all' ? count - 1 : shownMove(), first = mode === 'all' ? 0 : Math.max(0, last - TRAIL);
  if (last < 0) return;
  // Of the move under way only the part that is done is drawn, with the marks.
  const to = mode === 'all' ? count : last;
  drawLines(pathLines, pathLines.start[first], pathLines.start[Math.max(first, to)], { ...values, last: { i: last }, trail: { i: mode === 'all' ? 0 : TRAIL } }, mode === 'all' ? 0.45 : 0.3);
}

/** Polygons of an outline's path data: M, L, A with equal radii, Z, in the part's mm. */
function polygonsOf(data) {
  const polygons = [];
  let polygon = null;
  for (const [, command, rest] of data.matchAll(/([MLAZh])([^MLAZh]*)/g)) {
    const numbers = rest.trim().split(/[ ,]+/).map(Number);
    if (command === 'M') polygons.push(polygon = [[numbers[0], numbers[1]]]);
    else if (command === 'L') polygon.push([numbers[0], numbers[1]]);
    else if (command === 'A') polygon.push(...arcPoints(polygon[polygon.length - 1], numbers));
    else if (command === 'Z') polygon.push(polygon[0]);
  }
  return polygons;
}

/** Points after the first of an arc of less than half a turn. */
function arcPoints([x0, y0], [radius, , , , turn, x1, y1]) {
  const dx = x1 - x0, dy = y1 - y0, chord = Math.hypot(dx, dy), side = (turn ? 1 : -1) * Math.sqrt(Math.max(0, radius * radius - chord * chord / 4)) / (chord || 1);
  const cx = (x0 + x1) / 2 - dy * side, cy = (y0 + y1) / 2 + dx * side, from = Math.atan2(y0 - cy, x0 - cx);
  const sweep = (turn ? 1 : -1) * 2 * Math.asin(Math.min(1, chord / 2 / radius)), steps = Math.max(1, Math.ceil(Math.abs(sweep) / 0.12)), points = [];
  for (let k = 1; k <= steps; ++k) points.push([cx + radius * Math.cos(from + sweep * k / steps), cy + radius * Math.sin(from + sweep * k / steps)]);
  points[steps - 1] = [x1, y1];
  return points;
}

/** The part: the outline of each feature at its floor and at its top; and the edges of the stock. */
function writePart() {
  const corners = [], line = (p, q, ink) => corners.push([...p, ink], [...q, ink]);
  // On light material before a dark page neither the page's ink nor its opposite would be seen.
  const ink = [...rgb(dark.matches ? '#5b6b7d' : css('ink')).map(v => 255 * v), 190], faint = [...rgb(css('edge')).map(v => 255 * v), 200];
  for (const feature of job.features) {
    for (const polygon of polygonsOf(feature.path)) {
      for (const z of new Set([feature.floor, feature.top ?? job.top])) for (let k = 1; k < polygon.length; ++k) line([...polygon[k - 1], z], [...polygon[k], z], ink);
    }
  }
  const block_ = [[sx0, sy0], [sx1, sy0], [sx1, sy1], [sx0, sy1], [sx0, sy0]];
  for (let k = 0; k < 4; ++k) {
    for (const z of [bottomZ, job.top]) line([...block_[k], z], [...block_[k + 1], z], faint);
    line([...block_[k], bottomZ], [...block_[k], job.top], faint);
  }
  const bytes = new ArrayBuffer(STRIDE * corners.length), floats = new Float32Array(bytes), tints = new Uint8Array(bytes);
  corners.forEach(([x, y, z, tint], n) => { floats.set([x, y, z], 5 * n); tints.set(tint, STRIDE * n + 12); });
  partLines.count = corners.length;
  gl.bindBuffer(gl.ARRAY_BUFFER, partLines.buffer);
  gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.STATIC_DRAW);
}

function drawPart(values) {
  const key = String(dark.matches);
  if (key !== partLines.key) { partLines.key = key; writePart(); }
  drawLines(partLines, 0, partLines.count, { ...values, last: { i: 0 }, trail: { i: 0 } }, 0.12);
}

/** The move that passes nearest to a point of the stage; of several on each other the one nearest in time. -1: none is near. */
function moveNearInSpace(s) {
  placesOfPath();
  const axes = cameraAxes(), mode = by('path').value, last = mode === 'recent' ? shownMove() : count - 1, first = mode === 'recent' ? Math.max(0, last - TRAIL) : 0;
  const ox = view.w / 2 - dot(axes.right, camera) * camera.k - s.x, oy = view.h / 2 + dot(axes.up, camera) * camera.k - s.y;
  const onStage = k => {
    const p = { x: pathLines.places[3 * k], y: pathLines.places[3 * k + 1], z: pathLines.places[3 * k + 2] };
    return { x: ox + dot(axes.right, p) * camera.k, y: oy - dot(axes.up, p) * camera.k };
  };
  let best = -1, nearest = NEAR;
  for (let i = mode === 'none' ? count : first; i <= last; ++i) {
    if (!shown(i)) continue;
    let d = Infinity;
    for (let k = pathLines.first[i], a = onStage(k); k < pathLines.first[i + 1] - 1; ++k) {
      const b = onStage(k + 1), dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
      const f = squared > 0 ? Math.max(0, Math.min(1, -(a.x * dx + a.y * dy) / squared)) : 0;
      d = Math.min(d, Math.hypot(a.x + f * dx, a.y + f * dy));
      a = b;
    }
    if (d > nearest + 0.5 || d > NEAR) continue;
    if (best < 0 || d < nearest - 0.5 || Math.abs(moves.t[i] - at.time) <= Math.abs(moves.t[best] - at.time)) best = i;
    nearest = Math.min(nearest, d);
  }
  return best;
}
