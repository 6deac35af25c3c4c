// ---- Which moves are shown and in which colours. A colouring puts every move in one of a few classes.
const CLASSES = 10, NO_VALUE = 255;
const dark = matchMedia('(prefers-color-scheme: dark)');
const filters = { rapids: true, operation: -1, layer: -1 };

/** Heights that are cut, descending, and for each move the index of the one it belongs to: entries to the cut after them. */
const layerHeights = [], layerOf = new Int16Array(count).fill(-1);
function findLayers() {
  const milli = i => Math.round(1000 * moves.z1[i]), heights = new Set();
  const cuts = i => moves.kind[i] === 4 && moves.z0[i] === moves.z1[i];
  for (let i = 0; i < count; ++i) if (cuts(i)) heights.add(milli(i));
  layerHeights.push(...[...heights].sort((a, b) => b - a).slice(0, 1000));
  const index = new Map(layerHeights.map((z, k) => [z, k]));
  for (let i = count - 1, layer = -1; i >= 0; --i) {
    if (cuts(i)) layer = index.get(milli(i)) ?? -1;
    layerOf[i] = layer;
  }
}
findLayers();

function shown(i) {
  return (filters.rapids || moves.kind[i] !== 0) && (filters.layer < 0 || layerOf[i] === filters.layer) &&
    (filters.operation < 0 || moves.section[i] === filters.operation);
}

/** From violet to orange; the lightness keeps it legible on the page. */
function rampColor(k, n) {
  const f = n > 1 ? k / (n - 1) : 1;
  return 'hsl(' + Math.round((250 + 135 * f) % 360) + ' 85% ' + Math.round(dark.matches ? 74 - 8 * f : 38 + 10 * f) + '%)';
}
const TOOL_HUES = [212, 28, 150, 320, 55, 265, 185, 0];
const toolColor = k => 'hsl(' + TOOL_HUES[k % TOOL_HUES.length] + ' 80% ' + (dark.matches ? 66 : 36) + '%)';

function byKind() {
  const group = [0, 1, 1, 2, 2, 2, 3, 3];
  return { of: i => group[moves.kind[i]], colors: ['rapid', 'entry', 'cut', 'link'].map(css), words: ['rapid', 'entry', 'cut', 'link'] };
}

/** Equal steps between the smallest and the largest value; moves without one have the colour of rapids. */
function byValue(value, from, to, words) {
  const step = (to - from) / CLASSES || 1, colors = [];
  for (let k = 0; k < CLASSES; ++k) colors.push(rampColor(k, CLASSES));
  return { of: i => value(i) === null ? NO_VALUE : Math.max(0, Math.min(CLASSES - 1, Math.floor((value(i) - from) / step))), colors, from: words(from), to: words(to) };
}

function byFeed() {
  const feeds = job.feeds.map(row => row[1]).filter(feed => feed > 0);
  return byValue(i => moves.feed[i] > 0 ? moves.feed[i] : null, Math.min(...feeds), Math.max(...feeds), feedText);
}
function byLayer() {
  const z = layerHeights.map(milli => milli / 1000);
  return byValue(i => layerOf[i] < 0 || moves.kind[i] === 0 ? null : -z[layerOf[i]], -z[0], -z[z.length - 1], v => 'z ' + lengthText(-v, 2));
}
function byTool() {
  return { of: i => Math.min(254, Math.max(0, job.sections[moves.section[i]].tool)), colors: job.tools.map((tool, k) => toolColor(k)), words: job.tools.map(tool => tool.w) };
}
const byEngagement = () => byValue(i => moves.kind[i] === 0 ? null : engagements[i], 0, 180, v => v + '\u00b0');

const byForce = () => byValue(i => moves.kind[i] === 0 ? null : forces[i], 0, mostForce, forceText);

const COLORINGS = { kind: byKind };
if (job.feeds.some(row => row[1] > 0)) COLORINGS.feed = byFeed;
if (engagements) COLORINGS.engagement = byEngagement;
if (forces && mostForce > 0) COLORINGS.force = byForce;
if (layerHeights.length > 1) COLORINGS.layer = byLayer;
if (job.tools.length > 1) COLORINGS.tool = byTool;

const classOf = new Uint8Array(count);
let classColors = [], noColor = '', pictureVersion = 0;

/** Colours every move anew and writes the legend: after a choice, or when the system turns dark. */
function colorMoves() {
  const coloring = COLORINGS[by('color-by').value]();
  for (let i = 0; i < count; ++i) classOf[i] = coloring.of(i);
  classColors = coloring.colors;
  noColor = css('rapid');
  ++pictureVersion;
  by('legend').replaceChildren();
  if (coloring.words) {
    const used = new Set(classOf);
    coloring.words.forEach((words, k) => {
      if (!used.has(k)) return;
      const entry = element('span', undefined, by('legend'));
      element('i', undefined, entry).style.background = classColors[k];
      entry.append(words);
    });
    return;
  }
  const ramp = element('span', coloring.from, by('legend'), 'ramp'), band = element('span', undefined, ramp);
  for (const color of classColors) element('i', undefined, band).style.background = color;
  ramp.append(coloring.to);
}
const colorOf = i => classOf[i] === NO_VALUE ? noColor : classColors[classOf[i]];
