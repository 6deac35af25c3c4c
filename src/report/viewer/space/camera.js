// ---- The camera of the view in space: parallel rays, so that equal lengths stay equal. z is up.
/** @type {{ on: boolean, supported: boolean | null, why: string }} */
const space = {
  on: false,
  supported: null,
  why: ''
};
// The place in the middle of the stage in mm, pixels per mm, and where the viewer stands: around z from the front, above the horizon.
const camera = {
  x: 0,
  y: 0,
  z: 0,
  k: 1,
  yaw: 0,
  pitch: 0,
  fitted: true
};
const DEGREE = Math.PI / 180;
/** @type {Record<string, [number, number]>} */
const STANDPOINTS = {
  iso: [45, 35.264],
  top: [0, 90],
  front: [0, 0],
  right: [90, 0]
};
// Of the stock. Where none is given the part is solid below everything that is cut.
const bottomZ = job.stock && job.stock_z !== null ? job.stock_z : job.bottom - 0.02 * Math.hypot(wx1 - wx0, wy1 - wy0);

/** Directions on the screen in the part's frame: to the right, up, and towards the viewer. @type {() => CameraAxes} */
function cameraAxes() {
  const c = Math.cos(camera.yaw * DEGREE), s = Math.sin(camera.yaw * DEGREE), up = Math.sin(camera.pitch * DEGREE),
        flat = Math.cos(camera.pitch * DEGREE);
  return {right: [c, s, 0], up: [-s * up, c * up, flat], near: [s * flat, -c * flat, up]};
}
/** @type {(a: Triple, p: Place) => number} */
const dot = (a, p) => a[0] * p.x + a[1] * p.y + a[2] * p.z;
/** @type {(p: Point & { z?: number }) => Place} */
const beside = p => ({x: p.x - camera.x, y: p.y - camera.y, z: (p.z || 0) - camera.z});

/** @type {(p: Point & { z?: number }) => Point} */
function projected(p) {
  const axes = cameraAxes(), q = beside(p);
  return {x: view.w / 2 + dot(axes.right, q) * camera.k, y: view.h / 2 - dot(axes.up, q) * camera.k};
}

/** The place on the plane through the middle, square to the rays, that is seen at a point of the stage. @type {(s: Point) => Place} */
function onMiddlePlane(s) {
  const axes = cameraAxes(), a = (s.x - view.w / 2) / camera.k, b = (view.h / 2 - s.y) / camera.k;
  const mix = (/** @type {0 | 1 | 2} */ k) => a * axes.right[k] + b * axes.up[k];
  return {x: camera.x + mix(0), y: camera.y + mix(1), z: camera.z + mix(2)};
}

/** @type {() => Place[]} */
const stageCorners = () => [0, 1, 2, 3, 4, 5, 6, 7].map(
  k => ({x: k & 1 ? wx1 : wx0, y: k & 2 ? wy1 : wy0, z: k & 4 ? job.top : Math.min(bottomZ, job.bottom)}));

/** The whole stage in sight. */
function fitSpace() {
  camera.x = (wx0 + wx1) / 2;
  camera.y = (wy0 + wy1) / 2;
  camera.z = (job.top + bottomZ) / 2;
  const axes = cameraAxes(),
        reach = (/** @type {Triple} */ axis) => Math.max(...stageCorners().map(p => Math.abs(dot(axis, beside(p))))) || 1;
  camera.k = Math.min(0.94 * view.w / 2 / reach(axes.right), freeHeight() / 2 / reach(axes.up));
  camera.fitted = true;
}

/** Pixels per mm and a part's diagonal: how far in and out one may go. @type {(factor: number, s: Point) => void} */
function zoomSpace(factor, s) {
  const fixedPlace = onMiddlePlane(s), whole = Math.min(view.w, view.h) / Math.hypot(wx1 - wx0, wy1 - wy0, job.top - bottomZ);
  camera.k = Math.max(whole / 8, Math.min(MOST, camera.k * factor));
  const now = onMiddlePlane(s);
  camera.x += fixedPlace.x - now.x;
  camera.y += fixedPlace.y - now.y;
  camera.z += fixedPlace.z - now.z;
  camera.fitted = false;
  redrawSoon();
}

/** @type {(dx: number, dy: number) => void} */
function panSpace(dx, dy) {
  const from = onMiddlePlane({x: 0, y: 0}), to = onMiddlePlane({x: dx, y: dy});
  camera.x -= to.x - from.x;
  camera.y -= to.y - from.y;
  camera.z -= to.z - from.z;
  camera.fitted = false;
  redrawSoon();
}

/** @type {(yaw: number, pitch: number) => void} */
function orbit(yaw, pitch) {
  camera.yaw = ((camera.yaw + yaw) % 360 + 360) % 360;
  camera.pitch = Math.max(-90, Math.min(90, camera.pitch + pitch));
  if (camera.fitted) fitSpace();
  markStandpoint();
  redrawSoon();
}

/** @type {(name: string) => void} */
function standAt(name) {
  [camera.yaw, camera.pitch] = STANDPOINTS[name];
  fitSpace();
  markStandpoint();
  redrawSoon();
}

/** Columns of the matrix from the part's mm to the cube that WebGL draws; deep enough for all there is. */
function viewMatrix() {
  const axes = cameraAxes(),
        far = 2 * Math.hypot(wx1 - wx0, wy1 - wy0, job.top - bottomZ) + 400 + Math.hypot(camera.x - wx0, camera.y - wy0, camera.z);
  const rows = [axes.right.map(v => v * 2 * camera.k / view.w), axes.up.map(v => v * 2 * camera.k / view.h), axes.near.map(v => -v / far)];
  const matrix = new Float32Array(16);
  rows.forEach((row, r) => {
    row.forEach((v, c) => {
      matrix[4 * c + r] = v;
    });
    matrix[12 + r] = -(row[0] * camera.x + row[1] * camera.y + row[2] * camera.z);
  });
  matrix[15] = 1;
  return matrix;
}

/** Where the ray through a point of the stage meets the material, mm; null: nowhere. Steps of half a cell, then halves. @type {(s: Point) => Place | null} */
function surfaceAt(s) {
  const g = gridAt(s), near = cameraAxes().near, middle = onMiddlePlane(s), far = Math.hypot(wx1 - wx0, wy1 - wy0, job.top - bottomZ) + 1;
  const place = (/** @type {number} */ t) => ({x: middle.x + near[0] * t, y: middle.y + near[1] * t, z: middle.z + near[2] * t});
  const inside = (/** @type {Place} */ p) => {
    const x = Math.floor((p.x - g.x0) * g.scale), y = Math.floor((g.y1 - p.y) * g.scale);
    if (x < g.block.x0 || x >= g.block.x1 || y < g.block.y0 || y >= g.block.y1) return false;
    return p.z >= bottomZ && p.z <= Math.min(g.heights[y * g.width + x], section.axis === 'z' ? section.at : Infinity) && !isCutOff(p);
  };
  const step = 0.5 / g.scale;
  for (let t = far; t > -far; t -= step) {
    if (!inside(place(t))) continue;
    let out = t + step, within = t;
    for (let k = 0; k < 20; ++k) {
      const half = (out + within) / 2;
      if (inside(place(half))) within = half;
      else out = half;
    }
    return place(within);
  }
  return null;
}
