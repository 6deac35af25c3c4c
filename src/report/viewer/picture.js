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
