// ---- The material: the heights as a surface of rectangles, the sides of the stock, the face of a section.
/** Made by startSpace(): the whole; and what is in sight in finer cells, where there is that. @type {Surface} */
let surface;
/** @type {Surface | null} */
let fineSurface = null;
/** @type {Record<'top' | 'plainTop' | 'wall' | 'plainWall', Shader>} */
let surfacePrograms;
const CORNER = 16;  // bytes: column and row, height, direction square to the surface, colour
const NO_HOLE = [1, 1, 0, 0];

function makeSurface() {
  const top = (/** @type {string} */ fragment) => programOf(SURFACE_VERTEX, fragment, ['corner', 'altitude', 'normal', 'tint']);
  surfacePrograms = {
    top: top(SURFACE_FRAGMENT),
    plainTop: top(plainOf(SURFACE_FRAGMENT)),
    wall: programOf(WALL_VERTEX, WALL_FRAGMENT, []),
    plainWall: programOf(WALL_VERTEX, plainOf(WALL_FRAGMENT), [])
  };
  textureOf(1, gl.RGBA8, 256, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(shades.flatMap(color => [...color, 255])));
  surface = surfaceOf(whole, {heights: 0, rests: 2});
  fineSurface = surfaceBefore = null;
  soilAll();
}

/** @type {(g: Grid, units: Surface['units']) => Surface} */
function surfaceOf(g, units) {
  const across = Math.ceil((g.block.x1 - g.block.x0 - 1) / TILE), down = Math.ceil((g.block.y1 - g.block.y0 - 1) / TILE);
  const textures = {
    heights: textureOf(units.heights, gl.R32F, g.width, g.height, gl.RED, gl.FLOAT, g.heights),
    rests: textureOf(units.rests, gl.RGBA8, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))
  };
  const made = {
    grid: g,
    textures,
    units,
    array: gl.createVertexArray(),
    corners: gl.createBuffer(),
    indices: gl.createBuffer(),
    quads: 0,
    room: 0,
    tiles: Array.from({length: across * down}, () => ({})),
    across,
    down,
    key: '',
    version: 0,
    restsLoaded: false
  };
  gl.bindVertexArray(made.array);
  gl.bindBuffer(gl.ARRAY_BUFFER, made.corners);
  for (const k of [0, 1, 2, 3]) gl.enableVertexAttribArray(k);
  gl.vertexAttribPointer(0, 2, gl.UNSIGNED_SHORT, false, CORNER, 0);
  gl.vertexAttribPointer(1, 1, gl.FLOAT, false, CORNER, 4);
  gl.vertexAttribPointer(2, 3, gl.BYTE, true, CORNER, 8);
  gl.vertexAttribPointer(3, 4, gl.UNSIGNED_BYTE, true, CORNER, 12);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, made.indices);
  gl.bindVertexArray(null);
  return made;
}

/** The surfaces to be drawn; one of a window that is not in sight any more is given back. @type {() => Surface[]} */
function surfacesInSight() {
  if (fineSurface && fineSurface.grid !== lens.grid) {
    giveBack(fineSurface);
    fineSurface = null;
  }
  if (!lens.on || !lens.grid) return [surface];
  fineSurface ??= surfaceOf(lens.grid, {heights: 3, rests: 4});
  return [surface, fineSurface];
}

/** What it holds of the graphics processor. @type {(s: Surface) => void} */
function giveBack(s) {
  gl.deleteVertexArray(s.array);
  for (const buffer of [s.corners, s.indices]) gl.deleteBuffer(buffer);
  for (const texture of [s.textures.heights, s.textures.rests]) gl.deleteTexture(texture);
}

/** Whether all corners of the cells of a square lie at one height. @type {(g: Grid, x0: number, y0: number, x1: number, y1: number) => boolean} */
function isLevel(g, x0, y0, x1, y1) {
  const {heights: h, width: w} = g, first = h[y0 * w + x0];
  for (let y = y0; y <= y1; ++y)
    for (let k = y * w + x0; k <= y * w + x1; ++k)
      if (h[k] !== first) return false;
  return true;
}

/**
 * The tile in rectangles: of squares of `least` cells those that lie level as large as they come together, the others each alone. Column and row of
 * two corners, and whether it is level.
 * @type {(s: Surface, tile: number, least: number) => Piece[]}
 */
function piecesOf(s, tile, least) {
  const g = s.grid, x0 = g.block.x0 + tile % s.across * TILE, y0 = g.block.y0 + Math.floor(tile / s.across) * TILE;
  const right = Math.min(g.block.x1 - 1, x0 + TILE), low = Math.min(g.block.y1 - 1, y0 + TILE), across = Math.ceil((right - x0) / least),
        down = Math.ceil((low - y0) / least);
  const isSolid = (/** @type {number} */ x, /** @type {number} */ y) => g.heights[y * g.width + x] > bottomZ;
  if (isLevel(g, x0, y0, right, low)) return isSolid(x0, y0) ? [[x0, y0, right, low, true]] : [];
  const columnOf = (/** @type {number} */ i) => Math.min(right, x0 + i * least),
        rowOf = (/** @type {number} */ j) => Math.min(low, y0 + j * least);
  const free = new Uint8Array(across * down);  // level and in no piece yet
  for (let j = 0; j < down; ++j)
    for (let i = 0; i < across; ++i) free[j * across + i] = Number(isLevel(g, columnOf(i), rowOf(j), columnOf(i + 1), rowOf(j + 1)));
  /** @type {Piece[]} */
  const pieces = [];
  const done = Uint8Array.from(free, level => 1 - level);
  for (let j = 0; j < down; ++j)
    for (let i = 0; i < across; ++i) {
      const k = j * across + i;
      if (!free[k]) {
        if (done[k]) pieces.push([columnOf(i), rowOf(j), columnOf(i + 1), rowOf(j + 1), false]);
        continue;
      }
      let i1 = i + 1, j1 = j + 1;
      while (i1 < across && free[j * across + i1]) ++i1;
      while (j1 < down && free.subarray(j1 * across + i, j1 * across + i1).every(Boolean)) ++j1;
      for (let row = j; row < j1; ++row) free.fill(0, row * across + i, row * across + i1);
      if (isSolid(columnOf(i), rowOf(j))) pieces.push([columnOf(i), rowOf(j), columnOf(i1), rowOf(j1), true]);
    }
  return pieces;
}

/** Slopes of the heights around a cell, over so many cells on each side; nearer rows count twice. @type {(g: Grid, x: number, y: number, least: number) => [number, number]} */
function slopesAt(g, x, y, least) {
  const {heights: h, width: w, block: in_} = g;
  /** @type {(dx: number, dy: number) => number} */
  const z = (dx, dy) => Math.max(
    bottomZ - 1, h[Math.max(in_.y0, Math.min(in_.y1 - 1, y + dy * least)) * w + Math.max(in_.x0, Math.min(in_.x1 - 1, x + dx * least))]);
  const a = z(-1, -1), b = z(1, -1), c = z(-1, 1), d = z(1, 1), per = 8 * least / g.scale;
  return [(a - b + c - d + 2 * (z(-1, 0) - z(1, 0))) / per, (c - a + d - b + 2 * (z(0, 1) - z(0, -1))) / per];
}

/**
 * The corners of a tile's pieces as the shader takes them: column and row in sixteenths. Level ones are that much larger than they
 * are, so that no gap shows where a large one meets small ones.
 * @type {(s: Surface, tile: number, least: number) => Uint8Array}
 */
function cornersOf(s, tile, least) {
  const g = s.grid, pieces = piecesOf(s, tile, least), bytes = new ArrayBuffer(4 * CORNER * pieces.length), shorts = new Uint16Array(bytes),
        floats = new Float32Array(bytes);
  const signed = new Int8Array(bytes), colors = new Uint8Array(bytes);
  let n = 0;
  for (const [x0, y0, x1, y1, level] of pieces) {
    for (let corner = 0; corner < 4; ++corner, ++n) {
      const x = corner < 2 ? x0 : x1, y = corner % 2 ? y1 : y0, more = level ? 1 : 0, k = CORNER * n;
      const h = Math.max(bottomZ - 1, g.heights[y * g.width + x]), color = shades[shadeAt(h)],
            [dx, dy] = level ? [0, 0] : slopesAt(g, x, y, least), one = 127 / Math.hypot(dx, dy, 1);
      shorts[8 * n] = Math.max(0, 16 * x + (corner < 2 ? -more : more));
      shorts[8 * n + 1] = Math.max(0, 16 * y + (corner % 2 ? more : -more));
      floats[4 * n + 1] = h;
      signed[k + 8] = dx * one;
      signed[k + 9] = dy * one;
      signed[k + 10] = one;
      colors[k + 12] = color[0];
      colors[k + 13] = color[1];
      colors[k + 14] = color[2];
    }
  }
  return colors;
}

/** Hands what has changed to the graphics processor. @type {(s: Surface) => void} */
function updateHeights(s) {
  const g = s.grid, box = taken(g.soiled, g);
  if (!box) return;
  gl.activeTexture(gl.TEXTURE0 + s.units.heights);
  gl.pixelStorei(gl.UNPACK_ROW_LENGTH, g.width);
  gl.pixelStorei(gl.UNPACK_SKIP_PIXELS, box.x0);
  gl.pixelStorei(gl.UNPACK_SKIP_ROWS, box.y0);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, box.x0, box.y0, box.w, box.h, gl.RED, gl.FLOAT, g.heights);
  for (const name of [gl.UNPACK_ROW_LENGTH, gl.UNPACK_SKIP_PIXELS, gl.UNPACK_SKIP_ROWS]) gl.pixelStorei(name, 0);
  /** @type {(v: number, from: number, most: number) => number} */
  const tile = (v, from, most) => Math.max(0, Math.min(most - 1, Math.floor((v - from) / TILE)));
  const tx0 = tile(box.x0 - 1, g.block.x0, s.across), tx1 = tile(box.x0 + box.w, g.block.x0, s.across);
  const ty0 = tile(box.y0 - 1, g.block.y0, s.down), ty1 = tile(box.y0 + box.h, g.block.y0, s.down);
  for (let ty = ty0; ty <= ty1; ++ty)
    for (let tx = tx0; tx <= tx1; ++tx) s.tiles[ty * s.across + tx] = {};
  ++s.version;
}

/** Whether a tile may be seen on the stage. @type {(s: Surface, tile: number, axes: CameraAxes) => boolean} */
function onStage(s, tile, axes) {
  const g = s.grid, half = TILE / 2 / g.scale, x = g.x0 + (g.block.x0 + tile % s.across * TILE) / g.scale + half,
        y = g.y1 - (g.block.y0 + Math.floor(tile / s.across) * TILE) / g.scale - half;
  const q = beside({x, y, z: (job.top + bottomZ) / 2}),
        reach = (1.5 * half + (job.top - Math.min(bottomZ, job.bottom)) / 2) * camera.k * 1.5;
  return Math.abs(dot(axes.right, q)) * camera.k < view.w / 2 + reach && Math.abs(dot(axes.up, q)) * camera.k < view.h / 2 + reach;
}

/** Puts the pieces of all tiles on the stage into one buffer. @type {(s: Surface, least: number) => void} */
function updateSquares(s, least) {
  const axes = cameraAxes();
  /** @type {number[]} */
  const seen = [];
  s.tiles.forEach((made, tile) => {
    if (onStage(s, tile, axes)) seen.push(tile);
  });
  const key = least + ' ' + s.version + ' ' + seen.join();
  if (key === s.key) return;
  s.key = key;
  const pieces = seen.map(tile => s.tiles[tile][least] ??= cornersOf(s, tile, least));
  const all = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  pieces.reduce((from, piece) => {
    all.set(piece, from);
    return from + piece.length;
  }, 0);
  s.quads = all.length / CORNER / 4;
  gl.bindBuffer(gl.ARRAY_BUFFER, s.corners);
  gl.bufferData(gl.ARRAY_BUFFER, all, gl.DYNAMIC_DRAW);
  growIndices(s);
}

/** Two triangles for each square; the array is bound. @type {(s: Surface) => void} */
function growIndices(s) {
  if (s.quads <= s.room) return;
  s.room = 2 * s.quads;
  const indices = new Uint32Array(6 * s.room);
  for (let n = 0; n < s.room; ++n) indices.set([4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 2, 4 * n + 1, 4 * n + 3], 6 * n);
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
}

/** Everything that the shaders of the material are told in a frame. @type {(s: Surface) => UniformValues} */
function valuesOfSurface(s) {
  const axes = cameraAxes(), light = [0, 1, 2].map(k => -0.45 * axes.right[k] + 0.4 * axes.up[k] + 0.8 * axes.near[k]),
        length = Math.hypot(...light), g = s.grid;
  return {
    view: viewMatrix(),
    heights: {i: s.units.heights},
    palette: {i: 1},
    rests: {i: s.units.rests},
    block: [g.block.x0, g.block.y0, g.block.x1 - 1, g.block.y1 - 1],
    grid: [g.x0, g.y1, 1 / g.scale, 0],
    edges: g.edges,
    level: section.axis === 'z' ? section.at : 1e30,
    bottom: bottomZ,
    section: sectionPlane(),
    light: light.map(v => v / length),
    capColor: rgb(css('section')),
    restColor: rgb(job.bad),
    range: [job.bottom, job.top],
    showRests: {i: s.restsLoaded && at.time >= total ? 1 : 0},
    hole: s === surface && lens.on && lens.grid ? lens.grid.edges : NO_HOLE
  };
}

/** Whether a surface is seen as it is: not cut open, no hole where finer cells lie, no rests in red. @type {(values: UniformValues) => boolean} */
const isPlain = values => section.axis === 'none' && values.hole === NO_HOLE && !(showsRests() && surface.restsLoaded);

const showsRests = () => !job.clean && at.time >= total;

/** @type {(s: Surface) => void} */
function loadRests(s) {
  if (s.restsLoaded || !showsRests()) return;
  gl.activeTexture(gl.TEXTURE0 + s.units.rests);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, restsAtTheEnd(s.grid));
  s.restsLoaded = true;
}

/** `detail_`: 1 shows every cell that is as large as a pixel, 2 and 4 leave out more. @type {(detail_: number, isBefore: boolean) => void} */
function drawSurface(detail_, isBefore) {
  gl.enable(gl.POLYGON_OFFSET_FILL);
  gl.polygonOffset(1, 2);
  for (const one of isBefore && change.grid ? [surfaceOfBefore(change.grid)] : surfacesInSight()) {
    if (!isBefore) loadRests(one);
    updateHeights(one);
    const values = valuesOfSurface(one), pixels = camera.k * view.ratio / one.grid.scale,
          least = Math.min(8,
            detail_ *
              (pixels > 0.7     ? 1 :
                  pixels > 0.35 ? 2 :
                                  4));
    gl.bindVertexArray(one.array);
    updateSquares(one, least);
    for (const under of camera.pitch < 0 ? [0, 1] : [0]) {
      use(isPlain(values) ? surfacePrograms.plainTop : surfacePrograms.top, {...values, under});
      gl.drawElements(gl.TRIANGLES, 6 * one.quads, gl.UNSIGNED_INT, 0);
    }
    gl.bindVertexArray(null);
    drawWalls(one.grid, least, values);
  }
  gl.disable(gl.POLYGON_OFFSET_FILL);
}

/** The sides of the stock that are seen and the face of a section, as far as they lie in the grid, at each `every`th cell. @type {(g: Grid, every: number, values: UniformValues) => void} */
function drawWalls(g, every, values) {
  const near = cameraAxes().near, [x0, y0, x1, y1] = g.edges;
  /** @type {(along: number, at_: number, shade_: number, hatch: number) => void} */
  const wall = (along, at_, shade_, hatch) => {
    if (along === 0 ? at_ < y0 || at_ > y1 : at_ < x0 || at_ > x1) return;
    use(isPlain(values) ? surfacePrograms.plainWall : surfacePrograms.wall,
      {...values, along: {i: along}, every: {i: every}, at: at_, shade: shade_, hatch});
    gl.drawArrays(
      gl.TRIANGLE_STRIP, 0, 2 * (Math.ceil(((along === 0 ? g.block.x1 - g.block.x0 : g.block.y1 - g.block.y0) - 1) / every) + 1));
  };
  wall(0, near[1] > 0 ? sy1 : sy0, 0.78, 0);
  wall(1, near[0] > 0 ? sx1 : sx0, 0.7, 0);
  if (section.axis === 'y' && section.at > sy0 && section.at < sy1) wall(0, section.at, 1, 7 / camera.k);
  if (section.axis === 'x' && section.at > sx0 && section.at < sx1) wall(1, section.at, 1, 7 / camera.k);
}
