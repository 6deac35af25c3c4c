// node lint.mjs FOLDER KIND: ESLint over what FOLDER holds; findings are told as file:line:column, and any finding fails. KIND: "report" and
// "page" are scripts that are joined in the order of scripts.txt, and style sheets (a page may ask its server, a report asks nobody);
// "worker" are scripts of workers, each by itself; "modules" are modules for Node.
import {readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';
import css from '@eslint/css';
import js from '@eslint/js';
import {Linter} from 'eslint';
import globals from 'globals';

/** A file of the folder and a line in it. @typedef {{ name: string, line: number }} Place */
const [folder, kind] = process.argv.slice(2);
const forbidden = kind === 'modules' ? [] : ['XMLHttpRequest', 'WebSocket', 'localStorage', ...(kind === 'report' ? ['fetch'] : [])];
const known = kind === 'modules' ?
  {...globals.node, ...globals.browser} :
  kind === 'worker' ?
  {...globals.worker, ...globals.serviceworker, module: 'writable', runCommand: 'writable', clearcutModule: 'readonly'} :
  globals.browser;
/** @type {(name: string) => string} */
const text = name => readFileSync(join(folder, name), 'utf8');

/** @type {import('eslint').Linter.Config[]} */
const scriptRules = [
  js.configs.recommended, {
    languageOptions: {sourceType: kind === 'modules' ? 'module' : 'script', ecmaVersion: 2022, globals: known},
    linterOptions: {reportUnusedDisableDirectives: 'error'},
    rules: {
      'eqeqeq': 'error',
      'no-redeclare': ['error', {builtinGlobals: false}],
      'no-var': 'error',
      'prefer-const': 'error',
      'no-use-before-define': ['error', {functions: false, variables: false}],
      'no-eval': 'error',
      'no-implied-eval': 'error',
      'no-throw-literal': 'error',
      'no-restricted-globals': ['error', ...forbidden],
      'no-restricted-properties': ['error', {property: 'innerHTML'}, {property: 'outerHTML'}, {property: 'insertAdjacentHTML'}],
      'max-lines-per-function': ['error', 75],
      'complexity': ['error', 15],
    },
  }
];
// Only what every browser of the last two and a half years knows. The colours are variables that html.cpp writes.
/** @type {import('eslint').Linter.Config[]} */
const styleRules = [{
  plugins: {css: /** @type {import('eslint').ESLint.Plugin} */ (/** @type {unknown} */ (css))},
  language: 'css/css',
  rules: {
    'css/no-duplicate-imports': 'error',
    'css/no-empty-blocks': 'error',
    'css/no-invalid-at-rules': 'error',
    'css/no-invalid-properties': ['error', {allowUnknownVariables: true}],
    'css/use-baseline': ['error', {available: 'widely'}],
  }
}];

/** The scripts as one text, and for each line of it the file and line it comes from. @type {(names: string[]) => { code: string, places: Place[] }} */
function joined(names) {
  /** @type {string[]} */
  const lines = [];
  /** @type {Place[]} */
  const places = [];
  names.forEach((name, i) => {
    if (i > 0) {
      lines.push('');
      places.push({name, line: 0});
    }
    text(name).replace(/\n$/, '').split('\n').forEach((line, k) => {
      lines.push(line);
      places.push({name, line: k + 1});
    });
  });
  return {code: lines.join('\n') + '\n', places};
}

/** @type {(messages: import('eslint').Linter.LintMessage[], placeOf: (line: number) => Place) => number} */
function tell(messages, placeOf) {
  for (const m of messages) {
    const place = placeOf(m.line ?? 1);
    console.log(`${join(folder, place.name)}:${place.line}:${m.column ?? 1}: ${m.message} (${m.ruleId ?? 'syntax'})`);
  }
  return messages.length;
}

const linter = new Linter({configType: 'flat'});
let found = 0;
if (kind === 'report' || kind === 'page') {
  const {code, places} = joined(text('scripts.txt').trim().split('\n'));
  found += tell(linter.verify(code, scriptRules, 'page.js'), line => places[line - 1] ?? places[places.length - 1]);
} else {
  for (const name of readdirSync(folder).filter(one => one.endsWith(kind === 'modules' ? '.mjs' : '.js'))) {
    const rules = scriptRules.map(rule => ({files: ['**/*.js', '**/*.mjs'], ...rule}));
    found += tell(linter.verify(text(name), rules, name), line => ({name, line}));
  }
}
for (const name of readdirSync(folder).filter(one => one.endsWith('.css'))) {
  const rules = styleRules.map(rule => ({files: ['**/*.css'], ...rule}));
  found += tell(linter.verify(text(name), rules, name), line => ({name, line}));
}
console.log(found === 0 ? `${folder}: no findings` : `${folder}: ${found} findings`);
process.exit(found === 0 ? 0 : 1);
