// ---- Lines in space: the path in its colours, the outlines of the part, the edges of the stock.
const STRIDE = 20;  // bytes of a corner: three floats, a colour, the move that it belongs to
/** Both are drawn with one program, the plain one where nothing is cut open. Made by startSpace(). @type {Shader} */
let lineProgram;
/** @type {Shader} */
let plainLineProgram;
/** @type {LineBuffer} */
let pathLines;
/** @type {LineBuffer} */
let partLines;
/** The ends of all chords of the path in space, x, y, z in a row, and where each move's begin. @type {{ first: Uint32Array, places: Float32Array } | null} */
let pathChords = null;

function makeLines() {
  lineProgram = programOf(LINE_VERTEX, LINE_FRAGMENT, ['position', 'tint', 'owner']);
  plainLineProgram = programOf(LINE_VERTEX, plainOf(LINE_FRAGMENT), ['position', 'tint', 'owner']);
  const made = () => {
    const lines = {array: gl.createVertexArray(), buffer: gl.createBuffer(), count: 0, key: ''};
    gl.bindVertexArray(lines.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, lines.buffer);
    gl.enableVertexAttribArray(0);
    gl.enableVertexAttribArray(1);
    gl.enableVertexAttribArray(2);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, STRIDE, 0);
    gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, STRIDE, 12);
    gl.vertexAttribIPointer(2, 1, gl.INT, STRIDE, 16);
    return lines;
  };
  pathLines = made();
  partLines = made();
  gl.bindVertexArray(null);
}

/** Chords that stand for move i: an arc deviates from them by less than a third of a cell. @type {(i: number) => number} */
function chordsOf(i) {
  if (moves.turn[i] === 0) return 1;
  const arc = arcOf(i), least = 2 * Math.acos(Math.max(-1, 1 - Math.min(1, 0.3 / scale / Math.max(arc.r, 1e-9))));
  return Math.min(200, Math.max(1, Math.ceil(Math.abs(arc.sweep) / least)));
}

/** Found once: they do not change. */
function placesOfPath() {
  if (pathChords) return pathChords;
  const first = new Uint32Array(count + 1);
  for (let i = 0; i < count; ++i) first[i + 1] = first[i] + chordsOf(i) + 1;
  const places = new Float32Array(3 * first[count]);
  for (let i = 0; i < count; ++i) {
    const chords = first[i + 1] - first[i] - 1;
    for (let k = 0; k <= chords; ++k) {
      const p = pointAt(i, k / chords);
      places.set([p.x, p.y, p.z], 3 * (first[i] + k));
    }
  }
  pathChords = {first, places};
  return pathChords;
}

// Lines that are drawn at once: a processor draws a million in ten seconds, a graphics processor in no time.
const MANY_LINES = {
  software: 150000,
  hardware: 2000000
};
/** Asked once: each question waits until all is drawn. @type {boolean | null} */
let drawsInSoftware = null;
const isSoftware = () => drawsInSoftware ??= /swiftshader|llvmpipe|software/i.test(
  gl.getParameter(gl.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));

/** Colours of the classes as bytes; the last is that of moves without a value. @type {() => number[][]} */
function inksOfClasses() {
  const inks = classColors.map(color => rgb(color).map(v => 255 * v));
  inks[NO_VALUE] = rgb(noColor).map(v => 255 * v);
  return inks;
}

/**
 * Lines of two corners each of the moves that are shown, from the first to the last. Lines of one colour that go on into each other
 * become one as long as it is shorter than the tolerance.
 * @type {(first: number, last: number, tolerance: number) => Uint8Array}
 */
function linesOf(first, last, tolerance) {
  const {first: begins, places} = placesOfPath(), most = 2 * (begins[last + 1] - begins[first]), bytes = new ArrayBuffer(STRIDE * most),
                        floats = new Float32Array(bytes), words = new Int32Array(bytes), tints = new Uint8Array(bytes);
  const inks = inksOfClasses();
  let n = 0, from = -1, to = -1, owner = -1;  // of the line that may still grow
  const corner = (/** @type {number} */ k) => {
    floats[5 * n] = places[3 * k];
    floats[5 * n + 1] = places[3 * k + 1];
    floats[5 * n + 2] = places[3 * k + 2];
    tints.set(inks[classOf[owner]] || inks[NO_VALUE], STRIDE * n + 12);
    tints[STRIDE * n + 15] = moves.kind[owner] === 0 ? 150 : 255;
    words[5 * n++ + 4] = owner;
  };
  const end = () => {
    if (from >= 0) {
      corner(from);
      corner(to);
    }
    from = -1;
  };
  /** @type {(k: number, m: number) => number} */
  const apart = (k, m) =>
    Math.hypot(places[3 * k] - places[3 * m], places[3 * k + 1] - places[3 * m + 1], places[3 * k + 2] - places[3 * m + 2]);
  for (let i = first; i <= last; ++i) {
    if (!shown(i)) continue;
    for (let k = begins[i]; k < begins[i + 1] - 1; ++k) {
      const goesOn = from >= 0 && tolerance > 0 && classOf[owner] === classOf[i] && apart(to, k) < 1e-4 && apart(from, k + 1) < tolerance;
      if (!goesOn) {
        end();
        from = k;
      }
      to = k + 1;
      owner = i;
    }
  }
  end();
  return new Uint8Array(bytes, 0, STRIDE * n);
}

/** Hands over the lines that the choice of the path asks for, as many as the machine can draw. @type {(first: number, last: number) => void} */
function writePath(first, last) {
  const begins = placesOfPath().first, chords = begins[last + 1] - begins[first],
        most = isSoftware() ? MANY_LINES.software : MANY_LINES.hardware;
  const finest = chords > most ? 2 ** Math.round(Math.log2(0.5 / camera.k)) : 0,
        key = [pictureVersion, first, last, finest, dark.matches].join();
  if (key === pathLines.key) return;
  pathLines.key = key;
  let tolerance = finest, lines = linesOf(first, last, tolerance);
  for (; tolerance > 0 && lines.length > 2 * STRIDE * most; tolerance *= 1.5) lines = linesOf(first, last, 1.5 * tolerance);
  pathLines.count = lines.length / STRIDE;
  by('path-note').hidden = tolerance === 0;
  by('path-note').textContent = tolerance > 0 ? 'path drawn to ' + lengthText(tolerance, 2) : '';
  gl.bindBuffer(gl.ARRAY_BUFFER, pathLines.buffer);
  gl.bufferData(gl.ARRAY_BUFFER, lines, gl.DYNAMIC_DRAW);
}

/**
 * What is in front of the material is drawn in full, what lies behind or under it faintly.
 * @type {(lines: LineBuffer, from: number, to: number, values: UniformValues, hidden: number) => void}
 */
function drawLines(lines, from, to, values, hidden) {
  if (to <= from) return;
  gl.bindVertexArray(lines.array);
  for (const [test, strength] of [[gl.LEQUAL, 1], [gl.GREATER, hidden]]) {
    if (strength === 0) continue;
    gl.depthFunc(test);
    use(section.axis === 'none' ? plainLineProgram : lineProgram, {...values, strength});
    gl.drawArrays(gl.LINES, from, to - from);
  }
  gl.depthFunc(gl.LEQUAL);
  gl.bindVertexArray(null);
}

/** `rough`: something moves and the machine is slow; then a long path waits until all is at rest. @type {(values: UniformValues, rough: boolean) => void} */
function drawPathInSpace(values, rough) {
  const mode = by('path').value, last = mode === 'all' ? count - 1 : shownMove();
  if (mode !== 'all') by('path-note').hidden = true;
  if (mode === 'none' || last < 0) return;
  // Of the move under way only the part that is done is drawn, with the marks.
  const first = mode === 'all' ? 0 : Math.max(0, last - TRAIL), to = mode === 'all' ? last : last - 1;
  if (to < first) return;
  writePath(first, to);
  if (rough && pathLines.count > 40000) return;
  drawLines(pathLines, 0, pathLines.count, {...values, last: {i: last}, trail: {i: mode === 'all' ? 0 : TRAIL}},
    rough            ? 0 :
      mode === 'all' ? 0.45 :
                       0.3);
}

/** Polygons of an outline's path data: M, L, A with equal radii, Z, in the part's mm. @type {(data: string) => [number, number][][]} */
function polygonsOf(data) {
  /** @type {[number, number][][]} */
  const polygons = [];
  /** @type {[number, number][]} */
  let polygon = [];
  for (const [, command, rest] of data.matchAll(/([MLAZh])([^MLAZh]*)/g)) {
    const numbers = rest.trim().split(/[ ,]+/).map(Number);
    if (command === 'M') polygons.push(polygon = [[numbers[0], numbers[1]]]);
    else if (command === 'L') polygon.push([numbers[0], numbers[1]]);
    else if (command === 'A') polygon.push(...arcPoints(polygon[polygon.length - 1], numbers));
    else if (command === 'Z') polygon.push(polygon[0]);
  }
  return polygons;
}

/** Points after the first of an arc of less than half a turn. @type {(from: [number, number], numbers: number[]) => [number, number][]} */
function arcPoints([x0, y0], [radius, , , , turn, x1, y1]) {
  const dx = x1 - x0, dy = y1 - y0, chord = Math.hypot(dx, dy),
        side = (turn ? 1 : -1) * Math.sqrt(Math.max(0, radius * radius - chord * chord / 4)) / (chord || 1);
  const cx = (x0 + x1) / 2 - dy * side, cy = (y0 + y1) / 2 + dx * side, from = Math.atan2(y0 - cy, x0 - cx);
  const sweep = (turn ? 1 : -1) * 2 * Math.asin(Math.min(1, chord / 2 / radius)), steps = Math.max(1, Math.ceil(Math.abs(sweep) / 0.12));
  /** @type {[number, number][]} */
  const points = [];
  for (let k = 1; k <= steps; ++k)
    points.push([cx + radius * Math.cos(from + sweep * k / steps), cy + radius * Math.sin(from + sweep * k / steps)]);
  points[steps - 1] = [x1, y1];
  return points;
}

/** The part: the outline of each feature at its floor and at its top; and the edges of the stock. */
function writePart() {
  /** @type {{ place: number[], tint: number[] }[]} */
  const corners = [];
  const line = (/** @type {number[]} */ p, /** @type {number[]} */ q, /** @type {number[]} */ tint) =>
    corners.push({place: p, tint}, {place: q, tint});
  // On light material before a dark page neither the page's ink nor its opposite would be seen.
  const ink = [...rgb(dark.matches ? '#5b6b7d' : css('ink')).map(v => 255 * v), 190], faint = [...rgb(css('edge')).map(v => 255 * v), 200];
  for (const feature of job.features) {
    for (const polygon of polygonsOf(feature.path)) {
      for (const z of new Set([feature.floor, feature.top ?? job.top]))
        for (let k = 1; k < polygon.length; ++k) line([...polygon[k - 1], z], [...polygon[k], z], ink);
    }
  }
  const block_ = [[sx0, sy0], [sx1, sy0], [sx1, sy1], [sx0, sy1], [sx0, sy0]];
  for (let k = 0; k < 4; ++k) {
    for (const z of [bottomZ, job.top]) line([...block_[k], z], [...block_[k + 1], z], faint);
    line([...block_[k], bottomZ], [...block_[k], job.top], faint);
  }
  const bytes = new ArrayBuffer(STRIDE * corners.length), floats = new Float32Array(bytes), tints = new Uint8Array(bytes);
  corners.forEach(({place, tint}, n) => {
    floats.set(place, 5 * n);
    tints.set(tint, STRIDE * n + 12);
  });
  partLines.count = corners.length;
  gl.bindBuffer(gl.ARRAY_BUFFER, partLines.buffer);
  gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.STATIC_DRAW);
}

/** @type {(values: UniformValues, rough: boolean) => void} */
function drawPart(values, rough) {
  const key = String(dark.matches);
  if (key !== partLines.key) {
    partLines.key = key;
    writePart();
  }
  drawLines(partLines, 0, partLines.count, {...values, last: {i: 0}, trail: {i: 0}}, rough ? 0 : 0.12);
}

/** The move that passes nearest to a point of the stage; of several on each other the one nearest in time. -1: none is near. @type {(s: Point) => number} */
function moveNearInSpace(s) {
  const {first: begins, places} = placesOfPath(), axes = cameraAxes(), mode = by('path').value,
                        last = mode === 'recent' ? shownMove() : count - 1, first = mode === 'recent' ? Math.max(0, last - TRAIL) : 0;
  const ox = view.w / 2 - dot(axes.right, camera) * camera.k - s.x, oy = view.h / 2 + dot(axes.up, camera) * camera.k - s.y;
  const onStage_ = (/** @type {number} */ k) => {
    const p = {x: places[3 * k], y: places[3 * k + 1], z: places[3 * k + 2]};
    return {x: ox + dot(axes.right, p) * camera.k, y: oy - dot(axes.up, p) * camera.k};
  };
  let best = -1, nearest = NEAR;
  for (let i = mode === 'none' ? count : first; i <= last; ++i) {
    if (!shown(i)) continue;
    let d = Infinity;
    for (let k = begins[i], a = onStage_(k); k < begins[i + 1] - 1; ++k) {
      const b = onStage_(k + 1), dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
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
