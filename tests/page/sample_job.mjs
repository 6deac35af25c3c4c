// A small job as the report's page has it: a plate of 40 x 20 mm, 5 mm thick, two cutters.

/** x, y, z in mm, s, mm/min, kind, line; or [x, y, z, s, mm/min, kind, line, x and y of an arc's centre, 1 counter-clockwise or -1]. */
const path = [
  [5, 5, 5, 1, 0, 0, 3],
  [5, 5, -1, 1, 100, 1, 4],
  [35, 5, -1, 3, 600, 4, 5],
  [35, 15, -1, 3, 600, 4, 6, 35, 10, 1],
  [5, 15, -1, 3, 600, 4, 7],
  [5, 15, 5, 1, 0, 0, 8],
  [20, 10, 5, 1, 0, 0, 9],
  [20, 10, -2.5, 1, 100, 1, 10],
  [20, 10, 5, 1, 0, 0, 11],
];

/** What path says as columns of differences. @type {() => Pick<Job, 'kinds' | 'x' | 'y' | 'z' | 't' | 'line' | 'starts' | 'arcs' | 'feeds'>} */
function columns() {
  /** @type {ReturnType<typeof columns>} */
  const out = {kinds: '', x: [], y: [], z: [], t: [], line: [], starts: [[0, 0, 0, 5000]], arcs: [], feeds: []};
  let [x, y, z, feed, line] = [0, 0, 5, -1, 0];
  path.forEach(([x1, y1, z1, seconds, f, kind, n, cx, cy, turn], i) => {
    if (turn) out.arcs.push([i, 1000 * (cx - x), 1000 * (cy - y), turn]);
    if (f !== feed) out.feeds.push([i, f]);
    out.kinds += kind;
    out.x.push(1000 * (x1 - x));
    out.y.push(1000 * (y1 - y));
    out.z.push(1000 * (z1 - z));
    out.t.push(10000 * seconds);
    out.line.push(n - line);
    [x, y, z, feed, line] = [x1, y1, z1, f, n];
  });
  return out;
}

/** @type {(n: number, d: number) => JobTool} */
const endmill = (n, d) => ({n, d, r: 0, f: 20, a: null, t: 0, k: d, s: null, h: 0, w: `end mill ${d}`});

/** @type {() => Job} */
export const sampleJob = () => ({
  name: 'plate',
  clean: true,
  verdict: 'CLEAN',
  asked: true,
  bad: '#c81e1e',
  top: 0,
  bottom: -2.5,
  shades: Array(256).fill('#808080'),
  stock: [0, 0, 40, 20],
  stock_z: -5,
  world: [0, 0, 40, 20],
  keep_outs: [],
  tools: [endmill(1, 6), endmill(2, 2)],
  features: [{name: 'slot', floor: -1, top: 0, path: 'M0 0L40 0L40 20L0 20Z', time: 10, left: 0, gouge: 0, clean: true}],
  faults: [],
  conditions: [],
  figures: {
    time_s: 15,
    feed_mm: 88,
    rapid_mm: 30,
    retracts: 2,
    percent_above_bound: null,
    uncut_thickness_mm: 0,
    gouge_mm: 0,
    rapid_in_material: 0,
    max_deg: 180
  },
  ...columns(),
  sections: [{label: 'slot', feature: 0, tool: 0, first: 0}, {label: 'hole', feature: -1, tool: 1, first: 6}],
  engagement: [0, 90, 180, 180, 180, 0, 0, 90, 0],
  force: null,
  earlier: null,
  program: [
    '%', 'G21', 'G0 X5 Y5', 'G1 Z-1 F100', 'G1 X35 F600', 'G3 X35 Y15 J5', 'G1 X5', 'G0 Z5', 'G0 X20 Y10', 'G1 Z-2.5 F100', 'G0 Z5', 'M30'
  ],
});
