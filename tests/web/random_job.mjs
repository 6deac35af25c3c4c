// A random part and how it is planned, the same for the same seed.

/** Numbers from 0 to below 1 (Mulberry32). @type {(seed: number) => () => number} */
function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t = (t + Math.imul(t ^ (t >>> 7), t | 61)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** @type {(value: number) => number} */
const rounded = value => Math.round(value * 1000) / 1000;

/**
 * A loop around (x, y), star-shaped, some of its sides arcs.
 * @type {(random: () => number, x: number, y: number, least: number, most: number, corners: number) => Corner[]}
 */
function star(random, x, y, least, most, corners) {
  /** @type {Corner[]} */
  const points = [];
  for (let i = 0; i < corners; ++i) {
    const angle = 2 * Math.PI * (i + 0.6 * random()) / corners, radius = least + (most - least) * random();
    points.push(
      [rounded(x + radius * Math.cos(angle)), rounded(y + radius * Math.sin(angle)), random() < 0.3 ? rounded(0.5 * (random() - 0.5)) : 0]);
  }
  return points;
}

/** A box with sides in whole millimetres: equal lengths, equal distances. @type {(random: () => number) => Corner[]} */
function box(random) {
  const width = 20 + Math.floor(60 * random()), height = 20 + Math.floor(60 * random());
  return [[0, 0, 0], [width, 0, 0], [width, height, 0], [0, height, 0]];
}

/** @typedef {[number, number, number]} Corner x and y in mm, and the bulge of the edge that leaves it. */
/** @typedef {{ name: string, words: string[], files: [string, Uint8Array][], seed?: number }} WebJob A part's files, and the words after `plan`. */

/** @type {(seed: number) => WebJob} */
export function randomJob(seed) {
  const random = randomNumbers(seed);
  /** @type {<Kind>(list: Kind[]) => Kind} */
  const among = list => list[Math.floor(random() * list.length)];
  const isBox = random() < 0.25, size = 20 + 30 * random();
  const outer = isBox ? box(random) : star(random, size, size, 0.5 * size, size, 4 + Math.floor(9 * random()));
  const islands = [];
  if (!isBox && random() < 0.5) islands.push(star(random, size, size, 0.1 * size, 0.25 * size, 3 + Math.floor(4 * random())));
  const part = {name: `random ${seed}`, units: 'mm', outer, islands, top: 0, depth: 1 + Math.floor(6 * random())};
  const words = [
    'part.json', `--tool=endmill:${among([2, 3, 4, 6, 8])}`, `--strategy=${among(['auto', 'contour', 'adaptive', 'zigzag', 'spiral'])}`,
    `--post=${among(['linuxcnc', 'grbl', 'heidenhain', 'haas'])}`, '--accept=out-of-reach'
  ];
  if (random() < 0.3) words.push(`--entry=${among(['helix', 'ramp', 'plunge'])}`);
  return {
    name: `random part ${seed}: ${words.slice(1).join(' ')}`,
    seed,
    words,
    files: [['part.json', new TextEncoder().encode(JSON.stringify(part))]]
  };
}
