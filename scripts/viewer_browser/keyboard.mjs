// The page by the keyboard alone: what Tab reaches, whether it is seen where one is, and whether the place is kept.
import {check} from './browser.mjs';

/** @typedef {import('playwright-core').Page} Page */

const MOST = 500;  // stops, those of reports in frames among them

/** Where the focus is: whether that is seen, and whether it is at the end of the page. @type {(page: Page) => Promise<{ name: string, seen: boolean, end: boolean }>} */
const stopOf = page => page.evaluate(() => {
  const one = document.activeElement;
  if (!one || one === document.body) return {name: '', seen: true, end: true};
  const style = getComputedStyle(one.closest('.choose') ?? one), again = one.hasAttribute('data-reached') && one.tagName !== 'IFRAME';
  one.setAttribute('data-reached', '');
  // Inside a frame the report shows where one is.
  return {
    name: one.id || one.getAttribute('aria-label') || one.tagName,
    seen: one.tagName === 'IFRAME' || style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2,
    end: again
  };
});

/** Presses Tab from the element that the selector finds, if there is one, to the end of the page. @type {(page: Page, what: string, from?: string) => Promise<void>} */
export async function walksByTab(page, what, from = '[role=tab][aria-selected=true]') {
  await page.evaluate(() => {
    for (const one of document.querySelectorAll('[data-reached]')) one.removeAttribute('data-reached');
  });
  if (from) await page.focus(from);
  /** @type {string[]} */
  const unseen = [];
  let stops = 0;
  for (; stops < MOST; ++stops) {
    await page.keyboard.press('Tab');
    const {name, seen, end} = await stopOf(page);
    if (end) break;
    if (!seen) unseen.push(name);
  }
  const missed =
    await page.evaluate(() => [...document.querySelectorAll('main :is(button, select, input, a, summary)')]
                                .filter(one => one instanceof HTMLElement && one.offsetParent &&
                                    !one.closest('details:not([open]) > :not(summary)') && !one.matches(':disabled, [data-reached]'))
                                .map(one => one.id || one.getAttribute('aria-label') || one.textContent));
  check(stops > 3 && stops < MOST && missed.length === 0, `${what}: Tab reaches everything in ${stops} stops ${missed.join(', ')}`);
  check(unseen.length === 0, `${what}: where one is is seen ${unseen.join(', ')}`);
}

/** What has the focus. @type {(page: Page) => Promise<string>} */
export const focused = page => page.evaluate(() => document.activeElement?.getAttribute('aria-label') || document.activeElement?.id || '');

/** A list of files is used without losing the place. @type {(page: Page, first: string, second: string) => Promise<void>} */
export async function keepsItsPlace(page, first, second) {
  await page.focus(`[aria-label="What ${second} is"]`);
  await page.keyboard.press('ArrowUp');
  check(await focused(page) === `What ${second} is`, 'a file whose use was changed keeps the focus');
  await page.focus(`[aria-label="Remove ${first}"]`);
  await page.keyboard.press('Enter');
  check(await focused(page) === `Remove ${second}`, 'after a file was removed the next one has it');
  await page.keyboard.press('Enter');
  check((await focused(page)).endsWith('-files'), 'and after the last one the choice of files');
}
