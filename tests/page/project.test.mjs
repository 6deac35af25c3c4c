// What was said of a part: history, operations as a job, tools as words, project files.
import assert from 'node:assert/strict';
import {describe, test} from 'node:test';
import {runScripts} from './fake_page.mjs';

/** The page's scripts with a table of options; what is shown is written nowhere. */
function newPage() {
  const ask = runScripts('apps/serve/page', 'tour.js');
  const numbers = ['stepdown', 'feed', 'depth'], texts = ['strategy', 'material'];
  const known = [...numbers, ...texts].map(name => ({
    names: [`--${name}`],
    value: 'TEXT',
    many: false,
    job: {table: name === 'depth' ? 'part' : 'plan', key: name, opposite: false, number: numbers.includes(name)}
  }));
  ask(`(project.shown = null, learnJobKeys(${JSON.stringify({
    plan: [...known, {names: ['--op'], value: 'TEXT', many: true, job: {table: 'part', key: 'op', opposite: false, number: false}}]
  })}), 0)`);
  return ask;
}
const box = (/** @type {number} */ x0, /** @type {number} */ y0, /** @type {number} */ x1, /** @type {number} */ y1) =>
  ({x: [x0, x1], y: [y0, y1]});
const hole = (/** @type {string} */ name, /** @type {number} */ x) =>
  ({name, kind: 'round_hole', source: 'HOLE_D8', top_z: 0, floor_z: -8, extent_mm: box(x, 0, x + 6, 6)});
const features = [
  {name: 'POCKET', kind: 'closed_pocket', source: 'POCKET', top_z: 0, floor_z: -5, extent_mm: box(10, 10, 50, 40)}, hole('HOLE_D8', 0),
  hole('HOLE_D8_2', 60), {...hole('DEEP', 80), floor_z: -12}
];

describe('history', () => {
  test('each change is undone and done again', () => {
    const ask = newPage();
    ask(`(answer('--stepdown', ['2']), answer('--feed', ['600']), answer('--feed', null), 0)`);
    assert.deepEqual(ask('project.now.answers'), {'--stepdown': ['2']});
    ask('(undo(), 0)');
    // What was typed of one thing within a moment is one change.
    assert.deepEqual(ask('project.now.answers'), {'--stepdown': ['2']});
    ask('(undo(), 0)');
    assert.deepEqual(ask('[project.now.answers, project.past.length, project.future.length]'), [{}, 0, 2]);
    ask('(redo(), redo(), redo(), 0)');
    assert.deepEqual(ask('[project.now.answers, project.past.length, project.future.length]'), [{'--stepdown': ['2']}, 2, 0]);
  });
  test('a change after undoing leaves nothing to be done again', () => {
    const ask = newPage();
    ask(`(answer('--stepdown', ['2']), undo(), answer('--feed', ['600']), 0)`);
    assert.deepEqual(ask('[project.now.answers, project.future.length]'), [{'--feed': ['600']}, 0]);
  });
  test('a new project can be undone, and keeps the tools', () => {
    const ask = newPage();
    ask(`(changeTool(0, {diameter: '4'}, 'diameter'), answer('--feed', ['1']), replaceProject(emptyProject(project.now.tools)), 0)`);
    assert.deepEqual(ask('[project.now.answers, project.now.tools[0].diameter]'), [{}, '4']);
    ask('(undo(), 0)');
    assert.deepEqual(ask('project.now.answers'), {'--feed': ['1']});
  });
});

describe('operations', () => {
  const rows = `operationRows(${JSON.stringify(features)}, project.now.sequence)`;
  test('rows on one centre are told apart', () => {
    const ask = newPage(), wide = {...hole('CBORE', 0), extent_mm: box(-3, -3, 9, 9)};
    assert.notEqual(ask(`placeOfFeature(${JSON.stringify(hole('A', 0))})`), ask(`placeOfFeature(${JSON.stringify(wide)})`));
  });
  test('holes of one kind are one row', () => {
    const ask = newPage();
    assert.deepEqual(
      ask(`${rows}.map(row => [titleOfRow(row), row.features.length])`), [['Pocket 40 × 30', 1], ['2 holes Ø 6', 2], ['Hole Ø 6', 1]]);
  });
  test('what is said of a row goes to every feature of it, as a job says it', () => {
    const ask = newPage();
    ask(`(part.features = ${
      JSON.stringify(
        features)}, changeOperation('round_hole 3.00 3.00 6.00 6.00', {answers: {'--feed': ['300'], '--strategy': ['contour']}, tool: '2'}, 'x'), 0)`);
    assert.equal(ask(`operationTables(${rows}, project.now.operations)`),
      ['HOLE_D8', 'HOLE_D8_2'].map(name => `[[operation]]\nfeature = "${name}"\ntool = 2\nfeed = 300\nstrategy = "contour"\n`).join('\n'));
    ask(`(changeOperation('round_hole 3.00 3.00 6.00 6.00', {isOff: true}, 'on'), 0)`);
    assert.match(
      String(ask(`operationTables(${rows}, project.now.operations)`)), /^\[\[operation\]\]\nfeature = "HOLE_D8"\nskip = true\n\n/);
    ask(`(changeOperation('round_hole 3.00 3.00 6.00 6.00', {isOff: false, tool: '', answers: {}}, 'on'), 0)`);
    assert.deepEqual(ask('project.now.operations'), {});
  });
  test('one that was moved stays there, and the job names all in their order', () => {
    const ask = newPage();
    ask(`(part.features = ${JSON.stringify(features)}, moveOperation('round_hole 83.00 3.00 6.00 6.00', 0), 0)`);
    assert.deepEqual(ask(`namesInSequence(${rows}, project.now.sequence)`), ['DEEP', 'POCKET', 'HOLE_D8', 'HOLE_D8_2']);
    const job = /** @type {{ text: string }} */ (ask(`jobOf('a.dxf', '--tool endmill:6 --stepdown 2', moreOfJob(project.now))`));
    assert.match(job.text, /\[plan\]\nstepdown = 2\nsequence = \["DEEP", "POCKET", "HOLE_D8", "HOLE_D8_2"\]/);
    ask('(undo(), 0)');
    assert.equal(ask('moreOfJob(project.now)'), null);
  });
  test('somebody\'s job is kept, and what is said here is added', () => {
    const ask = newPage();
    assert.equal(
      ask(
        `jobWith('[part]\\nfile = "a.dxf"\\n[plan] # cut\\nstepdown = 2\\n', {operations: '[[operation]]\\nskip = true\\n', sequence: ['A'], stock: ''})`),
      '[part]\nfile = "a.dxf"\n[plan] # cut\nsequence = ["A"]\nstepdown = 2\n\n[[operation]]\nskip = true\n');
    assert.equal(ask(`jobWith('[part]\\nfile = "a.dxf"\\n', {operations: '', sequence: ['A'], stock: ''})`),
      '[part]\nfile = "a.dxf"\n\n[plan]\nsequence = ["A"]\n');
  });
  test('the stock is said by its heights', () => {
    const ask = newPage();
    assert.equal(ask(`stockTable({margin: '5', bottom: '-18', top: ''})`), '[stock]\nmargin = 5\nz = [-18, 0]\n');
    assert.equal(ask(`stockTable({margin: '5', bottom: '', top: ''})`), '');
  });
});

describe('tools', () => {
  test('are the words of the command line', () => {
    const ask = newPage();
    assert.equal(ask(`wordOfTool({isOn: true, kind: 'vbit', diameter: '6', more: {angle: '60', tip: '0.2', number: '4'}})`),
      'vbit:6:T4:60deg:tip=0.2');
  });
  test('get numbers that a library has not taken', () => {
    const ask = newPage();
    const tools = [
      {isOn: true, kind: 'endmill', diameter: '6', more: {}}, {isOn: true, kind: 'drill', diameter: '3', more: {number: '2'}},
      {isOn: false, kind: 'ball', diameter: '3', more: {}}
    ];
    assert.deepEqual(
      ask(`numberedTools({...emptyProject(${JSON.stringify(tools)}), saysTools: true}, [{number: 1}]).map(one => one.number)`), [3, 2]);
  });
  test('of a part that says its own are left to it until somebody says others', () => {
    const ask = newPage(), job = `{...emptyProject(), files: [{file: {name: 'a.toml'}, role: 'part'}]}`;
    assert.deepEqual(
      ask(`[toolsUsed(${job}).length, toolsUsed({...${job}, saysTools: true}).length, toolsUsed(emptyProject()).length]`), [0, 1, 1]);
  });
});

describe('fields', () => {
  test('answers are words, and a minus is no option of its own', () => {
    assert.deepEqual(newPage()(`wordsOfAnswers({'--rest': [], '--tab-at': ['1,2', '-3,4'], '--layer': ['my layer']})`),
      ['--rest', '--tab-at 1,2', '--tab-at=-3,4', '--layer "my layer"']);
  });
  test('every option has a place', () => {
    const of = (/** @type {object} */ more) =>
      newPage()(`placeOf(${JSON.stringify({names: ['--x'], group: 'Limits', place: {level: 'rest'}, ...more})})`);
    assert.deepEqual(
      [of({}), of({group: 'Input'}), of({names: ['--tabs'], group: 'Drawings'}), of({place: {level: 'research'}}), of({group: 'New'})],
      ['cutting', 'stock', 'holding', 'research', 'cutting']);
  });
});

describe('files', () => {
  test('that nothing names are said', () => {
    const files = (/** @type {string[][]} */...all) => JSON.stringify(all.map(([name, role]) => ({file: {name}, role})));
    const ask = newPage();
    assert.deepEqual(ask(`unusedFiles({...emptyProject(), files: ${
                       files(['a.dxf', 'part'], ['b.dxf', 'file'], ['c.ngc', 'file'])}, answers: {'--after': ['c.ngc']}})`),
      ['b.dxf']);
    assert.deepEqual(ask(`unusedFiles({...emptyProject(), files: ${files(['a.toml', 'part'], ['b.dxf', 'file'])}})`), []);
  });
  test('a project file gives back what was saved', async () => {
    const ask = newPage();
    ask(
      `(globalThis.saved = '', project.now = {...emptyProject(), files: [{file: new File(['0\\nEOF\\n'], 'a.dxf'), role: 'part'}, {file: new File([new Uint8Array([255, 0])], 'b.bin'), role: 'file'}],
      answers: {'--depth': ['5'], '--rest': []}, outlines: {2: {kind: 'ignore', depth: '', role: ''}}},
      projectText(project.now, {input: 'a.dxf', options: '--tool endmill:6 --tool ball:3 --depth 5 --rest', files: []}).then(text => { saved = text; }), 0)`);
    await new Promise(done => {
      setTimeout(done, 50);
    });
    const json = /** @type {{ plan: object, files: object[] }} */ (ask('JSON.parse(saved)'));
    assert.deepEqual(json.plan, {input: 'a.dxf', options: {tool: ['endmill:6', 'ball:3'], depth: ['5'], rest: []}});
    assert.deepEqual(json.files, [{name: 'a.dxf', text: '0\nEOF\n'}, {name: 'b.bin', base64: '/wA='}]);
    assert.deepEqual(
      ask(`(now => [now.answers, now.outlines, now.files.map(one => [one.file.name, one.role, one.file.size])])(projectOf('a', saved))`),
      [{'--depth': ['5'], '--rest': []}, {2: {kind: 'ignore', depth: '', role: ''}}, [['a.dxf', 'part', 6], ['b.bin', 'file', 2]]]);
    assert.throws(() => ask(`projectOf('x.clearcut.json', '{}')`), /x.clearcut.json: is no project file/);
  });
  test('the example is a drawing of six outlines', () => {
    const text = String(newPage()('exampleDrawing()'));
    assert.deepEqual([text.match(/LWPOLYLINE/g)?.length, text.match(/CIRCLE/g)?.length], [2, 4]);
  });
});

describe('research', () => {
  test('published methods are offered where somebody asks for research', () => {
    const ask = newPage();
    const option = JSON.stringify(
      {values: ['auto', 'zigzag', 'lom', 'lom-corrected'], help: 'auto, zigzag, or a published method: lom, lom-corrected (default auto)'});
    assert.deepEqual(ask(`offeredValues(${option})`), ['auto', 'zigzag']);
    assert.deepEqual(ask(`(research.isShown = true, offeredValues(${option}))`), ['auto', 'zigzag', 'lom', 'lom-corrected']);
  });
});
