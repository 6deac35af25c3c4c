// node viewer_browser_test.mjs FOLDER BROWSER: what a person does with FOLDER/fishhead.html, and whether the page follows.
import {readFileSync, statSync, writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {axe, boxOf, check, conclude, holds, inPanel, isAccessible, launch, numberOf, numbersOf, pointOf, textOf, watch} from './browser.mjs';
import {walksByTab} from './keyboard.mjs';

/** @typedef {import('playwright-core').Page} Page */

const [folder, executablePath] = process.argv.slice(2).map(argument => resolve(argument));
const fishhead = folder + '/fishhead.html';
const browser = await launch(executablePath, ['--enable-unsafe-swiftshader']);

/** @type {(width: number, height: number, colorScheme: 'light' | 'dark', hash?: string, where?: import('playwright-core').Browser, file?: string) => Promise<Page>} */
async function open(width, height, colorScheme, hash = '', where = browser, file = fishhead) {
  const page = await where.newPage({viewport: {width, height}, colorScheme, reducedMotion: 'reduce'});
  watch(page, url => url.startsWith('file://'));
  await page.goto('file://' + file + hash, {timeout: 120000});
  return page;
}

/** @type {(page: Page) => Promise<number>} */
const selectedLine = page => page.$eval('#program [aria-selected=true]', row => Number(row.getAttribute('data-line'))).catch(() => 0);

/** @type {(page: Page) => Promise<void>} */
async function plays(page) {
  await page.keyboard.press(' ');
  await page.waitForFunction('at.time > 0', null, {timeout: 60000});
  await page.keyboard.press(' ');
  check(await textOf(page, '#play') === 'Play', 'space plays and stops');
  await page.keyboard.press('Home');
  for (let k = 0; k < 3; ++k) await page.keyboard.press('ArrowRight');
  check(await numberOf(page, 'shownMove()') === 2, 'three arrows are three moves');
  await page.keyboard.press('ArrowLeft');
  check(await numberOf(page, 'shownMove()') === 1, 'left arrow goes back');
}

/** @type {(page: Page) => Promise<void>} */
async function clicks(page) {
  await inPanel(page, () => page.selectOption('#path', 'all'));
  const i = await numberOf(page, 'moves.kind.findIndex((kind, i) => kind === 4 && moves.x1[i] - moves.x0[i] > 60)');
  const point = await pointOf(page,
    `(() => { const s = toScreen(pointAt(${
      i}, 0.4)), box = overlay.getBoundingClientRect(); return { x: s.x + box.left, y: s.y + box.top }; })()`);
  await page.mouse.click(point.x, point.y);
  const clicked = await numberOf(page, 'selected');
  check(clicked >= 0 && await selectedLine(page) === await numberOf(page, `moves.line[${clicked}]`), 'a click on a move selects its line');
  await page.$eval('#program', box => {
    box.scrollTop = 24 * 20;
  });
  await page.evaluate(
    'new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))');  // rows are used again as one scrolls
  await page.click('#program [data-line="30"]');
  check(await holds(page, 'selected === moveOfLine[30] && at.time === moves.t[selected + 1]'), 'a click on a line brings the cutter there');
  const before = await numberOf(page, 'view.k');
  await page.mouse.move(point.x, point.y);
  await page.mouse.wheel(0, -400);
  await page.waitForFunction(`view.k > ${before}`);
  await page.click('#fit');
  check(await holds(page, 'fitted'), 'wheel zooms, the button fits');
}

/** @type {(page: Page) => Promise<void>} */
async function chooses(page) {
  /** @type {string[]} */
  const colorings = await page.evaluate('Object.keys(COLORINGS)');
  for (const name of colorings) {
    await page.selectOption('#color-by', name);
    await page.screenshot({path: `${folder}/pictures/color-${name}.png`});
  }
  check(colorings.length === 5, 'five ways to colour');
  await page.selectOption('#unit', 'inch');
  check((await textOf(page, '#tiles')).includes(' in') || (await textOf(page, '#tiles')).includes('\u00a0in'), 'inches');
  await page.click('#measure');
  const box = await boxOf(page, '#overlay');
  await page.mouse.click(box.x + 300, box.y + 200);
  await page.mouse.click(box.x + 400, box.y + 200);
  const inches = parseFloat(await textOf(page, '#measured')), wanted = await numberOf(page, '100 / view.k / 25.4');
  check(Math.abs(inches - wanted) < 0.001, 'a distance is measured');
}

/** Going back gives the heights of a fresh page at that time, to the bit. @type {(page: Page) => Promise<void>} */
async function scrubs(page) {
  await holds(page, 'show(total * 0.9); show(total * 0.4); show(total * 0.6); show(total * 0.4)');
  const back = await numbersOf(page, 'Array.from(heights)'), fresh = await open(1366, 768, 'light');
  await holds(fresh, 'show(total * 0.4)');
  const wanted = await numbersOf(fresh, 'Array.from(heights)'), off = back.filter((v, k) => v !== wanted[k]).length;
  check(off === 0 && back.some(h => h < 0), `scrubbing back gives the heights of a fresh replay (${off} of ${back.length} cells differ)`);
  await fresh.close();
}

/** With square corners: round ones a browser blends with what lies around, not always alike. @type {(page: Page) => Promise<Buffer>} */
const stagePicture = async page => {
  await page.locator('#stage').evaluate(stage => {
    stage.style.borderRadius = '0';
  });
  await page.waitForFunction('!redrawAsked && detail.settled', null, {timeout: 60000});
  return page.locator('#stage').screenshot();
};
/** @type {(page: Page, a: Buffer, b: Buffer) => Promise<number>} */
const pixelsApart = (page, a, b) => page.evaluate(`(async () => {
  const data = async text => {
    const image = new Image(); image.src = 'data:image/png;base64,' + text; await image.decode();
    const canvas = document.createElement('canvas'); canvas.width = image.width; canvas.height = image.height;
    const c = canvas.getContext('2d'); c.drawImage(image, 0, 0);
    return c.getImageData(0, 0, image.width, image.height).data;
  };
  const p = await data('${a.toString('base64')}'), q = await data('${b.toString('base64')}');
  let n = 0;
  for (let k = 0; k < p.length; k += 4) if (Math.abs(p[k] - q[k]) + Math.abs(p[k + 1] - q[k + 1]) + Math.abs(p[k + 2] - q[k + 2]) > 0) ++n;
  return n;
})()`);

/** Orbit, pan, zoom, standard views, sections, a click, a distance. */
async function inSpace() {
  const page = await open(1366, 768, 'light', '#t=5000'), box = await boxOf(page, '#overlay'),
        middle = {x: box.x + box.width / 2, y: box.y + box.height / 2};
  check(await holds(page, 'space.on'), 'the page opens in space');
  await page.click('[data-view=front]');
  check(
    await holds(page, 'camera.yaw === 0 && camera.pitch === 0') && await page.getAttribute('[data-view=front]', 'aria-pressed') === 'true',
    'the front view');
  await page.click('[data-view=iso]');
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  await page.mouse.move(middle.x + 50, middle.y - 20, {steps: 4});
  await page.mouse.up();
  check(await holds(page, 'Math.abs(camera.yaw - 25) < 1e-6 && Math.abs(camera.pitch - 27.264) < 1e-6'), 'dragging turns the part');
  await page.keyboard.press('Shift+ArrowRight');
  check(await holds(page, 'Math.abs(camera.yaw - 40) < 1e-6'), 'so does Shift with an arrow');
  const before = await numberOf(page, 'camera.k');
  await page.mouse.wheel(0, -400);
  await page.waitForFunction(`camera.k > ${before}`);
  const place = await pointOf(page, 'projected({ x: 0, y: 0, z: 0 })');
  await page.keyboard.down('Shift');
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  await page.mouse.move(middle.x + 40, middle.y + 30, {steps: 3});
  await page.mouse.up();
  await page.keyboard.up('Shift');
  const moved = await pointOf(page, 'projected({ x: 0, y: 0, z: 0 })');
  check(Math.abs(moved.x - place.x - 40) < 0.01 && Math.abs(moved.y - place.y - 30) < 0.01, 'Shift with dragging moves it');
  await page.click('[data-view=iso]');
  await sections(page);
  await inPanel(page, () => page.selectOption('#path', 'all'));
  const i = await numberOf(page, 'moves.kind.findIndex((kind, i) => kind === 4 && moves.x1[i] - moves.x0[i] > 60)');
  const point =
    await pointOf(page, `(() => { const s = toScreen(pointAt(${i}, 0.4)); return { x: s.x + ${box.x}, y: s.y + ${box.y} }; })()`);
  await page.mouse.click(point.x, point.y);
  const clicked = await numberOf(page, 'selected');
  check(clicked >= 0 && await selectedLine(page) === await numberOf(page, `moves.line[${clicked}]`),
    'a click on a move in space selects its line');
  await page.click('[data-view=top]');
  await page.click('#measure');
  const a = await pointOf(page, 'projected({ x: 40, y: 60, z: 0 })'), b = await pointOf(page, 'projected({ x: 90, y: 60, z: 0 })');
  await page.mouse.click(box.x + a.x, box.y + a.y);
  await page.mouse.click(box.x + b.x, box.y + b.y);
  const words = await textOf(page, '#measured');
  check(/x 50\.0\d\d|x 49\.9\d\d/.test(words) && words.includes('z '), 'a distance in space: ' + words);
  await page.keyboard.press('Escape');
  await page.close();
}

/** @type {(page: Page) => Promise<void>} */
async function sections(page) {
  const whole = await stagePicture(page);
  for (const axis of ['x', 'y', 'z']) {
    await inPanel(page, () => page.selectOption('#section', axis));
    const cut = await stagePicture(page), apart = await pixelsApart(page, whole, cut);
    check(apart > 2000, `a section by ${axis} shows (${apart} pixels)`);
    await page.screenshot({path: `${folder}/pictures/section-${axis}.png`});
  }
  await inPanel(page, () => page.selectOption('#section', 'none'));
  check(await pixelsApart(page, whole, await stagePicture(page)) === 0, 'and without it all is as before');
}

/** What is seen after going back and forth is what a fresh page shows at that move. */
async function scrubsInSpace() {
  const used = await open(1366, 768, 'light'), fresh = await open(1366, 768, 'light');
  for (const share of [0.35, 0.7]) {
    await holds(used, `show(total * 0.95); show(total * 0.1); show(total * ${share} + 5); show(total * ${share})`);
    await holds(fresh, `show(total * ${share})`);
    const apart = await pixelsApart(fresh, await stagePicture(used), await stagePicture(fresh));
    check(apart === 0, `scrubbed both ways to ${share} it looks as a fresh replay does (${apart} pixels differ)`);
  }
  await used.close();
  await fresh.close();
}

/** Heights at a place of the grid that is in sight. @type {(page: Page, x: number, y: number) => Promise<number>} */
const heightAt = (page, x, y) =>
  numberOf(page, `(g => g.heights[Math.floor((g.y1 - ${y}) * g.scale) * g.width + Math.floor((${x} - g.x0) * g.scale)])(gridInSight())`);

/** A rib of 0.1 mm in a plate of 400 mm, narrower than a cell of the whole: seen where one zooms in, from whichever side the moment was reached. */
async function zoomsIn() {
  const used = await open(1366, 768, 'light', '#t=0', browser, folder + '/rib.html'),
        fresh = await open(1366, 768, 'light', '#t=0', browser, folder + '/rib.html');
  for (const [name, look] of [['above', 'view.x = 200; view.y = 103; view.k = 100; fitted = false'],
         ['iso', 'camera.x = 200; camera.y = 103; camera.z = 0; camera.k = 100; camera.fitted = false']]) {
    for (const page of [used, fresh]) await holds(page, `chooseView('${name}'); ${look}; by('path').value = 'none'; redraw()`);
    await holds(used, 'show(total)');
    const whole = await heightAt(used, 200, 103.05), atEnd = await stagePicture(used), fine = await heightAt(used, 200, 103.05);
    check(whole === -2 && fine === 0 && await heightAt(used, 200, 102.9) === -2 && await heightAt(used, 200, 103.2) === -2,
      `${name}: a rib of 0.1 mm, not seen in the whole (${whole}), is seen where one zooms in (${fine})`);
    await used.screenshot({path: `${folder}/pictures/rib-${name}.png`});
    await holds(used, 'show(total * 0.2)');
    check(await pixelsApart(used, atEnd, await stagePicture(used)) > 2000, `${name}: going back shows what was there before`);
    await holds(used, 'show(total * 0.7); show(total * 0.4)');
    await holds(fresh, 'show(total * 0.4)');
    check(await pixelsApart(fresh, await stagePicture(used), await stagePicture(fresh)) === 0,
      `${name}: zoomed in and scrubbed both ways it looks as a fresh replay does`);
  }
  await used.close();
  await fresh.close();
}

/** Of a rest operation: each alone, by turns, and both at once under one camera. */
async function beforeAndAfter() {
  const page = await open(1366, 768, 'light', '', browser, folder + '/rest.html');
  await inPanel(page, () => page.selectOption('#operation', {index: 2}));
  await inPanel(page, () => page.selectOption('#path', 'none'));
  await page.evaluate('drawCutter = drawTool = () => {}');  // which stands elsewhere before than after
  for (const view of ['iso', 'above']) {
    await page.click(`[data-view=${view}]`);
    /** @type {Record<string, Buffer>} */
    const seen = {};
    for (const name of ['before', 'after', 'both']) {
      await inPanel(page, () => page.click(`[data-change=${name}]`));
      seen[name] = await stagePicture(page);
      await page.screenshot({path: `${folder}/pictures/rest-${view}-${name}.png`});
    }
    check(await pixelsApart(page, seen.before, seen.after) > 100, `${view}: what the rest operation took is seen`);
    const [left, right, w] = await numbersOf(
      page, `(box => [Math.floor(curtainAt()) - 2, Math.ceil(curtainAt()) + 2, box.width])(overlay.getBoundingClientRect())`);
    const apart = await sidesApart(page, seen, left, right, w);
    check(apart[0] === 0 && apart[1] === 0,
      `${view}: left of the line is what was before, right of it what is after (${apart.join(' and ')} pixels differ)`);
  }
  await page.focus('#overlay');
  await page.keyboard.press('b');
  check(await holds(page, 'at.time === sectionEnd(1)') && await page.getAttribute('[data-change=after]', 'aria-pressed') === 'true',
    'b shows the stock after it');
  await page.keyboard.press('b');
  check(await holds(page, 'at.time === sectionTime(1)') && /^Before /.test(await textOf(page, '#change-note')),
    'and once more that before it: ' + await textOf(page, '#change-note'));
  await inPanel(page, () => page.click('[data-change=both]'));
  await page.focus('#curtain');
  await page.keyboard.press('ArrowLeft');
  check(await holds(page, 'change.share === 0.499'), 'the line is moved by keys');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Home');
  check(await page.isHidden('#curtain') && await page.isHidden('#change-note'), 'another moment ends it');
  await page.close();
}

/** Pixels by which both sides of a picture differ from those before and after; what stands over the stage is the same in all or left out. @type {(page: Page, seen: Record<string, Buffer>, left: number, right: number, w: number) => Promise<number[]>} */
const sidesApart = (page, seen, left, right, w) => page.evaluate(`(async () => {
  const data = async text => {
    const image = new Image(); image.src = 'data:image/png;base64,' + text; await image.decode();
    const canvas = document.createElement('canvas'); canvas.width = image.width; canvas.height = image.height;
    const c = canvas.getContext('2d'); c.drawImage(image, 0, 0);
    return c.getImageData(0, 0, image.width, image.height);
  };
  const [before, after, both] = [await data('${seen.before.toString('base64')}'), await data('${
  seen.after.toString('base64')}'), await data('${seen.both.toString('base64')}')], n = [0, 0];
  for (let y = 110; y < both.height - 90; ++y) for (let x = 2; x < ${w} - 60; ++x) {
    if (x > ${left} && x < ${right}) continue;
    const k = 4 * (y * both.width + x), other = x < ${left} ? before : after;
    if ([0, 1, 2].some(i => both.data[k + i] !== other.data[k + i])) ++n[x < ${left} ? 0 : 1];
  }
  return n;
})()`);

/** The whole page without a pointer: turned, zoomed, brought to a line, measuring ended. */
async function byKeyboard() {
  const page = await open(1366, 768, 'light', '#t=5000');
  await walksByTab(page, 'the report', '');
  await page.focus('#overlay');
  const before = await numbersOf(page, '[camera.yaw, camera.k]');
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('+');
  const after = await numbersOf(page, '[camera.yaw, camera.k]');
  check(before[0] !== after[0] && after[1] > before[1], 'keys turn the part and zoom');
  await page.keyboard.press('m');
  check(await page.getAttribute('#measure', 'aria-pressed') === 'true', 'm measures');
  await page.keyboard.press('Escape');
  check(await page.getAttribute('#measure', 'aria-pressed') === 'false', 'Escape ends it');
  await page.focus('#program');
  const line = await selectedLine(page);
  await page.keyboard.press('ArrowDown');
  check(await selectedLine(page) > line, 'arrows in the list bring the cutter to the next line');
  await page.close();
}

async function frames() {
  const page = await open(1280, 720, 'light', '#t=5000');
  const rate = await numberOf(page, `new Promise(done => { let n = 0; const from = performance.now();
    const step = now => { orbit(3, 0); if (++n < 90) requestAnimationFrame(step); else done(90000 / (now - from)); }; requestAnimationFrame(step); })`);
  console.log(`orbits with ${rate.toFixed(1)} frames/s in ${
    await holds(page, 'gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL)')}, detail ${
    await numberOf(page, 'detail.now')}`);
  check(rate > 2, 'the part turns');
  await page.close();
}

/** A pocket of a part without stock has a floor. */
async function withoutStock() {
  const page = await open(1366, 768, 'light', '#t=1e9', browser, folder + '/square.html');
  await holds(page, 'by(\'path\').value = \'none\'; redraw()');
  await stagePicture(page);
  check(await numberOf(page, `(() => { drawScene(DETAILS[1]); const s = projected({ x: 25, y: 25, z: -2 }), pixel = new Uint8Array(4);
    gl.readPixels(s.x * view.ratio, stageCanvas.height - s.y * view.ratio, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); return pixel[3]; })()`) ===
      255,
    'a pocket without stock has a floor');
  await page.close();
}

/** Hundreds of faults hide neither what they lie on nor what is written there, and the moment's feature has a name. */
async function manyFaults() {
  const page = await open(1366, 768, 'light', '', browser, folder + '/faulty.html');
  await stagePicture(page);
  check(await holds(page, 'job.faults.length > 200'), 'a program with more than 200 faults');
  const red = await numberOf(page, `(canvas => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height), bad = rgb(css('bad')).map(v => Math.round(255 * v));
    let n = 0;
    for (let k = 0; k < data.length; k += 4) if (bad.every((v, i) => Math.abs(data[k + i] - v) < 3)) ++n;
    return 4 * n / data.length;
  })(by('plot'))`);
  check(red > 0.005 && red < 0.1, `its faults are marked on the plot without hiding it (${(100 * red).toFixed(1)} % of it)`);
  check(await holds(page, 'by("timeline").querySelector("i").offsetHeight < by("timeline").offsetHeight / 2 + 1'),
    'and on the bar of features, which are still seen');
  const count = await page.locator('#faults button').count();
  await page.selectOption('#unit', 'inch');
  check(!/ mm\b/.test(await textOf(page, '#faults')) && / in\b/.test(await textOf(page, '#faults')) &&
      await page.locator('#faults button').count() === count,
    'their sentences are in inches where that is chosen');
  await page.selectOption('#unit', 'mm');
  check(await page.textContent('#now dd') === 'square', 'what is under way has the name of its feature');
  await page.screenshot({path: `${folder}/pictures/faulty.png`});
  for (const scheme of /** @type {const} */ (['light', 'dark'])) {
    await page.emulateMedia({colorScheme: scheme});
    await isAccessible(page, `a faulty program's page, ${scheme}`);
  }
  await page.close();
}

/** A program of a million lines, a spiral in chords: the page of the fishhead with other moves. */
function millionPage() {
  const n = 1e6, text = readFileSync(fishhead, 'utf8'), [whole, json] = /id="job">(.*?)<\/script>/s.exec(text) ?? [''],
        job = JSON.parse(json), x = [], y = [], program = [];
  let px = 67000, py = 92000;
  for (let i = 0; i < n; ++i) {
    const a = 0.01 * i, r = 10000 + 0.4 * (i % 1e5), qx = Math.round(67000 + r * Math.cos(a)), qy = Math.round(92000 + r * Math.sin(a));
    x.push(qx - px);
    y.push(qy - py);
    program.push(`X${qx / 1000} Y${qy / 1000}`);
    px = qx;
    py = qy;
  }
  Object.assign(job, {
    kinds: '4'.repeat(n),
    x,
    y,
    z: [-5000, ...Array(n - 1).fill(0)],
    t: Array(n).fill(100),
    line: Array(n).fill(1),
    starts: [[0, 67000, 92000, 0]],
    arcs: [],
    feeds: [[0, 800]],
    engagement: null,
    program,
    sections: [{label: 'spiral', feature: 0, tool: 1, first: 0}],
    faults: []
  });
  writeFileSync(`${folder}/million.html`, text.replace(whole, () => `id="job">${JSON.stringify(job)}</script>`));
}

async function aMillionLines() {
  millionPage();
  const page = await open(1280, 720, 'light', '#t=1', browser, folder + '/million.html');
  console.log('a million lines: opened in',
    await numberOf(page, 'Math.round(performance.timing.loadEventEnd - performance.timing.navigationStart)'), 'ms');
  await page.$eval('#program', box => {
    box.scrollTop = box.scrollHeight;
  });
  await page.waitForSelector('#program [data-line="1000000"]');
  check(await page.locator('#program [role=option]').count() < 60, 'only the lines in sight are elements');
  await page.click('#program [data-line="1000000"]', {timeout: 120000});
  check(await holds(page, 'at.time === total') && await selectedLine(page) === 1e6, 'the last line is reached by a click');
  await page.keyboard.press('ArrowUp');
  check(await selectedLine(page) === 999999, 'and the one before it by an arrow');
  await inPanel(page, () => page.selectOption('#path', 'all'));
  await stagePicture(page);
  check(await holds(page, 'pathLines.count > 1e5 && pathLines.count <= 3e5') && await page.isVisible('#path-note'),
    'the whole path is drawn in fewer lines, which is said: ' + await textOf(page, '#path-note'));
  await page.screenshot({path: `${folder}/pictures/million.png`});
  await page.close();
}

/** Names that every object of the language has are neither views nor faults. */
async function strangeAddresses() {
  for (const hash of ['#view=constructor', '#fault=length', '#fault=-1&line=x&t=y']) {
    const page = await open(1366, 768, 'light', hash);
    check(await holds(page, 'space.on && at.time === 0'), `opened at ${hash} it begins at the beginning`);
    await page.close();
  }
}

/** Where there is no WebGL the page says so and stays flat. */
async function withoutWebGl() {
  const flat = await launch(executablePath, ['--disable-3d-apis']), page = await open(1366, 768, 'light', '#t=3000', flat);
  check(!await holds(page, 'space.on') && (await textOf(page, '#space-note')).startsWith('No view in space: '),
    'without WebGL: ' + await textOf(page, '#space-note'));
  check(await page.isVisible('#space-note') && await page.isDisabled('[data-view=top]'), 'it is said on the stage');
  check(await holds(page, 'contextOf(whole.relief).getImageData(width / 2, height / 2, 1, 1).data[3] === 255'),
    'and the part is shown from above');
  await page.screenshot({path: `${folder}/pictures/without-webgl.png`});
  await flat.close();
}

/** @type {(width: number, height: number, scheme: 'light' | 'dark') => Promise<void>} */
async function looks(width, height, scheme) {
  const page = await open(width, height, scheme, '#t=5000'), name = `${width} ${scheme}`;
  await stagePicture(page);
  await page.screenshot({path: `${folder}/pictures/${width}-${scheme}.png`, fullPage: width < 500});
  check(await holds(page, 'document.documentElement.scrollWidth <= innerWidth'), name + ': nothing overflows sideways');
  check(await holds(page, 'by("play").getBoundingClientRect().bottom <= innerHeight'), name + ': play without scrolling');
  if (width >= 1366) {
    const seen = await holds(page, `['overlay', 'play', 'verdict', 'reason', 'plot'].every(id => {
      const box = by(id).getBoundingClientRect(); return box.height > 0 && box.top >= 0 && box.bottom <= innerHeight; })`);
    check(seen, name + ': part, play and verdict without scrolling');
  }
  const small = await numberOf(page,
    `[...document.querySelectorAll('body *')].filter(e => e.textContent.trim() && parseFloat(getComputedStyle(e).fontSize) < 12).length`);
  check(small === 0, name + ': no text under 12 px');
  await page.evaluate(axe);
  /** @type {import('./browser.mjs').AxeFindings} */
  const {violations} = await page.evaluate('axe.run()');
  const serious = violations.filter(one => ['serious', 'critical'].includes(one.impact));
  check(serious.length === 0, name + ': axe ' + serious.map(one => one.id + ' ' + one.nodes[0].html.slice(0, 120)).join('; '));
  await page.close();
}

const page = await open(1366, 768, 'light', '#view=above');
check(statSync(fishhead).size < 10e6, `the page has ${statSync(fishhead).size} bytes`);
console.log('opened in', await numberOf(page, 'Math.round(performance.timing.loadEventEnd - performance.timing.navigationStart)'), 'ms');
for (const part of [plays, clicks, chooses, scrubs]) await part(page);
await page.close();
for (const part of [inSpace, scrubsInSpace, zoomsIn, beforeAndAfter, withoutStock, manyFaults, byKeyboard, frames, aMillionLines,
       strangeAddresses, withoutWebGl])
  await part();
for (const [width, height] of [[390, 844], [1366, 768], [1920, 1080], [3840, 2160]]) {
  await looks(width, height, 'light');
  await looks(width, height, 'dark');
}
await browser.close();
conclude('the page in the browser');
