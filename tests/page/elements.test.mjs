// The types of elements hold for the pages: every element that a page names is in its list, of its kind, and no other is.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {test} from 'node:test';
import {root} from './fake_page.mjs';

/** By the tags that they stand for; others are HTMLElement. @type {Record<string, string>} */
const kinds = {
  button: 'HTMLButtonElement',
  canvas: 'HTMLCanvasElement',
  datalist: 'HTMLDataListElement',
  details: 'HTMLDetailsElement',
  div: 'HTMLDivElement',
  dl: 'HTMLDListElement',
  form: 'HTMLFormElement',
  h1: 'HTMLHeadingElement',
  h2: 'HTMLHeadingElement',
  iframe: 'HTMLIFrameElement',
  img: 'HTMLImageElement',
  input: 'HTMLInputElement',
  label: 'HTMLLabelElement',
  ol: 'HTMLOListElement',
  output: 'HTMLOutputElement',
  p: 'HTMLParagraphElement',
  pre: 'HTMLPreElement',
  progress: 'HTMLProgressElement',
  select: 'HTMLSelectElement',
  span: 'HTMLSpanElement',
  table: 'HTMLTableElement',
  ul: 'HTMLUListElement',
  svg: 'SVGSVGElement',
  g: 'SVGGElement',
  path: 'SVGPathElement'
};

for (const [page, types] of [
       ['src/report/viewer/body.html', 'src/report/viewer/types.d.ts'], ['apps/serve/page/index.html', 'apps/serve/page/types.d.ts']]) {
  test(`elements of ${page}`, () => {
    const markup = fs.readFileSync(path.join(root, page), 'utf8'), text = fs.readFileSync(path.join(root, types), 'utf8');
    const listed = [...text.slice(text.indexOf('interface PageElements')).matchAll(/^ {2}'([\w-]+)': (\w+);$/gm)].map(
      ([, id, kind]) => `${id}: ${kind}`);
    const present = [...markup.matchAll(/<(\w+)\b[^>]*? id="([\w-]+)"/g)].map(([, tag, id]) => `${id}: ${kinds[tag] ?? 'HTMLElement'}`);
    assert.ok(present.length > 30);
    assert.deepEqual(listed, present);
  });
}
