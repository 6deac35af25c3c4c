// What the page of the server computes: words of options, the job file, what files and results are for, texts.
import assert from 'node:assert/strict';
import {describe, test} from 'node:test';
import {runScripts} from './fake_page.mjs';

const ask = runScripts('apps/serve/page', 'tour.js');

describe('options', () => {
  test('a word is quoted where a shell needs it', () => {
    assert.deepEqual(ask(`['part.dxf', 'my part.dxf', 'a"b'].map(quoted)`), ['part.dxf', '"my part.dxf"', '"ab"']);
  });
  test('words are taken apart as the server does', () => {
    assert.deepEqual(ask(`wordsOf('--tool endmill:6  --op "pocket:my layer" --name=\\'a b\\'')`),
      ['--tool', 'endmill:6', '--op', 'pocket:my layer', '--name=a b']);
    assert.deepEqual(ask(`optionsOf('loose --tool endmill:6 ball:3 --rest --depth=4')`),
      [['--tool', ['endmill:6', 'ball:3']], ['--rest', []], ['--depth', ['4']]]);
  });
});

/** As `clearcut generate options` lists them. @type {(name: string, table: string, key: string, more?: object) => object} */
const option = (name, table, key, more = {}) =>
  ({names: [name], value: 'TEXT', many: false, job: {table, key, opposite: false, number: false}, ...more});
const number = (/** @type {string} */ table, /** @type {string} */ key) => ({job: {table, key, opposite: false, number: true}});
const known = [
  option('--op', 'part', 'op', {many: true}), option('--stepdown', 'plan', 'stepdown', number('plan', 'stepdown')),
  option('--post', 'output', 'post'), option('--accept', 'plan', 'accept', {many: true}), option('--rest', 'plan', 'rest', {value: ''}),
  option('--tabs', 'plan', 'tabs', number('plan', 'tabs')), option('--tab-shape', 'plan', 'tab_shape'),
  option('--skin', 'plan', 'skin', number('plan', 'skin')), option('--order', 'plan', 'order'),
  option('--angle', 'plan', 'angle', number('plan', 'angle')),
  option('--program-number', 'output', 'program_number', number('output', 'program_number')),
  option('--block-numbers', 'output', 'block_numbers', {value: ''}),
  option('--no-arcs', 'output', 'arcs', {value: '', job: {table: 'output', key: 'arcs', opposite: true, number: false}}),
  option('--style', 'plan', 'style')
];
ask(`learnJobKeys(${JSON.stringify({plan: known})})`);

describe('the job file', () => {
  test('holds what the options say', () => {
    const job = /** @type {{ text: string, left: string[] }} */ (
      ask(`jobOf('plate.dxf', '--tool endmill:6 --op pocket_d4:outer --stepdown 2 --post grbl --accept tool-change --rest')`));
    for (const line of ['file = "plate.dxf"', '[[tool]]', 'kind = "endmill"', 'diameter = 6', 'op = ["pocket_d4:outer"]', 'stepdown = 2',
           'post = "grbl"', 'accept = ["tool-change"]', 'rest = true', 'program = "plate.ngc"'])
      assert.ok(job.text.split('\n').includes(line), `${line} is not in\n${job.text}`);
    assert.deepEqual(job.left, []);
  });
  test('holds tools with all that is said of them, and lengths in inches', () => {
    const tables = /** @type {string[]} */ (ask(
      `['vbit:60deg:10', 'chamfer:90deg:8:tip=0.4:T7', 'endmill:0.25in:flutes=3:length=20:shank=6:stickout=30:holder=40:hss:coated:noplunge', 'tapered:3:taper=5deg:length=20', 'bullnose:6:corner=0.5:name=A'].map(text => toolTable(text, 2))`));
    assert.deepEqual(tables.map(table => table.trim().split('\n').slice(1).join('; ')), [
      'kind = "vbit"; number = 2; tip_angle = 60; diameter = 10',
      'kind = "chamfer"; tip_angle = 90; diameter = 8; tip_diameter = 0.4; number = 7',
      'kind = "endmill"; number = 2; diameter = 6.35; teeth = 3; flute_length = 20; shank_diameter = 6; stickout = 30; holder_diameter = 40; material = "hss"; coated = true; center_cutting = false',
      'kind = "tapered"; number = 2; diameter = 3; taper_angle = 5; flute_length = 20',
      'kind = "bullnose"; number = 2; diameter = 6; corner_radius = 0.5; name = "A"'
    ]);
    assert.deepEqual(
      ask(`['endmill', 'endmill:six', 'endmill:6:magic=1', '6:endmill'].map(text => toolTable(text, 1))`), [null, null, null, null]);
  });
  test('holds tabs, the look of the program, and how contours run', () => {
    const job = /** @type {{ text: string, left: string[] }} */ (ask(
      `jobOf('plate.dxf', '--tabs 4 --tab-shape triangular --skin 0.2 --order outside-in --angle 30 --program-number 7 --block-numbers --no-arcs --style maker')`));
    for (const line of ['tabs = 4', 'tab_shape = "triangular"', 'skin = 0.2', 'order = "outside-in"', 'angle = 30', 'program_number = 7',
           'block_numbers = true', 'arcs = false', 'style = "maker"'])
      assert.ok(job.text.split('\n').includes(line), `${line} is not in\n${job.text}`);
    assert.deepEqual(job.left, []);
  });
  test('says what it has no words for', () => {
    assert.deepEqual(ask(`jobOf('plate.dxf', '--tool vbit:sharp:10 --no-such 3').left`), ['--tool vbit:sharp:10', '--no-such 3']);
  });
});

describe('files and results', () => {
  /** What files come to be for that are chosen one after the other, each a name and what it says. @type {(files: string[][], roles?: string[]) => Promise<unknown>} */
  async function likely(files, roles = ['part', 'program', 'tools', 'machine', 'file']) {
    ask(
      `((files, roles) => { globalThis.listed = listOfFiles('plan', roles, () => {}); listed.show = () => { listed.isRead = true; }; listed.add(files.map(([name, text]) => new File([text ?? ''], name))); })(${
        JSON.stringify(files)}, ${JSON.stringify(roles)})`);
    while (!ask('listed.isRead'))
      await new Promise(resolve => {
        setTimeout(resolve, 1);
      });
    return ask('listed.entries.map(one => one.role)');
  }
  test('a name says what a file is for, until that is taken', async () => {
    assert.deepEqual(await likely([['a.DXF'], ['b.dxf'], ['c.ngc'], ['d.tbl'], ['e.xyz']]), ['part', 'file', 'program', 'tools', 'file']);
    for (const name of ['b-F_Cu.gbr', 'b-PTH.drl', 'B.GKO']) assert.deepEqual(await likely([[name]]), ['part']);
  });
  test('where names leave it open, what a file says shows it', async () => {
    const library = '# ours\n[[tool]]\nnumber = 1\n', machine = 'name = "mill"\nrapid = 4000\n', job = '[part]\nfile = "a.dxf"\n' + library;
    const fusion = '{"data": [{"geometry": {"CSP": false, "DC": 6}}]}', outline = '{"outer": [[0, 0]]}',
          plan = ['part', 'tools', 'machine', 'file'];
    assert.deepEqual(await likely([['t.toml', library], ['m.toml', machine], ['a.dxf']], plan), ['tools', 'machine', 'part']);
    assert.deepEqual(await likely([['t.toml', library], ['m.toml', machine], ['j.toml', job]], plan), ['file', 'file', 'part']);
    assert.deepEqual(await likely([['t.json', fusion], ['o.json', outline], ['u.toml', library]], plan), ['tools', 'part', 'file']);
    for (const [name, text] of [
           ['grbl.txt', '$0=10\r\n$110=5000.000\r\n'], ['mill.ini', '[EMC]\n[KINS]\n'], ['m503.txt', 'echo:  M203 X500.00\n']])
      assert.deepEqual(await likely([[name, text]], plan), ['machine']);
    assert.deepEqual(await likely([['a.txt', 'M203 X5\nG1 X1'], ['t.toml', library]], ['program', 'part', 'file']), ['program', 'file']);
  });
  test('results of a kind are one, or one for each set-up', () => {
    assert.deepEqual(ask(`resultsOf({ program: '/p', report: '/r' }, 'program')`), [['', '/p']]);
    assert.deepEqual(ask(`resultsOf({ 'program-1': '/a', 'program-2': '/b', 'program-x': '/c' }, 'program')`), [['1', '/a'], ['2', '/b']]);
  });
});

describe('lengths', () => {
  const ask = runScripts('apps/serve/page', 'tour.js');
  test('numbers of a field are inches where that was chosen, others stay', () => {
    assert.deepEqual(ask(`[inMm(' 6 '), inMm('0:70,0:50,-5:0')]`), ['6', '0:70,0:50,-5:0']);
    assert.deepEqual(
      ask(`(lengths.inch = true, [inMm('0.25'), inMm('.0625'), inMm('-1,2,0.5,cw'), inMm('6mm'), inMm(''), shownLength(50.8, 2)])`),
      ['6.35', '1.5875', '-25.4,50.8,12.7,cw', '6mm', '', 2]);
  });
  test('sentences of results are shown in inches, too', () => {
    const text = `'The outline of 101.6 x 50.8 mm leaves 645.16 mm2, up to 2.54 mm wide, at x -25.4 y 0 z -3.175, line 6; 1000 mm/min'`;
    assert.equal(ask(`(lengths.inch = false, shownText(${text}))`),
      'The outline of 101.6 x 50.8 mm leaves 645.16 mm2, up to 2.54 mm wide, at x -25.4 y 0 z -3.175, line 6; 1000 mm/min');
    assert.equal(ask(`(lengths.inch = true, shownText(${text}))`),
      'The outline of 4 x 2 in leaves 1 in2, up to 0.1 in wide, at x -1 y 0 z -0.125, line 6; 39.3701 in/min');
  });
  test('what speaks against a program is said in a line', () => {
    const fault = {text: 'A'}, open = {text: 'C', met_by: ''}, met = {text: 'D', met_by: 'accepted'};
    const reasons = [{faults: [fault, fault], conditions: [open]}, {faults: [], conditions: [met, open]}, {faults: [], conditions: [met]}];
    assert.deepEqual(ask(`${JSON.stringify(reasons)}.map(reasonOf)`), ['2 faults: A', '1 open condition: C', '']);
  });
  test('to inches and back a length is what it was', () => {
    assert.deepEqual(ask(`[6, 0.3, 1.5875, 123.4567].map(mm => inchToMm(mmToInch(mm)))`), [6, 0.3, 1.5875, 123.4567]);
  });
});

describe('strategies side by side', () => {
  const run = (/** @type {object} */ more) => ({planned: true, clean: true, fastest: false, time_s: 100, feed_mm: 900, ...more});
  test('the fastest and the next whose path is another are shown first', () => {
    const runs = [
      run({strategy: 'auto', fastest: true}), run({strategy: 'zigzag'}), {strategy: 'x', planned: false},
      run({strategy: 'fixed', time_s: 90, clean: false}), run({strategy: 'spiral', time_s: 130}), run({strategy: 'contour', time_s: 120})
    ];
    assert.deepEqual(ask(`firstBeside(${JSON.stringify(runs)})`), ['auto', 'contour']);
    assert.deepEqual(ask(`firstBeside(${JSON.stringify(runs.slice(0, 2))})`), ['auto', 'zigzag']);
    assert.deepEqual(ask(`[firstBeside([]), firstBeside(${JSON.stringify(runs.slice(0, 1))})]`), [[], ['auto']]);
  });
  test('times go by the share of their own, or by the clock', () => {
    const panes = `(beside.panes = [{ total: 100 }, { total: 40 }], beside.share = 0.5, `;
    assert.deepEqual(ask(`${panes} beside.panes.map(timeOf))`), [50, 20]);
    assert.deepEqual(ask(`${panes} element('beside-by').value = 'clock', beside.panes.map(timeOf))`), [50, 40]);
    assert.deepEqual(ask(`${panes} element('beside-by').value = 'clock', shareAt(beside.panes[1], 30))`), 0.3);
    assert.deepEqual(ask(`${panes} element('beside-by').value = 'share', shareAt(beside.panes[1], 30))`), 0.75);
  });
});

describe('a run', () => {
  /** Answers to `begin` come when they are let; what is followed and dropped is written down. */
  const newRun = () => {
    const ask = runScripts('apps/serve/page', 'tour.js');
    ask(`(globalThis.begun = [], globalThis.followed = [], globalThis.dropped = [], globalThis.heard = [],
      pipeline.begin = () => new Promise(done => { begun.push(done); }), pipeline.drop = async id => { dropped.push(id); },
      pipeline.follow = (id, hear) => { followed.push(id); heard.push(hear); return () => { followed.splice(followed.indexOf(id), 1); }; },
      globalThis.run = new Run('check', { done() {}, ended() {} }), 0)`);
    return ask;
  };
  const settled = () => new Promise(done => {
    setTimeout(done);
  });

  test('started anew hears no more of the one before', async () => {
    const ask = newRun();
    ask(`(run.start(null), begun[0]('a'), 0)`);
    await settled();
    ask(`(run.start(null), begun[1]('b'), 0)`);
    await settled();
    assert.deepEqual(ask('[followed, dropped, run.id, run.isOn]'), [['b'], ['a'], 'b', true]);
    ask(`(heard[1]({ state: 'done', results: {} }), 0)`);
    assert.deepEqual(ask(`[followed, run.id, run.isOn]`), [[], 'b', false]);
  });
  test('cancelled while its files are sent is dropped as soon as it has a name', async () => {
    const ask = newRun();
    ask(`(run.start(null), run.cancel(), begun[0]('a'), 0)`);
    await settled();
    assert.deepEqual(
      ask(`[followed, dropped, run.id, run.isOn, element('check-status').textContent]`), [[], ['a'], '', false, 'Cancelled.']);
  });
});

describe('texts', () => {
  test('how far a check is', () => {
    assert.equal(
      ask(
        `progressText({ state: 'running', seconds: 5.2, progress: { stage: 'certifying', done: 300, most: 900, left_s: 4 } }, { certifying: 'Checking the program' })`),
      'Checking the program … 5 s, about 4 s left');
  });
  test('how far a comparison is', () => {
    assert.equal(
      ask(
        `progressText({ state: 'running', seconds: 8.2, progress: { stage: 'counting', things: 'strategies', done: 4, most: 17, left_s: 30 } })`),
      'Planning and certifying: 4 of 17 strategies done … 8 s, about 30 s left');
    assert.deepEqual(
      ask(`shareDone({ state: 'running', seconds: 8.2, progress: { stage: 'counting', things: 'strategies', done: 4, most: 17 } })`),
      [4, 17]);
  });
  test('how far a plan is', () => {
    assert.equal(ask(`progressText({ state: 'waiting', ahead: 2 })`), 'Waiting; 2 before it.');
    assert.equal(ask(`progressText({ state: 'running', seconds: 3.4, progress: { stage: 'planning', done: 2, most: 9, left_s: 12 } })`),
      'Planning: 2 of at most 9 candidates … 3 s, at most 12 s left');
    assert.equal(
      ask(`progressText({ state: 'running', seconds: 5.2, progress: { stage: 'certifying', done: 300, most: 900, left_s: 4 } })`),
      'Certifying the program … 5 s, about 4 s left');
    assert.deepEqual(
      ask(`shareDone({ state: 'running', seconds: 5.2, progress: { stage: 'certifying', done: 300, most: 900 } })`), [300, 900]);
    assert.equal(ask(`progressText({ state: 'running', seconds: 3.4 })`), 'Reading and preparing … 3 s');
  });
  test('figures that are no number are question marks', () => {
    assert.deepEqual(
      ask(
        `compareColumns.map(([, text]) => text({ strategy: 'zigzag', clean: true, time_s: 61, feed_mm: null, retracts: 3, engagement_max_deg: 90.4, uncut_thickness_mm: null }))`),
      ['zigzag', 'yes', '1:01', '?', '3', '90°', '?']);
  });
  test('an outline is as large as its extent or its diameter', () => {
    assert.deepEqual(
      ask(
        `[{ diameter_mm: 6.001, extent_mm: null }, { diameter_mm: null, extent_mm: { x: [0, 10.504], y: [-1, 4] } }, { diameter_mm: null, extent_mm: null }].map(sizeOf)`),
      ['Ø 6', '10.5 × 5', '']);
  });
  test('a drawing is as large as all its outlines that have a curve', () => {
    const outlines =
      `[{ path: 'M0 0Z', extent_mm: { x: [1, 5], y: [-2, 3] } }, { path: 'M0 0Z', extent_mm: { x: [-4, 2], y: [0, 9] } }, { path: null, extent_mm: { x: [-99, 99], y: [0, 1] } }]`;
    assert.deepEqual(ask(`extentOfDrawing(${outlines})`), {x: [-4, 5], y: [-2, 9]});
    assert.equal(ask('extentOfDrawing([])'), null);
  });
  test('outlines on each other share a place for their numbers', () => {
    const outline = (/** @type {number} */ number, /** @type {number | null} */ d) =>
      ({number, path: 'M0 0Z', diameter_mm: d, extent_mm: {x: [0, 6], y: [0, 6]}});
    const places = /** @type {{ text: string, x: number, y: number }[]} */ (
      ask(`numbersOfOutlines(${JSON.stringify([outline(1, 6), outline(2, null), outline(3, 6)])})`));
    assert.deepEqual(places.map(({text, x, y}) => [text, x, y]), [['1, 3', 3, -6], ['2', 0, -6]]);
  });
  test('a part is ready, has to be asked about, or cannot be read', () => {
    assert.equal(
      ask(`readiness('a.dxf', { asks: [], answers: [], found: [{ kind: 'note', what: 'n' }] }, [])`), 'a.dxf is ready to be planned.');
    assert.equal(ask(`readiness('a.dxf', { asks: [], answers: [], found: [{ kind: 'warning', what: 'the file names no unit' }] }, [])`),
      'a.dxf is ready to be planned. See first: the file names no unit.');
    assert.equal(
      ask(
        `readiness('a.dxf', { asks: ['the outline holds 5 others: --op profile:outer if', 'how deep; --depth MM, or'], answers: [{}] }, [])`),
      'Before a.dxf can be planned, say: (1) which reading below is meant, by a click on it; (2) how deep it is, in the field Depth');
    assert.equal(ask(`readiness('a.dxf', { asks: ['x', 'y'], answers: [] }, [])`), 'Before a.dxf can be planned, say: (1) x; (2) y');
    assert.equal(ask(`readiness('a.dxf', undefined, ['a.dxf:3: no'])`), 'a.dxf:3: no');
    assert.match(String(ask(`whatIsMissing(['photo.jpg'])`)), /^photo.jpg: no part by the name's ending; choose a DXF/);
  });
  test('set-ups of a job are told apart', () => {
    const joined =
      `joinedSetups([{ asks: ['a depth'], found: [], features: [], outlines: [] }, { asks: [], found: [{ kind: 'note', where: '', what: 'w' }], features: [], outlines: [] }])`;
    assert.deepEqual(ask(`textsOf(${joined})`), ['To say: set-up 1: a depth', 'note: set-up 2: w']);
  });
});

describe('a part that no drawing shows', () => {
  test('of a part without outlines the floors are drawn, deep ones over shallow ones and darker', () => {
    const features = `[{ name: 'deep', path: 'M1 1Z', top_z: 0, floor_z: -8 }, { name: 'none', path: '', top_z: 0, floor_z: -9 },
          { name: 'shallow', path: 'M0 0Z', top_z: 0, floor_z: -2 }]`;
    assert.deepEqual(ask(`floorsOf(${features}, null)`),
      [{path: 'M0 0Z', opacity: 0.24, title: 'shallow, z 0 to -2'}, {path: 'M1 1Z', opacity: 0.6, title: 'deep, z 0 to -8'}]);
    assert.deepEqual(ask('floorsOf([], null)'), []);
  });
});

describe('readings of a drawing', () => {
  test('a question is asked without its options, and its answers are said in words', () => {
    assert.deepEqual(
      ask(
        `['the outline holds 5 others, and nothing says what it is: --op profile:outer if it is the edge', 'it is 0.1 x 0.2 mm, smaller than 1 mm; say which unit it is drawn in (--unit mm)'].map(plainQuestion)`),
      ['The outline holds 5 others, and nothing says what it is', 'It is 0.1 x 0.2 mm, smaller than 1 mm']);
    assert.deepEqual(
      ask(
        `[['--op', 'pocket:outer'], ['--op', 'pocket:B'], ['--op', 'step:my layer'], ['--unit', 'inch'], ['--new', 'thing']].map(([option, value]) => wordsOfAnswer({ option, value }))`),
      ['A pocket: what lies in it stays', 'Milled with that pocket', 'A step that stays in that pocket', 'Drawn in inches', '--new thing']);
    assert.equal(
      ask(`outlineOptions({ ...emptyProject(), given: [{ option: '--op', value: 'step:my layer' }] }).join(' ')`), '--op "step:my layer"');
    assert.equal(
      ask(`rolesSaid(['profile', 'pocket', 'pocket', '', 'inside', 'inside'].map(role => ({ role })))`), '1 profile, 2 pockets, 2 inside');
  });
});

describe('elements', () => {
  test('an element is an option; blanks go, and a minus is no option of its own', () => {
    const option = (/** @type {string[]} */...[kind, numbers, tool, depth]) =>
      ask(`elementOption(${JSON.stringify({kind, numbers, tool, depth})})`);
    assert.equal(option('pocket', '0, 0, 20,16', '1', ' 4 '), '--pocket 0,0,20,16:T1:depth=4');
    assert.equal(option('hole', '-5,3,6', '', ''), '--hole=-5,3,6');
    assert.equal(option('line', ' ', '2', '1'), '');
  });
  test('their progress counts elements', () => {
    assert.equal(
      ask(`progressText({ state: 'running', seconds: 1, progress: { stage: 'planning', done: 1, most: 5 } }, { things: 'elements' })`),
      'Planning: 1 of at most 5 elements … 1 s');
  });
});

describe('a tour', () => {
  test('a lattice is what the command takes, and nothing else is', () => {
    assert.deepEqual(ask(`['30x20', ' 3 X 4 ', '5×6', '0x3', '10000x2', '/etc/passwd', '3x4x5', ''].map(latticeOf)`),
      ['30x20', '3x4', '5x6', '', '', '', '', '']);
  });
  test('each value holds until the next, the last to the end', () => {
    assert.equal(ask(`convergencePath([[0, 20], [1, 15], [2, 10]], 4, 10, 20)`), 'M0 0H250V500H500V1000H1000');
    assert.equal(ask(`convergencePath([[0.1, 7]], 0, 7, 7)`), 'M0 500H1000');
    assert.equal(ask(`convergencePath([], 4, 0, 1)`), '');
  });
  test('how far a search is', () => {
    const state = {state: 'running', seconds: 3.2, progress: {stage: 'searching', best: 1234.5, found_s: 1.24, left_s: 7}};
    assert.equal(ask(`progressText(${JSON.stringify(state)})`), 'Searching: best 1234.5 after 1.2 s … 3 s, at most 7 s left');
    assert.deepEqual(ask(`shareDone(${JSON.stringify(state)})`), [3.2, 10.2]);
  });
  test('figures say what is proven', () => {
    const found = {
      objective: 99,
      objective_name: 'length',
      length: 99,
      turns: 18,
      bound: 99,
      bound_basis: 'lattice steps',
      gap: 0,
      time_s: 0.5,
      method: 'sweep',
      convergence: [],
      tour: [0, 1]
    };
    assert.deepEqual(ask(`tourFigures(${JSON.stringify(found)}).slice(0, 3)`),
      [['length', '99'], ['bound', '99 (lattice steps)'], ['gap', '0: proven optimal']]);
    assert.deepEqual(ask(`[0.0123, null].map(gap => tourFigures({ ...${JSON.stringify(found)}, gap })[2][1])`), ['1.230 %', 'not known']);
  });
});
