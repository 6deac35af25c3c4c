// ---- Before and after an operation: the stock when it begins and when it has ended, under the same camera; or both at once, parted by a curtain.
/** `operation`: whose change is shown; `grid`: the heights before it; `share`: of the stage's width that lies left of the curtain. @type {{ shown: ChangeShown, operation: number, grid: Grid | null, share: number }} */
const change = {
  shown: 'none',
  operation: -1,
  grid: null,
  share: 0.5
};
const changeButtons = [...by('change').querySelectorAll('button')];
/** Of the heights before the operation; null: not made yet. @type {Surface | null} */
let surfaceBefore = null;

/** The operation that was chosen, else the one whose change is shown already, else the one under way. */
function operationOfChange() {
  if (filters.operation >= 0) return filters.operation;
  if (change.shown !== 'none') return change.operation;
  return moves.section[Math.max(0, shownMove())] ?? 0;
}

/** The heights of this moment, kept. @type {() => Grid} */
const keptGrid = () =>
  ({...whole, heights: heights.slice(), dirty: everything(whole), soiled: everything(whole), relief: newCanvas(whole), rests: null});

/** @type {(shown_: ChangeShown) => void} */
function showChange(shown_) {
  if (count === 0) return;
  const operation = operationOfChange();
  play(false);
  unmark();
  selected = -1;
  if (shown_ !== 'after') goTo(sectionTime(operation));
  const grid_ = shown_ === 'both' ? keptGrid() : null;
  if (shown_ !== 'before') goTo(sectionEnd(operation));
  Object.assign(change, {shown: shown_, operation, grid: grid_});
  writeChange();
  redraw();
}

/** Any other moment is none of the operation's two. */
function leaveChange() {
  if (change.shown === 'none') return;
  Object.assign(change, {shown: 'none', grid: null});
  writeChange();
}

function writeChange() {
  for (const button of changeButtons) button.setAttribute('aria-pressed', String(button.dataset.change === change.shown));
  by('change-note').hidden = change.shown === 'none';
  by('curtain').hidden = change.shown !== 'both';
  const name = change.operation < 0 ? '' : operationName(change.operation);
  by('change-note').textContent =
    {none: '', before: 'Before ' + name, after: 'After ' + name, both: 'Left of the line before, right of it after ' + name}[change.shown];
  soilAll();
}

/** To and fro, for the eye to see what has changed. */
const blinkChange = () => showChange(change.shown === 'after' ? 'before' : 'after');

/** x of the curtain on the stage, pixels; where there is none, 0: all is after. */
const curtainAt = () => change.grid ? change.share * view.w : 0;
/** The grid that is seen at a point of the stage. @type {(s: Point) => Grid} */
const gridAt = s => change.grid && s.x < curtainAt() ? change.grid : gridInSight();

/** The surface of the heights before the operation; one of another operation is given back. @type {(grid_: Grid) => Surface} */
function surfaceOfBefore(grid_) {
  if (surfaceBefore && surfaceBefore.grid !== grid_) {
    giveBack(surfaceBefore);
    surfaceBefore = null;
  }
  surfaceBefore ??= surfaceOf(grid_, {heights: 5, rests: 6});
  return surfaceBefore;
}

/** Draws twice where there is a curtain, each side by itself. @type {(w: number, h: number, draw: (isBefore: boolean) => void) => void} */
function drawSides(w, h, draw) {
  if (!change.grid) {
    draw(false);
    return;
  }
  const x = Math.round(change.share * w);
  gl.enable(gl.SCISSOR_TEST);
  gl.scissor(0, 0, x, h);
  draw(true);
  gl.scissor(x, 0, w - x, h);
  draw(false);
  gl.disable(gl.SCISSOR_TEST);
}

/** Likewise in the flat picture. @type {(c: Context2D) => void} */
function drawReliefs(c) {
  const fine = gridInSight();
  shade(fine);
  drawWorldPicture(c, fine.relief, fine);
  if (!change.grid) return;
  shade(change.grid);
  c.save();
  c.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
  c.clearRect(0, 0, curtainAt(), view.h);
  c.beginPath();
  c.rect(0, 0, curtainAt(), view.h);
  c.clip();
  drawWorldPicture(c, change.grid.relief, change.grid);
  c.restore();
}

/** The line of the curtain. @type {(c: Context2D) => void} */
function drawCurtain(c) {
  if (!change.grid) return;
  c.save();
  c.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
  c.fillStyle = css('ink');
  c.fillRect(curtainAt() - 1, 0, 2, view.h);
  c.restore();
}

function listenToChange() {
  for (const button of changeButtons) button.onclick = () => showChange(/** @type {ChangeShown} */ (button.dataset.change));
  by('curtain').oninput = () => {
    change.share = Number(by('curtain').value) / 1000;
    redrawSoon();
  };
}
