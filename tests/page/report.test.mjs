// What the report's page computes: units, time, moves, colours, which move lies where and in which line, and the heights that cutting leaves.
import assert from 'node:assert/strict';
import {describe, test} from 'node:test';
import {runReport} from './fake_page.mjs';
import {sampleJob} from './sample_job.mjs';

/** @type {(value: unknown, wanted: number, within?: number) => void} */
function isNear(value, wanted, within = 1e-9) {
  assert.ok(typeof value === 'number' && Math.abs(value - wanted) <= within, `${value} is not ${wanted} ± ${within}`);
}

describe('figures as text', () => {
  const ask = runReport('units.js', sampleJob());
  test('times are minutes and seconds, hours where there are any', () => {
    assert.deepEqual(ask('[0, 59.4, 59.6, 3599.6, 36000].map(clock)'), ['0:00', '0:59', '1:00', '1:00:00', '10:00:00']);
  });
  test('what is no number is a question mark', () => {
    assert.deepEqual(
      ask('[clock(null), clock(Infinity), fixed(null, 2), bare(null, 2), lengthText(null, 1)]'), ['?', '?', '?', '?', '?\u00a0mm']);
  });
  test('lengths and feeds in mm and in inches, which take one decimal more', () => {
    assert.deepEqual(ask('[lengthText(25.4, 2), feedText(254), feedText(0)]'), ['25.40\u00a0mm', '254\u00a0mm/min', 'rapid']);
    assert.deepEqual(
      ask('(unit = UNITS.inch, [lengthText(25.4, 2), feedText(254), feedText(0)])'), ['1.000\u00a0in', '10.0\u00a0in/min', 'rapid']);
    assert.equal(ask(`sentence('A stock of 101.6 x 50.8 mm keeps 645.16 mm2, 2.54 mm wide, at x -25.4 y 0 z -3.175, line 6')`),
      'A stock of 4 x 2 in keeps 1 in2, 0.1 in wide, at x -1 y 0 z -0.125, line 6');
    assert.equal(ask(`(unit = UNITS.mm, sentence('2.54 mm wide'))`), '2.54 mm wide');
  });
});

describe('moves', () => {
  const ask = runReport('moves.js', sampleJob());
  test('differences become places, times, feeds, lines', () => {
    assert.equal(ask('count'), 9);
    assert.equal(ask('total'), 15);
    assert.deepEqual(ask('[moves.x1[2], moves.y1[3], moves.z1[7], moves.t[3], moves.feed[3], moves.line[7], moves.section[7]]'),
      [35, 15, -2.5, 5, 600, 10, 1]);
  });
  test('a move that begins elsewhere begins there', () => {
    const job = sampleJob();
    job.starts.push([6, 1000, 2000, 3000]);
    assert.deepEqual(runReport('moves.js', job)('[moves.x0[6], moves.y0[6], moves.z0[6], moves.x1[5]]'), [1, 2, 3, 5]);
  });
  test('half an arc counter-clockwise bulges to the right', () => {
    isNear(ask('pointAt(3, 0.5).x'), 40);
    isNear(ask('pointAt(3, 0.5).y'), 10);
    isNear(ask('arcOf(3).sweep'), Math.PI);
  });
  test('clockwise it bulges to the left; a whole turn is no empty one', () => {
    const job = sampleJob();
    job.arcs[0][3] = -1;
    isNear(runReport('moves.js', job)('pointAt(3, 0.5).x'), 30);
    job.x[3] = 0;
    job.y[3] = 0;
    isNear(runReport('moves.js', job)('arcOf(3).sweep'), -2 * Math.PI);
  });
  test('a line of the program finds its first move and a line without one finds none', () => {
    assert.deepEqual(ask('[1, 2, 3, 6, 12].map(line => moveOfLine[line])'), [-1, -1, 0, 3, -1]);
  });
});

describe('colours', () => {
  const ask = runReport('colors.js', sampleJob());
  test('heights that are cut are layers, entries belong to the cut after them', () => {
    assert.deepEqual(ask('layerHeights'), [-1000]);
    assert.deepEqual(ask('[...layerOf]'), [0, 0, 0, 0, 0, -1, -1, -1, -1]);
  });
  test('kinds are four colours', () => {
    assert.deepEqual(ask('(c => [0, 1, 2].map(c.of))(byKind())'), [0, 1, 2]);
  });
  test('values fall into equal classes from the smallest to the largest, rapids into none', () => {
    assert.deepEqual(ask('(c => [0, 1, 2].map(c.of))(byFeed())'), [255, 0, 9]);
    assert.deepEqual(ask('(c => [0, 1, 2].map(c.of))(byEngagement(engagements))'), [255, 5, 9]);
  });
  test('each tool has a colour; colourings are those that the job can tell', () => {
    assert.deepEqual(ask('[2, 7].map(byTool().of)'), [0, 1]);
    assert.deepEqual(ask('Object.keys(COLORINGS)'), ['kind', 'feed', 'engagement', 'tool']);
  });
  test('filters hide rapids, other operations and other layers', () => {
    assert.deepEqual(ask('(filters.rapids = false, filters.operation = 1, [...moves.kind.keys()].filter(shown))'), [7]);
    assert.deepEqual(ask('(filters.operation = -1, filters.layer = 0, [...moves.kind.keys()].filter(shown))'), [1, 2, 3, 4]);
  });
});

describe('heights', () => {
  const at = '(x, y) => heights[Math.floor((wy1 - y) * scale) * width + Math.floor((x - wx0) * scale)]';
  test('a move lowers what the cutter passes, and nothing else', () => {
    const ask = runReport('time.js', sampleJob());
    ask('(fullStock(), goTo(total))');
    assert.deepEqual(ask(`[[20, 5], [20, 7.9], [20, 8.5], [37.5, 10], [20, 10], [20, 11.5], [1, 10]].map(([x, y]) => (${at})(x, y))`),
      [-1, -1, 0, -1, -2.5, 0, 0]);
  });
  test('in the middle of a move half of it is cut', () => {
    const ask = runReport('time.js', sampleJob());
    ask('(fullStock(), goTo(3.5))');
    assert.deepEqual(ask(`[[10, 5], [22.5, 5], [30, 5]].map(([x, y]) => (${at})(x, y))`), [-1, -1, 0]);
  });
  test('whichever way a moment was reached, the heights are the same to the bit', () => {
    const fresh = runReport('time.js', sampleJob()), used = runReport('time.js', sampleJob());
    const digest = '[heights.reduce((sum, h, k) => (sum * 31 + Math.round(h * 1e6) * (k % 97 + 1)) % 2147483647, 7), at.move, at.fraction]';
    used('(fullStock(), [14, 1, 9.3, 4.2, 12.5, 6.7].forEach(goTo))');
    fresh('(fullStock(), goTo(6.7))');
    assert.deepEqual(used(digest), fresh(digest));
  });
  test('the grid of what is in sight holds the same to the bit, whichever way a moment was reached', () => {
    const digest =
      '[lens.on, lens.grid.width, lens.grid.scale > 10 * scale, lens.grid.heights.reduce((sum, h, k) => (sum * 31 + Math.round(h * 1e6) * (k % 97 + 1)) % 2147483647, 7)]';
    const [fresh, used] = [[6.7], [14, 1, 9.3, 4.2, 12.5, 6.7]].map(times => {
      const ask = runReport('lens.js', sampleJob());
      ask(`(Object.assign(view, { x: 20, y: 8, k: 900, w: 900, h: 600 }), fullStock(), ${
        JSON.stringify(times)}.forEach(t => { goTo(t); refine(); }))`);
      return ask(digest);
    });
    assert.deepEqual(used, fresh);
    assert.ok(Array.isArray(fresh) && fresh[0] && fresh[2] && fresh[3] !== 7);
  });
  test('beyond both ends of time it stops', () => {
    const ask = runReport('time.js', sampleJob());
    assert.deepEqual(ask('(fullStock(), goTo(-3), at.time)'), 0);
    assert.deepEqual(ask('(goTo(1e9), [at.time, at.move])'), [15, 9]);
  });
  test('a ball leaves a groove, a cone a slope', () => {
    const ask = runReport('relief.js', sampleJob());
    isNear(ask('endAt({ d: 6, r: 3, a: null, t: 0 }, 3)'), 3);
    isNear(ask('endAt({ d: 6, r: 3, a: null, t: 0 }, 0)'), 0);
    isNear(ask('endAt({ d: 6, r: 1, a: null, t: 0 }, 2.5)'), 1 - Math.sqrt(0.75));
    isNear(ask('endAt({ d: 6, r: 0, a: 0.5, t: 1 }, 1.5)'), 2);
  });
  test('what an earlier set-up cut from below is hollow, and cutting down to it opens it', () => {
    const job = sampleJob();
    job.earlier = {
      kinds: '4',
      x: [30000],
      y: [0],
      z: [0],
      t: [0],
      line: [0],
      starts: [[0, 5000, 5000, -5000]],
      arcs: [],
      feeds: [[0, 600]],
      sections: [{label: 'below', feature: -1, tool: 0, first: 0, below: -1}]
    };
    const ask = runReport('time.js', job);
    assert.deepEqual(ask(`(fullStock(), (${at})(20, 5))`), 0);
    assert.ok(Number(ask(`(goTo(total), (${at})(20, 5))`)) < -1e29);
  });
});

describe('the present move', () => {
  test('an operation without a name has that of its feature, as in programs of others', () => {
    const job = sampleJob();
    for (const section of job.sections) section.label = '';
    assert.deepEqual(runReport('panels.js', sampleJob())('job.sections.map(nameOfSection)'), ['slot', 'hole']);
    assert.deepEqual(runReport('panels.js', job)('job.sections.map(nameOfSection)'), ['slot', 'not named']);
  });
});

describe('before and after an operation', () => {
  test('operations that are called alike are told apart by their cutters', () => {
    const job = sampleJob();
    assert.deepEqual(runReport('colors.js', job)('[0, 1].map(operationName)'), ['slot', 'hole']);
    job.sections[1].label = 'slot';
    assert.deepEqual(runReport('colors.js', job)('[0, 1].map(operationName)'), ['slot, end mill 6', 'slot, end mill 2']);
    job.sections[1].label = '';
    assert.deepEqual(runReport('colors.js', job)('[0, 1].map(operationName)'), ['slot', 'operation 2']);
  });
  test('the heights before it stay while the program goes on', () => {
    const ask = runReport('view.js', sampleJob()), kept = runReport('beside/change.js', sampleJob());
    ask('(fullStock(), goTo(12))');
    kept('(fullStock(), goTo(12), change.grid = keptGrid(), goTo(total))');
    const digest = (/** @type {string} */ name) =>
      `${name}.reduce((sum, h, k) => (sum * 31 + Math.round(h * 1e6) * (k % 97 + 1)) % 2147483647, 7)`;
    assert.equal(kept(digest('change.grid.heights')), ask(digest('heights')));
    assert.notEqual(kept(digest('heights')), ask(digest('heights')));
  });
});

describe('messages of the page around', () => {
  const ask = runReport('beside/link.js', sampleJob());
  const look = {space: true, camera: [0, 0, 0, 4, 45, 35], flat: [0, 0, 4], section: 'none', sectionAt: 500};
  const isLook = (/** @type {object} */ other) => ask(`isLook(${JSON.stringify({...look, ...other})})`);
  test('a look is taken, anything else is not', () => {
    assert.equal(isLook({}), true);
    for (const wrong of [{camera: [0, 0, 0, 0, 45, 35]}, {camera: [1, 2]}, {camera: 'x'}, {flat: [0, 0, -1]}, {flat: [0, null, 1]},
           {section: 'constructor'}, {sectionAt: 'x'}])
      assert.equal(isLook(wrong), false, JSON.stringify(wrong));
    assert.equal(ask('[null, 3, "look"].some(isLook)'), false);
  });
});

describe('a click on the path', () => {
  test('the distance to a line, to an arc and beyond its ends', () => {
    const ask = runReport('view.js', sampleJob());
    isNear(ask('distanceToMove(2, { x: 20, y: 8 })'), 3);
    isNear(ask('distanceToMove(2, { x: 2, y: 1 })'), 5);
    isNear(ask('distanceToMove(3, { x: 41, y: 10 })'), 1);
    isNear(ask('distanceToMove(3, { x: 32, y: 10 })'), Math.hypot(3, 5));
  });
});

describe('the surface in space', () => {
  /** Pieces of a tile of 32 cells with a groove of three cells from side to side at a height of -1; what is cut through is at the bottom. */
  const ask = runReport('space/surface.js', sampleJob());
  ask(
    `(globalThis.tileOf = (width_, height_, heightOf) => ({ across: 1, grid: { width: width_, block: { x0: 0, y0: 0, x1: width_, y1: height_ },
    heights: Float32Array.from({ length: width_ * height_ }, (_, k) => heightOf(k % width_, Math.floor(k / width_))) } }), 0)`);
  /** @type {(heightOf: string, least: number) => [number, number, number, number, boolean][]} */
  const pieces = (heightOf, least) =>
    /** @type {[number, number, number, number, boolean][]} */ (ask(`piecesOf(tileOf(33, 33, ${heightOf}), 0, ${least})`));
  const area = (/** @type {[number, number, number, number, boolean][]} */ all) =>
    all.reduce((sum, [x0, y0, x1, y1]) => sum + (x1 - x0) * (y1 - y0), 0);
  test('what is level is one piece', () => {
    assert.deepEqual(pieces('() => -1', 1), [[0, 0, 32, 32, true]]);
  });
  test('what is cut through has no piece', () => {
    assert.deepEqual(pieces('() => -100', 1), []);
    assert.equal(area(pieces('(x, y) => x < 16 ? 0 : -100', 1)), 16 * 32);
  });
  test('level cells come together on both sides of a step; the cells of the step stand alone', () => {
    const all = pieces('(x, y) => y < 10 ? 0 : -1', 1);
    assert.deepEqual(all.filter(piece => piece[4]), [[0, 0, 32, 9, true], [0, 10, 32, 32, true]]);
    assert.equal(all.length, 2 + 32);
  });
  test('the pieces cover the tile, each cell once, in any detail', () => {
    for (const least of [1, 2, 4, 8]) {
      const all = pieces('(x, y) => Math.hypot(x - 16, y - 12) < 9 ? -2 : x + y > 50 ? -1 : 0', least), seen = new Set();
      for (const [x0, y0, x1, y1] of all)
        for (let y = y0; y < y1; ++y)
          for (let x = x0; x < x1; ++x) seen.add(33 * y + x);
      assert.equal(area(all), 32 * 32);
      assert.equal(seen.size, 32 * 32);
    }
  });
});
