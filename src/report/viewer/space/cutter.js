// ---- The cutter in space: its end, its flutes as long as they are known to be, above them its shank, and its holder where that is stated.
/** Drawn with one program; a mesh for each tool. Made by startSpace(). @type {{ program: Shader, made: Mesh[] }} */
let cutters;
const AROUND = 40;

function makeCutters() {
  cutters = {program: programOf(CUTTER_VERTEX, CUTTER_FRAGMENT, ['position', 'outward', 'kind']), made: job.tools.map(cutterOf)};
}

/** Rows of radius, height above the tip and kind (0: cuts, 1: shank, 2: holder), from the tip up. @type {(tool: JobTool) => ProfileRow[]} */
function profileOf(tool) {
  const radius = tool.d / 2, isCone = (tool.a ?? 0) > 0, steps = isCone || !tool.r ? 1 : 10, stickout = tool.s ?? 0, cutting = tool.f ?? 0;
  const flat = isCone ? tool.t / 2 : radius - Math.min(tool.r, radius);
  /** @type {ProfileRow[]} */
  const rows = [[0, 0, 0]];
  for (let k = 0; k <= steps; ++k) {
    const r = tool.r > 0 && !isCone ? flat + (radius - flat) * Math.sin(k / steps * Math.PI / 2) : flat + (radius - flat) * k / steps;
    rows.push([r, endAt(tool, r), 0]);
  }
  const end = rows[rows.length - 1][1], flutes = Math.max(cutting, end),
        length = Math.max(flutes + 1.5 * tool.d, job.top - job.bottom + 2 * tool.d);
  const top = stickout > 0 ? Math.max(stickout, flutes) : length, shank = tool.k > 0 ? tool.k / 2 : radius * 0.96;
  if (cutting > 0) rows.push([radius, flutes, 0], [shank, flutes, 1], [shank, top, 1]);
  else rows.push([radius, top, 0]);
  if (!(stickout > 0)) return [...rows, [0, top, cutting > 0 ? 1 : 0]];
  const end_ = top + Math.max(tool.h, 12);
  return [...rows, [tool.h / 2, top, 2], [tool.h / 2, end_, 2], [0, end_, 2]];
}

/** @type {(tool: JobTool) => Mesh} */
function cutterOf(tool) {
  const rows = profileOf(tool);
  /** @type {number[]} */
  const corners = [];
  /** @type {(row: ProfileRow, k: number, out: [number, number]) => void} */
  const corner = (row, k, out) => {
    const angle = 2 * Math.PI * k / AROUND;
    corners.push(
      row[0] * Math.cos(angle), row[0] * Math.sin(angle), row[1], out[0] * Math.cos(angle), out[0] * Math.sin(angle), out[1], row[2]);
  };
  for (let n = 1; n < rows.length; ++n) {
    const a = rows[n - 1], b = rows[n], dr = b[0] - a[0], dz = b[1] - a[1], length = Math.hypot(dr, dz);
    if (length === 0) continue;
    /** @type {[ProfileRow, number][]} */
    const turned = [[a, 0], [a, 1], [b, 0], [b, 0], [a, 1], [b, 1]];
    for (let k = 0; k < AROUND; ++k)
      for (const [row, turn] of turned) corner(row, k + turn, [dz / length, -dr / length]);
  }
  return madeOf(corners);
}

/** Corners of triangles: place, direction square to the face, kind. @type {(corners: number[]) => Mesh} */
function madeOf(corners) {
  const made = {array: gl.createVertexArray(), count: corners.length / 7};
  gl.bindVertexArray(made.array);
  bufferOf(gl.ARRAY_BUFFER, new Float32Array(corners));
  [[3, 0], [3, 12], [1, 24]].forEach(([size, offset], k) => {
    gl.enableVertexAttribArray(k);
    gl.vertexAttribPointer(k, size, gl.FLOAT, false, 28, offset);
  });
  gl.bindVertexArray(null);
  return made;
}

// Clamps: the blocks where no tool may come.
/** @type {Mesh} */
let clamps;

function makeClamps() {
  /** @type {number[]} */
  const corners = [], faces = [[0, 1], [0, -1], [1, 1], [1, -1], [2, 1], [2, -1]];
  for (const [x0, y0, x1, y1, z0, z1] of job.keep_outs) {
    for (const [axis, side] of faces) {
      const at_ = (/** @type {boolean} */ u, /** @type {boolean} */ v) => {
        const sides = [u, v], p = [0, 1, 2].map(k => k === axis ? side > 0 : sides.shift());
        corners.push(p[0] ? x1 : x0, p[1] ? y1 : y0, p[2] ? z1 : z0, ...[0, 1, 2].map(k => k === axis ? side : 0), 2);
      };
      for (const [u, v] of [[0, 0], [1, 0], [0, 1], [0, 1], [1, 0], [1, 1]]) at_(u === 1, v === 1);
    }
  }
  clamps = madeOf(corners);
}

/** @type {(values: UniformValues) => void} */
function drawClamps(values) {
  if (clamps.count === 0) return;
  gl.bindVertexArray(clamps.array);
  use(cutters.program, {...values, tip: [0, 0, 0], edgeColor: rgb(css('rapid')), strength: 0.85});
  gl.drawArrays(gl.TRIANGLES, 0, clamps.count);
  gl.bindVertexArray(null);
}

/** @type {(values: UniformValues) => void} */
function drawCutter(values) {
  if (count === 0) return;
  const i = Math.max(0, shownMove()), tool = job.sections[moves.section[i]].tool, p = pointAt(i, shownFraction());
  if (tool < 0) return;
  const cuts = p.z < job.top && moves.kind[i] !== 0;
  gl.bindVertexArray(cutters.made[tool].array);
  use(cutters.program, {...values, tip: [p.x, p.y, p.z], edgeColor: rgb(css(cuts ? 'entry' : 'rapid')), strength: 0.55});
  gl.enable(gl.CULL_FACE);
  gl.drawArrays(gl.TRIANGLES, 0, cutters.made[tool].count);
  gl.disable(gl.CULL_FACE);
  gl.bindVertexArray(null);
}
