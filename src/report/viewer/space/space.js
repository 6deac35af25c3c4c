// ---- The view in space: when it can be had, what it draws, and in which detail.
/** @type {{ axis: string, at: number }} */
const section = {
  axis: 'none',
  at: 0
};
const stageCanvas = by('space'), viewButtons = [...by('views').querySelectorAll('button')].filter(button => button.dataset.view);
// Detail: cells of a step of the surface, samples of a pixel, and pixels for each of the stage's. While something moves, as much as
// the machine can draw in time; at rest always the first.
/** @type {Detail[]} */
const DETAILS = [
  {step: 1, samples: 4, share: 1}, {step: 1, samples: 0, share: 1}, {step: 2, samples: 0, share: 1}, {step: 4, samples: 0, share: 1},
  {step: 4, samples: 0, share: 0.5}
];
/** `interval`: ms between frames, about; `frames` since the detail changed. @type {{ now: number, restAt: number, lastFrame: number, interval: number, frames: number, costs: { ms: number, when: number }[], settled: boolean }} */
const detail = {
  now: 1,
  restAt: 0,
  lastFrame: 0,
  interval: 18,
  frames: 0,
  costs: [],
  settled: true
};
/** @type {Record<number, FrameBuffer>} */
let buffers = {};  // by samples and size

/** The half of the section that is taken away has a scalar product above the last number. @type {() => [number, number, number, number]} */
function sectionPlane() {
  if (section.axis === 'x') return [1, 0, 0, section.at];
  if (section.axis === 'y') return [0, -1, 0, -section.at];
  return [0, 0, 0, 1];
}
/** @type {(p: Point) => boolean} */
function isCutOff(p) {
  const plane = sectionPlane();
  return plane[0] * p.x + plane[1] * p.y > plane[3];
}

/** @type {() => boolean} */
function startSpace() {
  try {
    const context = stageCanvas.getContext('webgl2', {alpha: true, antialias: false, depth: true, powerPreference: 'high-performance'});
    if (!context) return noSpace('this browser or this machine has no WebGL 2');
    gl = context;
    if (gl.getParameter(gl.MAX_TEXTURE_SIZE) < Math.max(width, height))
      return noSpace('the graphics processor takes no picture of this size');
    makeSurface();
    makeLines();
    makeCutters();
    makeClamps();
    buffers = {};
    space.supported = true;
  } catch (error) { return noSpace(error instanceof Error ? error.message : String(error)); }
  return true;
}

/** @type {(why: string) => boolean} */
function noSpace(why) {
  space.supported = false;
  space.why = why;
  by('space-note').textContent = 'No view in space: ' + why + '. The part is shown from above.';
  by('space-note').hidden = false;
  for (const button of viewButtons)
    if (button.dataset.view !== 'above') button.disabled = true;
  return false;
}

/** 'above': the flat picture; or one of the standpoints in space. @type {(name: string) => void} */
function chooseView(name) {
  const on = name !== 'above' && (space.supported ?? startSpace());
  space.on = on;
  stageCanvas.hidden = !on;
  by('section-box').hidden = !on;
  by('section-slider').hidden = !on || section.axis === 'none';
  by('path-note').hidden = true;
  measureStage();
  if (on) standAt(name);
  markStandpoint();
  if (measure.on) setMeasuring(true);
  overlay.setAttribute('aria-label',
    on ?
      'the part in space, the path and the cutter; dragging or Shift with arrows turns, Shift with dragging moves, wheel or plus and minus zoom, a click on the path shows its line' :
      'the part from above, the path and the cutter; wheel or plus and minus zoom, dragging moves, a click on the path shows its line');
  soilAll();
  redrawSoon();
}

function markStandpoint() {
  for (const button of viewButtons) {
    const stand = STANDPOINTS[button.dataset.view ?? ''];
    const here = space.on ? stand && camera.yaw === stand[0] && camera.pitch === stand[1] : button.dataset.view === 'above';
    button.setAttribute('aria-pressed', String(Boolean(here)));
  }
}

/** A frame buffer to be copied to the stage; those of another size are given back. @type {(w: number, h: number, samples: number) => WebGLFramebuffer} */
function bufferFor(w, h, samples) {
  const key = [w, h, samples].join();
  if (buffers[samples]?.key === key) return buffers[samples].frame;
  if (buffers[samples]) {
    gl.deleteFramebuffer(buffers[samples].frame);
    buffers[samples].parts.forEach(part => gl.deleteRenderbuffer(part));
  }
  /** @type {FrameBuffer} */
  const made = {key, frame: gl.createFramebuffer(), parts: []};
  buffers[samples] = made;
  gl.bindFramebuffer(gl.FRAMEBUFFER, made.frame);
  for (const [format, place] of [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
    const part = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, part);
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, Math.min(samples, gl.getParameter(gl.MAX_SAMPLES)), format, w, h);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, part);
    made.parts.push(part);
  }
  return made.frame;
}

/** What stands on the stage; before the operation without its path and its cutter. @type {(one: Detail, isBefore: boolean) => void} */
function drawAll(one, isBefore) {
  const rough = one.step > 1;
  gl.disable(gl.BLEND);
  drawSurface(one.step, isBefore);
  gl.enable(gl.BLEND);
  gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  const values = valuesOfSurface(surface);
  drawClamps(values);
  gl.depthMask(false);
  drawPart(values, rough);
  if (!isBefore) drawPathInSpace(values, rough);
  gl.depthMask(true);
  if (!isBefore && !isFinishedShown()) drawCutter(values);
}

/** @type {(one: Detail) => void} */
function drawScene(one) {
  const w = Math.round(stageCanvas.width * one.share), h = Math.round(stageCanvas.height * one.share),
        direct = one.samples === 0 && one.share === 1;
  const frame = direct ? null : bufferFor(w, h, one.samples);
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.viewport(0, 0, w, h);
  gl.clearColor(0, 0, 0, 0);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  drawSides(w, h, isBefore => drawAll(one, isBefore));
  if (direct) return;
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, frame);
  gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
  gl.blitFramebuffer(
    0, 0, w, h, 0, 0, stageCanvas.width, stageCanvas.height, gl.COLOR_BUFFER_BIT, one.share === 1 ? gl.NEAREST : gl.LINEAR);
}

const SLOW = 30, QUICK = 18, SETTLED = 8,
      FORGOTTEN = 5000;  // ms a frame; frames before a detail is judged; ms after which it may be judged anew
/** What a frame of a detail took lately, ms; undefined: not known, or too long ago. @type {(k: number, now: number) => number | undefined} */
const costOf = (k, now) => now - (detail.costs[k]?.when ?? -Infinity) < FORGOTTEN ? detail.costs[k].ms : undefined;

/** Less detail where frames take long and less is quicker, more where they are quick. @type {(since: number, now: number) => void} */
function adaptDetail(since, now) {
  if (since > 1000) return;
  const before = detail.now;
  detail.interval += 0.2 * (Math.min(since, 100) - detail.interval);
  if (++detail.frames < SETTLED) return;
  detail.costs[before] = {ms: detail.interval, when: now};
  const finer = costOf(before - 1, now), coarser = costOf(before + 1, now);
  if (detail.interval > SLOW && finer !== undefined && finer < 1.1 * detail.interval) --detail.now;
  else if (detail.interval > SLOW && before < DETAILS.length - 1 && (coarser ?? 0) < 0.9 * detail.interval) ++detail.now;
  else if (detail.interval < QUICK && before > 0 && finer === undefined) --detail.now;
  if (detail.now !== before) {
    detail.frames = 0;
    detail.interval = QUICK;
  }
}

/** Draws at once in the detail that is fast enough, and soon after the last change in full. */
function drawSpace(now = performance.now()) {
  measureStage();
  if (stageCanvas.width !== overlay.width || stageCanvas.height !== overlay.height) {
    stageCanvas.width = overlay.width;
    stageCanvas.height = overlay.height;
  }
  adaptDetail(now - detail.lastFrame, now);
  detail.lastFrame = now;
  drawScene(DETAILS[detail.now]);
  detail.settled = detail.now === 0;
}

/** What was left out while something moved is drawn soon after the last change: full detail in space, finer cells where one has zoomed in. */
function restSoon() {
  clearTimeout(detail.restAt);
  if (lensIsDue()) detail.settled = false;
  if (!detail.settled) detail.restAt = setTimeout(drawAtRest, REST);
}

function drawAtRest() {
  if (playing) return;
  refine();
  if (space.on) drawScene(DETAILS[0]);
  else drawOverlay();
  detail.settled = true;
}

/** Marks over the picture: the move under way, faults, what is measured, the axes. */
function drawSpaceOverlay() {
  measureStage();
  const c = contextOf(overlay);
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.clearRect(0, 0, overlay.width, overlay.height);
  c.scale(view.ratio, view.ratio);
  const i = shownMove();
  if (i >= 0 && !change.grid && by('path').value !== 'none') drawMoveInSpace(c, i);
  if (at.time >= total && !job.clean)
    for (const place of faultPlaces) drawMark(c, 1, projected(place));
  if (marked) drawMark(c, 1, projected(marked));
  drawMeasure(c, 1);
  drawAxes(c);
  drawCurtain(c);
}

/** @type {(c: Context2D, i: number) => void} */
function drawMoveInSpace(c, i) {
  const done = shownFraction(), chords = chordsOf(i);
  c.beginPath();
  for (let k = 0; k <= chords; ++k) {
    const s = projected(pointAt(i, done * k / chords));
    if (k === 0) c.moveTo(s.x, s.y);
    else c.lineTo(s.x, s.y);
  }
  c.lineWidth = 3;
  c.lineCap = 'round';
  c.strokeStyle = by('path').value === 'all' ? css('ink') : colorOf(i);
  c.stroke();
}

/** @type {(c: Context2D) => void} */
function drawAxes(c) {
  const axes = cameraAxes(), x = view.w - 38, y = view.h - 88;
  c.font = '12px system-ui, sans-serif';
  c.lineWidth = 1.5;
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  c.strokeStyle = c.fillStyle = css('ink');
  ['x', 'y', 'z'].forEach((name, k) => {
    const dx = axes.right[k], dy = -axes.up[k];
    if (Math.hypot(dx, dy) < 0.05) return;
    c.beginPath();
    c.moveTo(x, y);
    c.lineTo(x + 20 * dx, y + 20 * dy);
    c.stroke();
    c.fillText(name, x + 29 * dx, y + 29 * dy);
  });
  c.textAlign = 'start';
  c.textBaseline = 'alphabetic';
}

/** @type {Record<string, () => [number, number]>} */
const SECTION_RANGE = {
  x: () => [sx0, sx1],
  y: () => [sy0, sy1],
  z: () => [bottomZ, job.top]
};
/** Reads the choice of a section and where its slider stands. @type {(moved: boolean) => void} */
function chooseSection(moved) {
  section.axis = by('section').value;
  const slider = by('section-at'), range = SECTION_RANGE[section.axis];
  by('section-slider').hidden = !range;
  if (range) {
    const [from, to] = range();
    if (!moved) slider.value = '500';
    section.at = from + (to - from) * Number(slider.value) / 1000;
    by('section-place').value = section.axis + ' ' + lengthText(section.at, 2);
    slider.setAttribute('aria-valuetext', by('section-place').value);
  }
  redrawSoon();
}

function listenToSpace() {
  for (const button of viewButtons) button.onclick = () => chooseView(button.dataset.view ?? 'above');
  by('section').onchange = () => chooseSection(false);
  by('section-at').oninput = () => chooseSection(true);
  stageCanvas.addEventListener('webglcontextlost', event => {
    event.preventDefault();
    space.supported = null;
  });
  stageCanvas.addEventListener('webglcontextrestored', () => {
    if (startSpace()) redrawSoon();
    else chooseView('above');
  });
  overlay.oncontextmenu = event => {
    if (space.on) event.preventDefault();
  };
}
