// ---- Which moves are shown and in which colours. A colouring puts every move in one of a few classes.
const CLASSES = 10, NO_VALUE = 255;
const dark = matchMedia('(prefers-color-scheme: dark)');
const filters = {
  rapids: true,
  operation: -1,
  layer: -1
};

/** Heights that are cut, descending, and for each move the index of the one it belongs to: entries to the cut after them. @type {number[]} */
const layerHeights = [], layerOf = new Int16Array(count).fill(-1);
/** @type {() => void} */
function findLayers() {
  const milli = (/** @type {number} */ i) => Math.round(1000 * moves.z1[i]), heights = new Set();
  const cuts = (/** @type {number} */ i) => moves.kind[i] === 4 && moves.z0[i] === moves.z1[i];
  for (let i = 0; i < count; ++i)
    if (cuts(i)) heights.add(milli(i));
  layerHeights.push(...[...heights].sort((a, b) => b - a).slice(0, 1000));
  const index = new Map(layerHeights.map((z, k) => [z, k]));
  for (let i = count - 1, layer = -1; i >= 0; --i) {
    if (cuts(i)) layer = index.get(milli(i)) ?? -1;
    layerOf[i] = layer;
  }
}
findLayers();

/** What is said of an operation: its label, and its cutter where others are called the same. @type {(s: number) => string} */
function operationName(s) {
  const {label, tool} = job.sections[s], isAlone = job.sections.filter(other => other.label === label).length === 1;
  const words = label || 'operation ' + (s + 1);
  return isAlone || tool < 0 ? words : words + ', ' + job.tools[tool].w;
}

/** @type {(i: number) => boolean} */
function shown(i) {
  return (filters.rapids || moves.kind[i] !== 0) && (filters.layer < 0 || layerOf[i] === filters.layer) &&
    (filters.operation < 0 || moves.section[i] === filters.operation);
}

/** From violet to orange; the lightness keeps it legible on the page. @type {(k: number, n: number) => string} */
function rampColor(k, n) {
  const f = n > 1 ? k / (n - 1) : 1;
  return 'hsl(' + Math.round((250 + 135 * f) % 360) + ' 85% ' + Math.round(dark.matches ? 74 - 8 * f : 38 + 10 * f) + '%)';
}
const TOOL_HUES = [212, 28, 150, 320, 55, 265, 185, 0];
/** @type {(k: number) => string} */
const toolColor = k => 'hsl(' + TOOL_HUES[k % TOOL_HUES.length] + ' 80% ' + (dark.matches ? 66 : 36) + '%)';

/** @type {() => Coloring} */
function byKind() {
  const group = [0, 1, 1, 2, 2, 2, 3, 3];
  return {of: i => group[moves.kind[i]], colors: ['rapid', 'entry', 'cut', 'link'].map(css), words: ['rapid', 'entry', 'cut', 'link']};
}

/**
 * Equal steps between the smallest and the largest value; moves without one have the colour of rapids.
 * @type {(value: (i: number) => number | null, from: number, to: number, words: (v: number) => string) => Coloring}
 */
function byValue(value, from, to, words) {
  const step = (to - from) / CLASSES || 1, colors = [];
  for (let k = 0; k < CLASSES; ++k) colors.push(rampColor(k, CLASSES));
  const classAt = (/** @type {number | null} */ v) =>
    v === null ? NO_VALUE : Math.max(0, Math.min(CLASSES - 1, Math.floor((v - from) / step)));
  return {of: i => classAt(value(i)), colors, from: words(from), to: words(to)};
}

/** @type {() => Coloring} */
function byFeed() {
  const feeds = job.feeds.map(row => row[1]).filter(feed => feed > 0);
  return byValue(i => moves.feed[i] > 0 ? moves.feed[i] : null, Math.min(...feeds), Math.max(...feeds), feedText);
}
/** @type {() => Coloring} */
function byLayer() {
  const z = layerHeights.map(milli => milli / 1000);
  return byValue(
    i => layerOf[i] < 0 || moves.kind[i] === 0 ? null : -z[layerOf[i]], -z[0], -z[z.length - 1], v => 'z ' + lengthText(-v, 2));
}
/** @type {() => Coloring} */
function byTool() {
  return {
    of: i => Math.min(254, Math.max(0, job.sections[moves.section[i]].tool)),
    colors: job.tools.map((tool, k) => toolColor(k)),
    words: job.tools.map(tool => tool.w)
  };
}
/** @type {(degrees: number[]) => Coloring} */
const byEngagement = degrees => byValue(i => moves.kind[i] === 0 ? null : degrees[i], 0, 180, v => v + '\u00b0');

/** @type {(newtons: number[]) => Coloring} */
const byForce = newtons => byValue(i => moves.kind[i] === 0 ? null : newtons[i], 0, mostForce, forceText);

/** @type {Record<string, () => Coloring>} */
const COLORINGS = {
  kind: byKind
};
if (job.feeds.some(row => row[1] > 0)) COLORINGS.feed = byFeed;
if (engagements) COLORINGS.engagement = () => byEngagement(engagements);
if (forces && mostForce > 0) COLORINGS.force = () => byForce(forces);
if (layerHeights.length > 1) COLORINGS.layer = byLayer;
if (job.tools.length > 1) COLORINGS.tool = byTool;

const classOf = new Uint8Array(count);
/** @type {string[]} */
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
  ramp.append(coloring.to ?? '');
}
/** @type {(i: number) => string} */
const colorOf = i => classOf[i] === NO_VALUE ? noColor : classColors[classOf[i]];
