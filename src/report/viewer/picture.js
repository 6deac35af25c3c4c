// ---- Pictures.
/** Red, green and blue of "#rrggbb", 0 to 255. @type {(color: string) => Triple} */
function channelsOf(color) {
  const at_ = (/** @type {number} */ k) => parseInt(color.slice(k, k + 2), 16);
  return [at_(1), at_(3), at_(5)];
}
const shades = job.shades.map(channelsOf);

/** Index of a height's colour. @type {(h: number) => number} */
const shadeAt = h => Math.max(0, Math.min(255, Math.round(255 * (h - job.bottom) / depth)));

/** Colours the dirty part of a grid's relief: shade of the depth, light from the upper left, shadow at the foot of walls. @type {(g: Grid) => void} */
function shade(g) {
  const box = taken(g.dirty, g);
  if (!box) return;
  const context = contextOf(g.relief), picture = context.createImageData(box.w, box.h), out = picture.data;
  /** @type {(x: number, y: number) => number} */
  const z = (x, y) => g.heights[Math.max(0, Math.min(g.height - 1, y)) * g.width + Math.max(0, Math.min(g.width - 1, x))];
  for (let y = box.y0; y < box.y0 + box.h; ++y) {
    for (let x = box.x0; x < box.x0 + box.w; ++x) {
      const here = z(x, y);
      if (here === NOTHING) continue;
      const k = 4 * ((y - box.y0) * box.w + x - box.x0);
      let light = 1 + Math.max(-0.25, Math.min(0.25, 0.03 * g.scale * (z(x + 1, y) - z(x - 1, y) + z(x, y + 1) - z(x, y - 1))));
      let shadow = 0;
      for (const step of [2, 4, 7]) {
        shadow = Math.max(shadow, Math.min(1, Math.max(0, z(x - step, y - step) - here - step * 0.25 / g.scale) / 3) * (1 - step / 10));
      }
      light *= 1 - 0.4 * shadow;
      const color = shades[shadeAt(here)];
      out[k] = color[0] * light;
      out[k + 1] = color[1] * light;
      out[k + 2] = color[2] * light;
      out[k + 3] = 255;
    }
  }
  context.putImageData(picture, box.x0, box.y0);
}

const outlines = job.features.map(feature => new Path2D(feature.path));
const TRAIL = 500;
/** @type {Place | null} */
let marked = null;

/** Where the cutter of a feature that is not clean could be, over its floor. @type {(feature: JobFeature, reach: NonNullable<JobFeature['reach']>, g: Grid) => Uint8ClampedArray} */
function reachOf(feature, reach, g) {
  const canvas = newCanvas(g), c = contextOf(canvas);
  toWorld(c, g);
  c.clip(new Path2D(feature.path), 'evenodd');
  c.lineWidth = reach.d;
  c.lineJoin = c.lineCap = 'round';
  const centers = new Path2D(reach.centers);
  c.fill(centers, 'evenodd');
  c.stroke(centers);
  c.stroke(new Path2D(reach.lines));
  return c.getImageData(0, 0, g.width, g.height).data;
}

/** Red where something is left within reach: how the program ends. A rest thinner than a cell of the grid is not seen. @type {(g: Grid) => HTMLCanvasElement} */
function restsAtTheEnd(g) {
  if (g.rests) return g.rests;
  const canvas = g.rests = newCanvas(g), c = contextOf(canvas), picture = c.createImageData(g.width, g.height), red = channelsOf(job.bad);
  let cells = 0;
  for (const feature of job.features) {
    if (!feature.reach) continue;
    const reach = reachOf(feature, feature.reach, g), floor = feature.floor + 1.5 * depth / 255;
    for (let k = 0; k < g.heights.length; ++k) {
      if (reach[4 * k + 3] < 255 || g.heights[k] <= floor) continue;
      picture.data.set([...red, 255], 4 * k);
      ++cells;
    }
  }
  c.putImageData(picture, 0, 0);
  if (g === whole) overlay.dataset.leftMm2 = fixed(cells / g.scale / g.scale, 1);
  return canvas;
}

/** A canvas of a grid's size, where it lies in the view. @type {(c: Context2D, canvas: HTMLCanvasElement, g: Grid) => void} */
function drawWorldPicture(c, canvas, g) {
  const corner = toScreen({x: g.x0, y: g.y1}), k = view.k / g.scale;
  c.save();
  c.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
  c.drawImage(canvas, corner.x, corner.y, g.width * k, g.height * k);
  c.restore();
}

/** What is left in red, and the places of all faults. @type {(c: Context2D, px: number) => void} */
function drawRests(c, px) {
  drawWorldPicture(c, restsAtTheEnd(gridInSight()), gridInSight());
  for (const place of faultPlaces) drawMark(c, px, place);
}

/** @type {(c: Context2D, px: number) => void} */
function drawOutlines(c, px) {
  c.lineWidth = 0.8 * px;
  c.strokeStyle = css('outline');
  c.save();
  if (job.stock) {
    c.beginPath();
    c.rect(job.stock[0], job.stock[1], job.stock[2] - job.stock[0], job.stock[3] - job.stock[1]);
    c.stroke();
    c.clip();
  }
  for (const outline of outlines) c.stroke(outline);
  c.restore();
  for (const [x0, y0, x1, y1] of job.keep_outs) {
    c.fillStyle = 'rgba(92,107,133,0.35)';
    c.fillRect(x0, y0, x1 - x0, y1 - y0);
    c.strokeRect(x0, y0, x1 - x0, y1 - y0);
  }
}

function drawOverlay() {
  measureStage();
  const c = contextOf(overlay), px = 1 / view.k, mode = by('path').value;
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.clearRect(0, 0, overlay.width, overlay.height);
  c.globalAlpha = mode === 'all' ? 0.3 : dark.matches ? 0.6 : 1;
  drawReliefs(c);
  c.globalAlpha = 1;
  setPlan(c);
  c.lineJoin = c.lineCap = 'round';
  drawOutlines(c, px);
  if (at.time >= total && !job.clean && !change.grid) drawRests(c, px);
  if (mode === 'all') drawWholePath(c);
  if (mode === 'recent') drawTrail(c, px);
  drawTool(c, px);
  if (marked) drawMark(c, px, marked);
  drawMeasure(c, px);
  drawCurtain(c);
}

/** The whole path in a canvas of its own, drawn anew only when the view or what is shown has changed. */
const pathPicture = document.createElement('canvas');
let pathKey = '';
/** @type {(c: Context2D) => void} */
function drawWholePath(c) {
  const key = [view.x, view.y, view.k, view.w, view.h, view.ratio, pictureVersion].join();
  if (key !== pathKey) {
    pathKey = key;
    pathPicture.width = overlay.width;
    pathPicture.height = overlay.height;
    const p = contextOf(pathPicture);
    setPlan(p);
    p.lineJoin = p.lineCap = 'round';
    p.lineWidth = 1.2 / view.k;
    for (let k = -1; k < classColors.length; ++k) strokeClass(p, k < 0 ? NO_VALUE : k, k < 0 ? noColor : classColors[k]);
  }
  c.save();
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.drawImage(pathPicture, 0, 0);
  c.restore();
  const i = shownMove();
  if (i < 0) return;
  c.beginPath();
  trace(c, i, 0, 1);
  c.lineWidth = 3.5 / view.k;
  c.strokeStyle = css('ink');
  c.stroke();
}

/** @type {(a: number, b: number, from: number, to: number) => boolean} */
const meets = (a, b, from, to) => Math.max(a, b) >= from && Math.min(a, b) <= to;
/** Whether the line goes on in move i + 1 of the same class. @type {(i: number, k: number) => boolean} */
const goesOnAfter = (i, k) => i + 1 < count && classOf[i + 1] === k && moves.turn[i + 1] === 0;

/** One stroke for all moves of a class. Rests of lines shorter than half a pixel are left to the next move. @type {(c: Context2D, k: number, color: string) => void} */
function strokeClass(c, k, color) {
  const short = 0.5 / view.k, min = toPlan({x: 0, y: view.h}), max = toPlan({x: view.w, y: 0});
  let last = -2, x = 0, y = 0;
  c.beginPath();
  for (let i = 0; i < count; ++i) {
    if (classOf[i] !== k || !shown(i)) continue;
    if (moves.turn[i] !== 0) {
      trace(c, i, 0, 1);
      continue;
    }
    const ax = moves.x0[i], ay = moves.y0[i], bx = moves.x1[i], by_ = moves.y1[i];
    if (!meets(ax, bx, min.x, max.x) || !meets(ay, by_, min.y, max.y)) continue;
    const goesOn = last === i - 1 && moves.turn[last] === 0;
    if (!goesOn) {
      c.moveTo(ax, ay);
      x = ax;
      y = ay;
    }
    last = i;
    if (goesOnAfter(i, k) && Math.abs(bx - x) < short && Math.abs(by_ - y) < short) continue;
    c.lineTo(bx, by_);
    x = bx;
    y = by_;
  }
  c.strokeStyle = color;
  c.globalAlpha = color === noColor ? 0.6 : 1;
  c.stroke();
  c.globalAlpha = 1;
}

/** @type {(c: Context2D, px: number) => void} */
function drawTrail(c, px) {
  const last = shownMove();
  for (let i = Math.max(0, last - TRAIL); i <= last; ++i) {
    if (!shown(i)) continue;
    c.beginPath();
    trace(c, i, 0, i === last ? shownFraction() : 1);
    c.lineWidth = (i === last ? 3 : 1.2) * px;
    c.setLineDash(moves.kind[i] === 0 ? [4 * px, 4 * px] : []);
    c.strokeStyle = colorOf(i);
    c.globalAlpha = 0.25 + 0.75 * Math.max(0, 1 - (last - i) / TRAIL);
    c.stroke();
  }
  c.setLineDash([]);
  c.globalAlpha = 1;
}

/** @type {(c: Context2D, px: number) => void} */
function drawTool(c, px) {
  if (count === 0) return;
  const i = Math.max(0, shownMove()), tool = toolOf(i), p = pointAt(i, shownFraction());
  const radius = tool ? tool.d / 2 : 3 * px, cuts = p.z < job.top && moves.kind[i] !== 0;
  c.beginPath();
  c.arc(p.x, p.y, radius, 0, 2 * Math.PI);
  c.fillStyle = cuts ? 'rgba(232,118,12,0.28)' : 'rgba(120,130,140,0.18)';
  c.fill();
  c.lineWidth = 2 * px;
  c.strokeStyle = cuts ? css('entry') : css('rapid');
  c.stroke();
  c.beginPath();
  c.moveTo(p.x - 5 * px, p.y);
  c.lineTo(p.x + 5 * px, p.y);
  c.moveTo(p.x, p.y - 5 * px);
  c.lineTo(p.x, p.y + 5 * px);
  c.stroke();
}

/** @type {(c: Context2D, px: number, place: Point) => void} */
function drawMark(c, px, place) {
  /** @type {[string, number][]} */
  const rings = [['#fff', 6], [css('bad'), 3]];
  for (const [color, w] of rings) {
    c.beginPath();
    c.arc(place.x, place.y, 12 * px, 0, 2 * Math.PI);
    c.lineWidth = w * px;
    c.strokeStyle = color;
    c.stroke();
  }
}

/** @type {(c: Context2D, px: number) => void} */
function drawMeasure(c, px) {
  if (!measure.from) return;
  c.strokeStyle = c.fillStyle = css('ink');
  c.lineWidth = 1.5 * px;
  const ends_ = [measure.from, measure.to].filter(p => p !== null).map(p => space.on ? projected(p) : p);
  c.beginPath();
  ends_.forEach((p, k) => k === 0 ? c.moveTo(p.x, p.y) : c.lineTo(p.x, p.y));
  c.stroke();
  for (const p of ends_) {
    c.beginPath();
    c.arc(p.x, p.y, 3 * px, 0, 2 * Math.PI);
    c.fill();
  }
}
