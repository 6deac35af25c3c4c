// ---- The material: the heights as a surface of squares, the sides of the stock, the face of a section.
/**
 * Made by startSpace(). Of each tile the corners of its squares, by the least size of one in cells; `room`: squares that the indices
 * suffice for; `key` says what the buffer holds, `version` counts changes of the heights.
 * @type {{ program: Shader, wall: Shader, array: WebGLVertexArrayObject, corners: WebGLBuffer, quads: number, room: number,
 *   tiles: Record<number, Uint8Array>[], across: number, down: number, key: string, version: number, restsLoaded: boolean }}
 */
let surface;
const CORNER = 16;  // bytes: column and row, height, direction square to the surface, colour

function makeSurface() {
  const across = Math.ceil((block.x1 - block.x0 - 1) / TILE), down = Math.ceil((block.y1 - block.y0 - 1) / TILE);
  surface = { program: programOf(SURFACE_VERTEX, SURFACE_FRAGMENT, ['corner', 'altitude', 'normal', 'tint']), wall: programOf(WALL_VERTEX, WALL_FRAGMENT, []),
    array: gl.createVertexArray(), corners: gl.createBuffer(), quads: 0, room: 0, tiles: Array.from({ length: across * down }, () => ({})), across, down,
    key: '', version: 0, restsLoaded: false };
  textureOf(0, gl.R32F, width, height, gl.RED, gl.FLOAT, heights);
  textureOf(1, gl.RGBA8, 256, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(shades.flatMap(color => [...color, 255])));
  textureOf(2, gl.RGBA8, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  gl.bindVertexArray(surface.array);
  gl.bindBuffer(gl.ARRAY_BUFFER, surface.corners);
  for (const k of [0, 1, 2, 3]) gl.enableVertexAttribArray(k);
  gl.vertexAttribPointer(0, 2, gl.UNSIGNED_SHORT, false, CORNER, 0);
  gl.vertexAttribPointer(1, 1, gl.FLOAT, false, CORNER, 4);
  gl.vertexAttribPointer(2, 3, gl.BYTE, true, CORNER, 8);
  gl.vertexAttribPointer(3, 4, gl.UNSIGNED_BYTE, true, CORNER, 12);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bindVertexArray(null);
  soilAll();
}

/** Whether all corners of the cells of a square lie at one height. @type {(x0: number, y0: number, x1: number, y1: number) => boolean} */
function isLevel(x0, y0, x1, y1) {
  const first = heights[y0 * width + x0];
  for (let y = y0; y <= y1; ++y) for (let k = y * width + x0; k <= y * width + x1; ++k) if (heights[k] !== first) return false;
  return true;
}

/**
 * Squares of a tile, as large as they are level, no smaller than `least` cells: column, row, cells across and down, 1 where level.
 * @type {(tile: number, least: number) => Square[]}
 */
function squaresOf(tile, least) {
  const right = block.x1 - 1, low = block.y1 - 1;
  /** @type {Square[]} */
  const squares = [];
  /** @type {(x: number, y: number, size: number) => void} */
  const split = (x, y, size) => {
    if (x >= right || y >= low) return;
    const x1 = Math.min(right, x + size), y1 = Math.min(low, y + size), level = isLevel(x, y, x1, y1);
    if (!level && size > least) {
      const half = size / 2;
      split(x, y, half); split(x + half, y, half); split(x, y + half, half); split(x + half, y + half, half);
    } else if (!level || heights[y * width + x] > bottomZ) squares.push([x, y, x1, y1, level]);
  };
  split(block.x0 + tile % surface.across * TILE, block.y0 + Math.floor(tile / surface.across) * TILE, TILE);
  return squares;
}

/** Slopes of the heights around a cell, over so many cells on each side; nearer rows count twice. @type {(x: number, y: number, least: number) => [number, number]} */
function slopesAt(x, y, least) {
  /** @type {(dx: number, dy: number) => number} */
  const z = (dx, dy) => Math.max(bottomZ - 1, heights[Math.max(block.y0, Math.min(block.y1 - 1, y + dy * least)) * width + Math.max(block.x0, Math.min(block.x1 - 1, x + dx * least))]);
  const a = z(-1, -1), b = z(1, -1), c = z(-1, 1), d = z(1, 1), per = 8 * least / scale;
  return [(a - b + c - d + 2 * (z(-1, 0) - z(1, 0))) / per, (c - a + d - b + 2 * (z(0, 1) - z(0, -1))) / per];
}

/**
 * The corners of a tile's squares as the shader takes them: column and row in sixteenths. Level squares are that much larger than they
 * are, so that no gap shows where a large one meets small ones.
 * @type {(tile: number, least: number) => Uint8Array}
 */
function cornersOf(tile, least) {
  const squares = squaresOf(tile, least), bytes = new ArrayBuffer(4 * CORNER * squares.length), shorts = new Uint16Array(bytes), floats = new Float32Array(bytes);
  const signed = new Int8Array(bytes), colors = new Uint8Array(bytes);
  let n = 0;
  for (const [x0, y0, x1, y1, level] of squares) {
    for (let corner = 0; corner < 4; ++corner, ++n) {
      const x = corner < 2 ? x0 : x1, y = corner % 2 ? y1 : y0, more = level ? 1 : 0, k = CORNER * n;
      const h = Math.max(bottomZ - 1, heights[y * width + x]), color = shades[shadeAt(h)], [dx, dy] = level ? [0, 0] : slopesAt(x, y, least), one = 127 / Math.hypot(dx, dy, 1);
      shorts[8 * n] = Math.max(0, 16 * x + (corner < 2 ? -more : more)); shorts[8 * n + 1] = Math.max(0, 16 * y + (corner % 2 ? more : -more));
      floats[4 * n + 1] = h;
      signed[k + 8] = dx * one; signed[k + 9] = dy * one; signed[k + 10] = one;
      colors[k + 12] = color[0]; colors[k + 13] = color[1]; colors[k + 14] = color[2];
    }
  }
  return colors;
}

/** Hands what has changed to the graphics processor. */
function updateHeights() {
  const box = taken(soiled);
  if (!box) return;
  gl.activeTexture(gl.TEXTURE0);
  gl.pixelStorei(gl.UNPACK_ROW_LENGTH, width);
  gl.pixelStorei(gl.UNPACK_SKIP_PIXELS, box.x0);
  gl.pixelStorei(gl.UNPACK_SKIP_ROWS, box.y0);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, box.x0, box.y0, box.w, box.h, gl.RED, gl.FLOAT, heights);
  for (const name of [gl.UNPACK_ROW_LENGTH, gl.UNPACK_SKIP_PIXELS, gl.UNPACK_SKIP_ROWS]) gl.pixelStorei(name, 0);
  /** @type {(v: number, from: number, most: number) => number} */
  const tile = (v, from, most) => Math.max(0, Math.min(most - 1, Math.floor((v - from) / TILE)));
  const tx0 = tile(box.x0 - 1, block.x0, surface.across), tx1 = tile(box.x0 + box.w, block.x0, surface.across);
  const ty0 = tile(box.y0 - 1, block.y0, surface.down), ty1 = tile(box.y0 + box.h, block.y0, surface.down);
  for (let ty = ty0; ty <= ty1; ++ty) for (let tx = tx0; tx <= tx1; ++tx) surface.tiles[ty * surface.across + tx] = {};
  ++surface.version;
}

/** Whether a tile may be seen on the stage. @type {(tile: number, axes: CameraAxes) => boolean} */
function onStage(tile, axes) {
  const half = TILE / 2 / scale, x = wx0 + (block.x0 + tile % surface.across * TILE) / scale + half, y = wy1 - (block.y0 + Math.floor(tile / surface.across) * TILE) / scale - half;
  const q = beside({ x, y, z: (job.top + bottomZ) / 2 }), reach = (1.5 * half + (job.top - Math.min(bottomZ, job.bottom)) / 2) * camera.k * 1.5;
  return Math.abs(dot(axes.right, q)) * camera.k < view.w / 2 + reach && Math.abs(dot(axes.up, q)) * camera.k < view.h / 2 + reach;
}

/** Puts the squares of all tiles on the stage into one buffer. @type {(least: number) => void} */
function updateSquares(least) {
  const axes = cameraAxes();
  /** @type {number[]} */
  const seen = [];
  surface.tiles.forEach((made, tile) => { if (onStage(tile, axes)) seen.push(tile); });
  const key = least + ' ' + surface.version + ' ' + seen.join();
  if (key === surface.key) return;
  surface.key = key;
  const pieces = seen.map(tile => surface.tiles[tile][least] ??= cornersOf(tile, least));
  const all = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  pieces.reduce((from, piece) => { all.set(piece, from); return from + piece.length; }, 0);
  surface.quads = all.length / CORNER / 4;
  gl.bindBuffer(gl.ARRAY_BUFFER, surface.corners);
  gl.bufferData(gl.ARRAY_BUFFER, all, gl.DYNAMIC_DRAW);
  growIndices();
}

/** Two triangles for each square; the array is bound. */
function growIndices() {
  if (surface.quads <= surface.room) return;
  surface.room = 2 * surface.quads;
  const indices = new Uint32Array(6 * surface.room);
  for (let n = 0; n < surface.room; ++n) indices.set([4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 2, 4 * n + 1, 4 * n + 3], 6 * n);
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
}

/** Everything that the shaders of the material are told in a frame. @type {() => UniformValues} */
function valuesOfSurface() {
  const axes = cameraAxes(), light = [0, 1, 2].map(k => -0.45 * axes.right[k] + 0.4 * axes.up[k] + 0.8 * axes.near[k]), length = Math.hypot(...light);
  return { view: viewMatrix(), heights: { i: 0 }, palette: { i: 1 }, rests: { i: 2 }, block: [block.x0, block.y0, block.x1 - 1, block.y1 - 1],
    grid: [wx0, wy1, 1 / scale, 0], edges: [sx0, sy0, sx1, sy1], level: section.axis === 'z' ? section.at : 1e30, bottom: bottomZ,
    section: sectionPlane(), light: light.map(v => v / length), capColor: rgb(css('section')), restColor: rgb(job.bad), range: [job.bottom, job.top],
    showRests: { i: surface.restsLoaded && at.time >= total ? 1 : 0 } };
}

function loadRests() {
  if (surface.restsLoaded || job.clean || at.time < total) return;
  gl.activeTexture(gl.TEXTURE2);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, restsAtTheEnd());
  surface.restsLoaded = true;
}

/** `detail_`: 1 shows every cell that is as large as a pixel, 2 and 4 leave out more. @type {(detail_: number) => void} */
function drawSurface(detail_) {
  loadRests();
  updateHeights();
  const values = valuesOfSurface(), pixels = camera.k * view.ratio / scale, least = Math.min(8, detail_ * (pixels > 0.7 ? 1 : pixels > 0.35 ? 2 : 4));
  gl.bindVertexArray(surface.array);
  updateSquares(least);
  gl.enable(gl.POLYGON_OFFSET_FILL);
  gl.polygonOffset(1, 2);
  for (const under of camera.pitch < 0 ? [0, 1] : [0]) {
    use(surface.program, { ...values, under });
    gl.drawElements(gl.TRIANGLES, 6 * surface.quads, gl.UNSIGNED_INT, 0);
  }
  gl.bindVertexArray(null);
  const near = cameraAxes().near, across = block.x1 - block.x0, down = block.y1 - block.y0;
  /** @type {(along: number, at_: number, shade_: number, hatch: number) => void} */
  const wall = (along, at_, shade_, hatch) => {
    use(surface.wall, { ...values, along: { i: along }, at: at_, shade: shade_, hatch });
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 2 * (along === 0 ? across : down));
  };
  wall(0, near[1] > 0 ? sy1 : sy0, 0.78, 0);
  wall(1, near[0] > 0 ? sx1 : sx0, 0.7, 0);
  if (section.axis === 'y' && section.at > sy0 && section.at < sy1) wall(0, section.at, 1, 7 / camera.k);
  if (section.axis === 'x' && section.at > sx0 && section.at < sx1) wall(1, section.at, 1, 7 / camera.k);
  gl.disable(gl.POLYGON_OFFSET_FILL);
}
