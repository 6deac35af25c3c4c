// What the tests of all pages share: a browser that reaches nothing but the page, what counts as a failure, and small questions to a page.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {chromium} from 'playwright-core';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').Frame} Frame */
/** @typedef {'light' | 'dark'} Scheme */

export const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

let failed = 0;
/** @type {(right: boolean, what: string) => void} */
export function check(right, what) {
  console.log((right ? 'ok      ' : 'FAILED  ') + what);
  if (!right) ++failed;
}

/** Tells how it went and ends. @type {(what: string) => void} */
export function conclude(what) {
  console.log(failed === 0 ? `${what}: all is well` : `${what}: ${failed} failed`);
  process.exit(failed === 0 ? 0 : 1);
}

/** @type {(executablePath: string, more?: string[]) => Promise<import('playwright-core').Browser>} */
export const launch = (executablePath, more = []) => chromium.launch({
  executablePath,
  args: [
    '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', ...more
  ]
});

/** Every error and every request elsewhere fails. @type {(page: Page, isOwn: (address: string) => boolean) => void} */
export function watch(page, isOwn) {
  page.on('pageerror', error => check(false, `no error: ${error.message}`));
  page.on('console', message => {
    if (message.type() === 'error') check(false, `no console error: ${message.text()}`);
  });
  page.on('request', request => {
    if (!isOwn(request.url())) check(false, `no other address: ${request.url()}`);
  });
}

/** @typedef {{ violations: { id: string, impact: string, nodes: { target: string[], html: string }[] }[] }} AxeFindings */

/** WCAG 2.2 AA, as far as axe sees it. @type {(page: Page, what: string) => Promise<void>} */
export async function isAccessible(page, what) {
  /** @type {AxeFindings} */
  const found =
    await page.evaluate(`${axe}; axe.run(document, { iframes: false, runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa'] })`);
  check(found.violations.length === 0,
    `${what}: no findings of axe ${found.violations.map(one => `${one.id} ${one.nodes[0].target}`).join(', ')}`);
}

/** @type {(page: Page) => Promise<boolean>} */
export const fits = page => page.evaluate('document.documentElement.scrollWidth <= innerWidth');

/** @type {(page: Page | Frame, selector: string) => Promise<string>} */
export const textOf = async (page, selector) => await page.textContent(selector) ?? '';

/** The page in the frame that the selector finds, ready to play. @type {(page: Page, selector: string) => Promise<Frame>} */
export async function reportIn(page, selector) {
  const frame = await (await page.waitForSelector(selector)).contentFrame();
  if (!frame) throw new Error(`${selector} is no frame`);
  await frame.waitForSelector('#play', {timeout: 60000});
  return frame;
}

/** Where an element lies on the page, pixels. @type {(page: Page, selector: string) => Promise<{ x: number, y: number, width: number, height: number }>} */
export async function boxOf(page, selector) {
  const box = await page.locator(selector).boundingBox();
  if (!box) throw new Error(`${selector} is not shown`);
  return box;
}

/** What a piece of the page's own script gives. @type {(page: Page, code: string) => Promise<boolean>} */
export const holds = (page, code) => page.evaluate(code);
/** @type {(page: Page, code: string) => Promise<number>} */
export const numberOf = (page, code) => page.evaluate(code);
/** @type {(page: Page, code: string) => Promise<number[]>} */
export const numbersOf = (page, code) => page.evaluate(code);
/** @type {(page: Page, code: string) => Promise<{ x: number, y: number }>} */
export const pointOf = (page, code) => page.evaluate(code);

/** Waits until a piece of the page's own script gives true, a minute at most; asked from outside, as the policy of a report forbids pages to evaluate texts. @type {(page: Page | Frame, code: string) => Promise<boolean>} */
export async function becomes(page, code) {
  for (let i = 0; i < 600; ++i) {
    if (await page.evaluate(code)) return true;
    await page.waitForTimeout(100);
  }
  return false;
}

/** The page that plans with nothing said, whatever this browser kept; every card is open. @type {(page: Page, address: string) => Promise<void>} */
export async function opensAnew(page, address) {
  await page.goto(address, {timeout: 60000});
  await page.waitForSelector('#option-post', {state: 'attached', timeout: 60000});
  await page.evaluate(
    'replaceProject(emptyProject()); document.querySelectorAll("#plan-form > details, #outlines-box").forEach(one => { one.open = true; })');
}

/** Says options of a plan besides those that are said; '': none are any more. @type {(page: Page, options: string) => Promise<void>} */
export async function saysOptions(page, options) {
  await page.evaluate(`{
    const said = optionsOf(${JSON.stringify(options)}), answers = {}, given = [], tools = [];
    for (const [name, values] of said) {
      if (name === '--tool') tools.push(...values.map(text => ({isOn: true, kind: text.split(':')[0], diameter: text.split(':').slice(1).join(':'), more: {}})));
      else if (name === '--op') given.push(...values.map(value => ({option: name, value})));
      else answers[name] = [...(answers[name] ?? []), ...values];
    }
    change('', {answers: said.length > 0 ? {...project.now.answers, ...answers} : {}, given, ...tools.length > 0 ? {tools, saysTools: true} : {}});
  }`);
}

/** Does something in the panel that "Show" opens over a report's picture, and closes it. @type {(page: Page | Frame, act: () => Promise<unknown>) => Promise<void>} */
export async function inPanel(page, act) {
  await page.evaluate('by("more-tools").open = true');
  await act();
  await page.evaluate('by("more-tools").open = false');
}
