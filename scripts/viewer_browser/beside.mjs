// Strategies side by side, as a person looks at them on the page of the server and on the page without one.
import {check, fits, isAccessible} from './browser.mjs';
import {until} from './examples.mjs';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').Frame} Frame */

/** @type {(frame: Frame) => Promise<number[]>} */
const lookOf = frame => frame.evaluate('[camera.x, camera.y, camera.z, camera.k, camera.yaw, camera.pitch, at.time, total]');
const isNear = (/** @type {number} */ a, /** @type {number} */ b) => Math.abs(a - b) < 2e-4 * Math.max(1, Math.abs(b));

/** All have shown what they were told. @type {(page: Page) => Promise<void>} */
const atRest = page => until(page, 'beside.panes.length > 0 && beside.panes.every(pane => pane.total > 0 && !pane.isBusy)');

/** The frames of the reports, as they stand. @type {(page: Page) => Promise<Frame[]>} */
async function framesOf(page) {
  const found = await Promise.all((await page.$$('#beside-panes iframe')).map(frame => frame.contentFrame()));
  return found.filter(frame => frame !== null);
}

/** Waits until the looks are the same to their last digit. @type {(frames: Frame[]) => Promise<boolean>} */
async function lookAlike(frames) {
  for (let k = 0; k < 100; ++k) {
    const [first, ...others] = await Promise.all(frames.map(lookOf));
    if (others.every(look => look.slice(0, 6).every((value, i) => value === first[i]))) return true;
    await new Promise(soon => {
      setTimeout(soon, 100);
    });
  }
  return false;
}

/** After a comparison: what was ticked, planned and moved together. @type {(page: Page, picture: string) => Promise<void>} */
export async function showsBeside(page, picture) {
  check(await page.locator('#comparison input:checked').count() === 2, 'the fastest and another are ticked');
  await page.click('#beside-go');
  await page.waitForSelector('#beside:not([hidden])', {timeout: 240000});
  await atRest(page);
  const frames = await framesOf(page);
  check(frames.length === 2 && await lookAlike(frames), 'two strategies stand side by side and are seen alike');
  await frames[0].evaluate('orbit(30, -10); zoom(1.25)');
  check(await lookAlike(frames) && (await lookOf(frames[1]))[4] === 75, 'turned and zoomed in one they turn in both');
  await frames[1].evaluate(`by('section').value = 'x'; chooseSection(false)`);
  await until(frames[0], `section.axis === 'x'`);
  check(await page.isHidden('#plan-result') && !await frames[0].isVisible('#play') && await frames[0].isVisible('#color-by'),
    'each has its colours, the controls of the time are for all');
  await page.focus('#beside-scrub');
  await page.keyboard.press('Home');
  await atRest(page);
  check((await Promise.all(frames.map(lookOf))).every(look => look[6] === 0), 'Home is the beginning of both');
  await page.evaluate(() => {
    const scrub = document.getElementById('beside-scrub');
    if (scrub instanceof HTMLInputElement) {
      scrub.value = '40000';
      scrub.dispatchEvent(new Event('input'));
    }
  });
  await atRest(page);
  const looks = await Promise.all(frames.map(lookOf));
  check(looks.every(look => isNear(look[6], 0.4 * look[7])), 'both are at the same share of their time');
  await page.selectOption('#beside-by', 'clock');
  await atRest(page);
  const longest = Math.max(...looks.map(look => look[7]));
  check((await Promise.all(frames.map(lookOf))).every(look => isNear(look[6], Math.min(look[7], 0.4 * longest))),
    'or at the same time on the clock');
  await frames[1].evaluate('play(false); show(3)');
  await until(page, 'Math.abs(beside.share * longestBeside() - 3) < 1e-3');
  await atRest(page);
  check(isNear((await lookOf(frames[0]))[6], 3), 'a time chosen in one is that of both');
  await playsBeside(page, frames);
  await page.screenshot({path: picture});
  await isAccessible(page, 'the page with strategies side by side');
  check(await fits(page), 'nothing overflows with them');
}

/** @type {(page: Page, frames: Frame[]) => Promise<void>} */
async function playsBeside(page, frames) {
  await page.focus('#beside-play');
  await page.keyboard.press('Enter');
  await until(page, 'beside.share * longestBeside() > 4');
  await page.keyboard.press(' ');
  check(await page.textContent('#beside-play') === 'Play', 'Enter plays both, space stops them');
  await atRest(page);
  const [a, b] = await Promise.all(frames.map(lookOf));
  check(a[6] > 3.5 && isNear(a[6], b[6]), 'and they stand at the same time');
}
