// The packed folder VERIFY_MODULE_PACKAGE as another program uses it: answers, size, time, and the widget with a host of its own. Where CLEARCUT names
// the command, the answers are compared with those of `clearcut verify`.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';
import {test} from 'node:test';
import zlib from 'node:zlib';

const folder = path.resolve(process.env.VERIFY_MODULE_PACKAGE);
const command = process.env.CLEARCUT ? path.resolve(process.env.CLEARCUT) : '';
const require = createRequire(import.meta.url);
const {createVerifier} = require(folder);
const {startWidget} = require(path.join(folder, 'widget', 'widget.js'));
const verifier = await createVerifier();

const slot = 'G21 G90 G94\nT1 M6\nS10000 M3\nG0 X10 Y10 Z5\nG1 Z-2 F100\nG1 X40 F600\nG0 Z5\nM5\nM30\n';
const rapid = slot.replace('G1 X40 F600', 'G0 X40');
const question = {
  name: 'slot.nc',
  tools: ['endmill:6:T1'],
  stock: '50,30,10',
  dialect: 'linuxcnc'
};
const checked = (program, asked = question) => JSON.parse(verifier.check(program, JSON.stringify(asked)));

/** Rows over a square, in layers, of about so many bytes. */
function program_of_bytes(bytes) {
  const lines = ['G21 G90 G94', 'T1 M6', 'S10000 M3', 'G0 X5 Y5 Z5'];
  let size = 0, z = 0;
  while (size < bytes) {
    z -= 0.5;
    lines.push('G0 X5 Y5', `G1 Z${z.toFixed(3)} F200`);
    for (let row = 0; row < 45 && size < bytes; ++row) {
      for (let i = 0; i < 200; ++i) {
        const x = 5 + (row % 2 === 0 ? i : 199 - i) * 0.45;
        const line = `G1 X${x.toFixed(3)} Y${(5 + 2 * row + 0.3 * Math.sin(x / 3)).toFixed(3)} F800`;
        lines.push(line);
        size += line.length + 1;
      }
    }
    lines.push('G0 Z5');
  }
  return lines.concat('M5', 'M30', '').join('\n');
}

test('a program alone', () => {
  assert.equal(checked(slot).error, undefined);
  assert.equal(checked(slot).faults.length, 0);
  const faulty = checked(rapid);
  assert.equal(faulty.verdict, 'FAULTY');
  assert.equal(faulty.faults[0].line, 6);
});

test('a program against a part', () => {
  const part = {outer: [[0, 0], [20, 0], [20, 20], [0, 20]], depth: 2};
  const answer = checked(slot, {name: 'slot.nc', tools: ['endmill:6:T1'], dialect: 'linuxcnc', part});
  assert.equal(answer.verdict, 'FAULTY');
  assert.ok(answer.uncut_mm2 > 100);
});

test('bad questions and programs are answered in one line', () => {
  for (const [program, asked] of [
         [slot, '{'], [slot, '{"tols": 1}'], ['', '{"tools": ["endmill:6"]}'], ['G1 X[', '{"tools": ["endmill:6"]}']]) {
    const answer = JSON.parse(verifier.check(program, asked));
    assert.equal(typeof answer.error, 'string');
    assert.ok(!answer.error.includes('\n'));
  }
  assert.ok(verifier.optionNames().includes('keep-out'));
});

test('the answer is that of the command', {skip: !command}, () => {
  const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'verify-module-'));
  for (const program of [slot, rapid, program_of_bytes(20000)]) {
    const file = path.join(scratch, 'slot.nc');
    fs.writeFileSync(file, program);
    let text = '';
    try {
      text =
        execFileSync(command, ['verify', file, '--tool', 'endmill:6:T1', '--stock', '50,30,10', '--dialect', 'linuxcnc', '--json', '-'],
          {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']});
    } catch (error) { text = error.stdout; }
    const theirs = JSON.parse(text), ours = checked(program);
    for (const unlike of ['seal', 'inputs', 'question', 'program']) delete theirs[unlike], delete ours[unlike];
    assert.deepEqual(ours, theirs);
  }
  fs.rmSync(scratch, {recursive: true});
});

test('the module has at most 700 kB, packed by brotli', () => {
  const files = ['clearcut-verify.wasm', 'clearcut-verify.js', 'index.js'];
  const sizes = files.map((name) => zlib.brotliCompressSync(fs.readFileSync(path.join(folder, name))).length);
  console.log('packed by brotli: ' + files.map((name, i) => `${name} ${sizes[i]}`).join(', '));
  assert.ok(sizes.reduce((sum, size) => sum + size) <= 700000);
});

test('1 MB of program', () => {
  const program = program_of_bytes(1e6);
  const began = process.cpuUsage();
  const answer = checked(program, {...question, stock: '100,100,30'});
  const spent = process.cpuUsage(began);
  console.log(`${(program.length / 1e6).toFixed(2)} MB of program: ${((spent.user + spent.system) / 1e6).toFixed(2)} s of CPU`);
  assert.equal(answer.error, undefined);
});

/** A host as senders give it to widgets. */
function stub_host() {
  const listeners = new Map();
  const commands = [];
  return {
    commands,
    listeners,
    settings: {},
    addListener(event, listener) { listeners.set(event, (listeners.get(event) || []).concat(listener)); },
    removeListener(event, listener) { listeners.set(event, listeners.get(event).filter((one) => one !== listener)); },
    command(name) { commands.push(name); },
    tell(event, ...values) {
      for (const listener of listeners.get(event) || []) listener(...values);
    }
  };
}

const bare = 'G21 G90 G94\nS10000 M3\nG0 X10 Y10 Z5\nG1 Z-2 F100\nG1 X40 F600\nG0 Z5\nM5\nM30\n';

function started(host, shown) {
  return startWidget({
    host,
    verifier,
    question: () => ({tools: ['endmill:6'], stock: '50,30,10'}),
    show: (verdict) => shown.push(verdict),
    holdFaulty: true
  });
}

test('the widget checks what is loaded', () => {
  const host = stub_host(), shown = [];
  const widget = started(host, shown);
  host.tell('gcode:load', 'slot.nc', bare, {});
  assert.notEqual(shown.at(-1).verdict, 'FAULTY');
  assert.notEqual(shown.at(-1).verdict, 'NOT CHECKED');
  host.tell('workflow:state', 'running');
  assert.deepEqual(host.commands, []);
  host.tell('sender:load', {name: 'rapid.nc', content: bare.replace('G1 X40 F600', 'G0 X40')}, {});
  assert.equal(shown.at(-1).verdict, 'FAULTY');
  assert.ok(shown.at(-1).lines.some((line) => line.startsWith('line 5: ')));
  host.tell('workflow:state', 'running');
  assert.deepEqual(host.commands, ['gcode:pause']);
  host.tell('gcode:unload');
  assert.equal(shown.at(-1).verdict, '');
  widget.stop();
  assert.ok([...host.listeners.values()].every((all) => all.length === 0));
});

test('the widget asks with the settings of the control', () => {
  const host = stub_host(), shown = [];
  started(host, shown);
  host.tell('gcode:load', 'slot.nc', bare, {});
  const before = shown.at(-1);
  host.settings = {
    settings:
      {'$30': '8000', '$31': '0', '$110': '500', '$111': '500', '$112': '300', '$120': '50', '$121': '50', '$122': '20', '$11': '0.01'}
  };
  host.tell('controller:settings', 'Grbl', host.settings);
  assert.notDeepEqual(shown.at(-1), before);
});

test('a program that cannot be read is shown, and held', () => {
  const host = stub_host(), shown = [];
  started(host, shown);
  host.tell('gcode:load', 'bad.nc', 'G1 X[1 F\n', {});
  assert.equal(shown.at(-1).verdict, 'NOT CHECKED');
  host.tell('workflow:state', 'running');
  assert.deepEqual(host.commands, ['gcode:pause']);
});
