// ---- Feed, engagement and force over time, on the same scale of time as the bar of features above.
const plotPicture = document.createElement('canvas');
let plotKey = '';
by('plot').classList.toggle('with-force', forces !== null);

/** The greatest value in each column of pixels. @type {(value: (i: number) => number, w: number) => Float64Array} */
function columnsOf(value, w) {
  const columns = new Float64Array(w);
  for (let i = 0; i < count; ++i) {
    const v = value(i), last = Math.min(w - 1, Math.floor(moves.t[i + 1] / total * w));
    for (let x = Math.min(w - 1, Math.floor(moves.t[i] / total * w)); x <= last; ++x) columns[x] = Math.max(columns[x], v);
  }
  return columns;
}

/** @type {(c: Context2D, strip: PlacedStrip) => void} */
function plotCurve(c, strip) {
  const columns = columnsOf(strip.value, strip.w);
  c.fillStyle = strip.color;
  c.globalAlpha = strip.alpha;
  for (let x = 0; x < strip.w; ++x) {
    const h = strip.most > 0 ? columns[x] / strip.most * strip.h : 0;
    c.fillRect(x, strip.y + strip.h - h, 1, h);
  }
  c.globalAlpha = 1;
  c.fillStyle = css('rule');
  c.fillRect(0, strip.y + strip.h, strip.w, 1);
}

/** @type {(c: Context2D, words: string, y: number) => void} */
function writePlotWords(c, words, y) {
  c.font = '12px system-ui, sans-serif';
  const w = c.measureText(words).width;
  c.globalAlpha = 0.85;
  c.fillStyle = css('page');
  c.fillRect(2, y, w + 8, 16);
  c.globalAlpha = 1;
  c.fillStyle = css('ink');
  c.fillText(words, 6, y + 12);
}

/** @type {(w: number, h: number, ratio: number) => void} */
function drawPlotPicture(w, h, ratio) {
  plotPicture.width = Math.round(w * ratio);
  plotPicture.height = Math.round(h * ratio);
  const c = contextOf(plotPicture), strips = plotStrips(), share = h / strips.length;
  c.scale(ratio, ratio);
  if (count === 0 || !(total > 0)) return;
  strips.forEach((strip, k) => plotCurve(c, {...strip, y: k * share + 1, h: share - 3, w}));
  plotFaults(c, w, h);
  strips.forEach((strip, k) => writePlotWords(c, strip.words, k * share + 2));
}

const SPARSE = 12, TICK = 6;  // pixels between lines through the whole plot, on average; pixels of a mark where they are more
/** Lines through the whole plot, or, where these would hide it, marks at its upper edge. @type {(c: Context2D, w: number, h: number) => void} */
function plotFaults(c, w, h) {
  c.fillStyle = css('bad');
  for (const time of faultTimes) c.fillRect(w * time / total - 1, 0, 2, w < SPARSE * faultTimes.length ? TICK : h);
}

/** What is known of every move, each with its greatest value. @type {() => PlotStrip[]} */
function plotStrips() {
  const mostFeed = job.feeds.reduce((most, row) => Math.max(most, row[1]), 0);
  /** @type {PlotStrip[]} */
  const strips = [{value: i => moves.feed[i], most: mostFeed, color: css('faint'), alpha: 0.6, words: 'feed, up to ' + feedText(mostFeed)}];
  if (engagements)
    strips.push({value: i => engagements[i], most: 180, color: css('accent'), alpha: 0.75, words: 'engagement, up to 180\u00b0'});
  if (forces)
    strips.push({value: i => forces[i], most: mostForce, color: css('entry'), alpha: 0.8, words: 'force, up to ' + forceText(mostForce)});
  return strips;
}

function drawPlot() {
  const canvas = by('plot'), w = Math.max(1, canvas.clientWidth), h = Math.max(1, canvas.clientHeight),
        ratio = window.devicePixelRatio || 1;
  const key = [w, h, ratio, dark.matches, unit.name].join();
  if (key !== plotKey) {
    plotKey = key;
    drawPlotPicture(w, h, ratio);
    canvas.width = plotPicture.width;
    canvas.height = plotPicture.height;
  }
  const c = contextOf(canvas);
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.clearRect(0, 0, canvas.width, canvas.height);
  c.drawImage(plotPicture, 0, 0);
  c.scale(ratio, ratio);
  c.fillStyle = css('ink');
  c.fillRect(w * at.time / (total || 1) - 1, 0, 2, h);
}

/** A press or a drag on an element as wide as the whole time goes to the moment. @type {(target: HTMLElement) => void} */
function seekBy(target) {
  const seek = (/** @type {PointerEvent} */ event) => {
    const box = target.getBoundingClientRect();
    show(total * Math.max(0, Math.min(1, (event.clientX - box.left) / box.width)));
  };
  target.onpointerdown = event => {
    target.setPointerCapture(event.pointerId);
    seek(event);
  };
  target.onpointermove = event => {
    if (event.buttons) seek(event);
  };
}
