// node lint.mjs FOLDER [may-fetch]: ESLint over the scripts of FOLDER, joined in the order of scripts.txt as the page holds them, and
// over its style sheets. may-fetch: a page with a server of its own. Findings are told as file:line:column; any finding fails.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import css from '@eslint/css';
import js from '@eslint/js';
import { Linter } from 'eslint';
import globals from 'globals';

const folder = process.argv[2] ?? '.';
const forbidden = ['XMLHttpRequest', 'WebSocket', 'localStorage', ...(process.argv[3] === 'may-fetch' ? [] : ['fetch'])];
const text = name => readFileSync(join(folder, name), 'utf8');

const scriptRules = [js.configs.recommended, {
  languageOptions: { sourceType: 'script', ecmaVersion: 2022, globals: globals.browser },
  linterOptions: { reportUnusedDisableDirectives: 'error' },
  rules: {
    'eqeqeq': 'error', 'no-var': 'error', 'prefer-const': 'error', 'no-use-before-define': ['error', { functions: false, variables: false }],
    'no-eval': 'error', 'no-implied-eval': 'error', 'no-throw-literal': 'error',
    'no-restricted-globals': ['error', ...forbidden],
    'no-restricted-properties': ['error', { property: 'innerHTML' }, { property: 'outerHTML' }, { property: 'insertAdjacentHTML' }],
    'max-lines-per-function': ['error', 50], 'complexity': ['error', 15],
  },
}];
// Only what every browser of the last two and a half years knows. The colours are variables that html.cpp writes.
const styleRules = [{ plugins: { css }, language: 'css/css', rules: {
  'css/no-duplicate-imports': 'error', 'css/no-empty-blocks': 'error', 'css/no-invalid-at-rules': 'error',
  'css/no-invalid-properties': ['error', { allowUnknownVariables: true }], 'css/use-baseline': ['error', { available: 'widely' }],
} }];

/** The scripts as one text, and for each line of it the file and line it comes from. */
function joined(names) {
  const lines = [], places = [];
  names.forEach((name, i) => {
    if (i > 0) { lines.push(''); places.push({ name, line: 0 }); }
    text(name).replace(/\n$/, '').split('\n').forEach((line, k) => { lines.push(line); places.push({ name, line: k + 1 }); });
  });
  return { code: lines.join('\n') + '\n', places };
}

function tell(messages, placeOf) {
  for (const m of messages) {
    const place = placeOf(m.line ?? 1);
    console.log(`${join(folder, place.name)}:${place.line}:${m.column ?? 1}: ${m.message} (${m.ruleId ?? 'syntax'})`);
  }
  return messages.length;
}

const linter = new Linter({ configType: 'flat' });
const { code, places } = joined(text('scripts.txt').trim().split('\n'));
let found = tell(linter.verify(code, scriptRules, 'page.js'), line => places[line - 1] ?? places.at(-1));
for (const name of readdirSync(folder).filter(one => one.endsWith('.css'))) {
  const rules = styleRules.map(rule => ({ files: ['**/*.css'], ...rule }));
  found += tell(linter.verify(text(name), rules, name), line => ({ name, line }));
}
console.log(found === 0 ? `${folder}: no findings` : `${folder}: ${found} findings`);
process.exit(found === 0 ? 0 : 1);
