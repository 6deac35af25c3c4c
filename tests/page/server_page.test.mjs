// What the page of the server computes: words of options, the job file, what files and results are for, texts.
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { runScripts } from './fake_page.mjs';

const ask = runScripts('apps/serve/page', 'check.js');

describe('options', () => {
  test('a word is quoted where a shell needs it', () => {
    assert.deepEqual(ask(`['part.dxf', 'my part.dxf', 'a"b'].map(quoted)`), ['part.dxf', '"my part.dxf"', '"ab"']);
  });
  test('words are taken apart as the server does', () => {
    assert.deepEqual(ask(`wordsOf('--tool endmill:6  --op "pocket:my layer" --name=\\'a b\\'')`), ['--tool', 'endmill:6', '--op', 'pocket:my layer', '--name=a b']);
    assert.deepEqual(ask(`optionsOf('loose --tool endmill:6 ball:3 --rest --depth=4')`), [['--tool', ['endmill:6', 'ball:3']], ['--rest', []], ['--depth', ['4']]]);
  });
});

describe('the job file', () => {
  test('holds what the options say', () => {
    const job = /** @type {{ text: string, left: string[] }} */ (ask(`jobOf('plate.dxf', '--tool endmill:6 --op pocket_d4:outer --stepdown 2 --post grbl --accept tool-change --rest')`));
    for (const line of ['file = "plate.dxf"', '[[tool]]', 'kind = "endmill"', 'diameter = 6', 'name = "outer"', 'role = "pocket"', 'depth = 4', 'stepdown = 2', 'post = "grbl"',
      'accept = ["tool-change"]', 'rest = true', 'program = "plate.ngc"'])
      assert.ok(job.text.split('\n').includes(line), `${line} is not in\n${job.text}`);
    assert.deepEqual(job.left, []);
  });
  test('says what it has no words for', () => {
    assert.deepEqual(ask(`jobOf('plate.dxf', '--tool vbit:60deg:10 --no-such 3').left`), ['--tool vbit:60deg:10', '--no-such 3']);
  });
});

describe('files and results', () => {
  test('a name says what a file is for, until that is taken', () => {
    const likely = `(names => { const list = listOfFiles('plan', ['part', 'program', 'tools', 'file'], () => {}); list.show = () => {}; list.add(names.map(name => ({ name }))); return list.entries.map(one => one.role); })`;
    assert.deepEqual(ask(`${likely}(['a.DXF', 'b.dxf', 'c.ngc', 'd.tbl', 'e.xyz'])`), ['part', 'file', 'program', 'tools', 'file']);
  });
  test('results of a kind are one, or one for each set-up', () => {
    assert.deepEqual(ask(`resultsOf({ program: '/p', report: '/r' }, 'program')`), [['', '/p']]);
    assert.deepEqual(ask(`resultsOf({ 'program-1': '/a', 'program-2': '/b', 'program-x': '/c' }, 'program')`), [['1', '/a'], ['2', '/b']]);
  });
});

describe('texts', () => {
  test('how far a plan is', () => {
    assert.equal(ask(`progressText({ state: 'waiting', ahead: 2 })`), 'Waiting; 2 before it.');
    assert.equal(ask(`progressText({ state: 'running', seconds: 3.4, progress: { stage: 'planning', done: 2, most: 9, left_s: 12 } })`), 'Planning: 2 of at most 9 candidates … 3 s, at most 12 s left');
    assert.equal(ask(`progressText({ state: 'running', seconds: 3.4 })`), 'Reading and preparing … 3 s');
  });
  test('figures that are no number are question marks', () => {
    assert.deepEqual(ask(`compareColumns.map(([, text]) => text({ strategy: 'zigzag', clean: true, time_s: 61, feed_mm: null, retracts: 3, engagement_max_deg: 90.4, uncut_thickness_mm: null }))`),
      ['zigzag', 'yes', '1:01', '?', '3', '90°', '?']);
  });
  test('an outline is as large as its extent or its diameter', () => {
    assert.deepEqual(ask(`[{ diameter_mm: 6.001, extent_mm: null }, { diameter_mm: null, extent_mm: { x: [0, 10.504], y: [-1, 4] } }, { diameter_mm: null, extent_mm: null }].map(sizeOf)`), ['Ø 6', '10.5 × 5', '']);
  });
  test('set-ups of a job are told apart', () => {
    const joined = `joinedSetups([{ asks: ['a depth'], found: [], features: [], outlines: [] }, { asks: [], found: [{ kind: 'note', where: '', what: 'w' }], features: [], outlines: [] }])`;
    assert.deepEqual(ask(`textsOf(${joined})`), ['To say: set-up 1: a depth', 'note: set-up 2: w']);
  });
});
