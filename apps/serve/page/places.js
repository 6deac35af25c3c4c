// Tabs and clamps in the drawing: tabs are dragged along their profile, clamps are drawn as boxes and dragged; by the keyboard arrows move
// what has the focus, Delete takes it away.

const tabOption = '--tab-at', clampOption = '--keep-out';
const clampHeight = 20;  // mm above the material, of a clamp that was drawn

/** What lies at the zero of the program, in the drawing, mm; null: it follows from the stock, which the page does not know. @type {(answers: Record<string, string[]>) => Place2 | null} */
function zeroInDrawing(answers) {
  const said = answers['--origin']?.[0];
  if (!said) return {x: 0, y: 0};
  const [x, y] = said.split(',').map(Number);
  return Number.isFinite(x) && Number.isFinite(y) ? {x, y} : null;
}

/** "X,Y" of the program as a place in the drawing, and back. @type {(text: string, zero: Place2) => Place2} */
function placeOfText(text, zero) {
  const [x, y] = text.split(',').map(Number);
  return {x: x + zero.x, y: y + zero.y};
}
/** @type {(place: Place2, zero: Place2) => string} */
const textOfPlace = ({x, y}, zero) => `${round(x - zero.x, 2)},${round(y - zero.y, 2)}`;

/** "LOW:HIGH,LOW:HIGH,LOW:HIGH" as a box in the drawing; null: it is none. @type {(text: string, zero: Place2) => Clamp | null} */
function clampOfText(text, zero) {
  const [x, y, z] = text.split(',').map(range => range.split(':').map(Number));
  if (![x, y, z].every(range => range?.length === 2 && range.every(Number.isFinite))) return null;
  return {x: [x[0] + zero.x, x[1] + zero.x], y: [y[0] + zero.y, y[1] + zero.y], z: [z[0], z[1]]};
}
/** @type {(clamp: Clamp, zero: Place2) => string} */
const textOfClamp = ({x, y, z}, zero) => [x.map(value => value - zero.x), y.map(value => value - zero.y), z]
                                           .map(range => range.map(value => round(value, 2)).join(':'))
                                           .join(',');

/** The profiles of the drawing as curves that can be measured. @type {() => SVGPathElement[]} */
const profileCurves = () => [...element('drawing-curves').querySelectorAll('path')].filter(curve => {
  const outline = part.outlines[Number(curve.getAttribute('data-index'))];
  return outline && ['profile', 'inside'].includes(roleNow(outline));
});

const samples = 400;  // places along a profile that are compared
/** The place on a profile that is nearest, and how far along it lies. @type {(at: Place2, curves: SVGPathElement[]) => OnProfile | null} */
function nearestOnProfile(at, curves) {
  /** @type {OnProfile | null} */
  let best = null;
  for (const curve of curves) {
    const length = curve.getTotalLength();
    for (let k = 0; k < samples; ++k) {
      const along = length * k / samples, {x, y} = curve.getPointAtLength(along), away = Math.hypot(x - at.x, y - at.y);
      if (!best || away < best.away) best = {curve, along, x, y, away};
    }
  }
  return best;
}

const straightFor = 5;  // mm on either side of a tab
/** Whether a profile is straight about a place: corners hold no tabs. @type {(curve: SVGPathElement, along: number) => boolean} */
function isStraightAt(curve, along) {
  const length = curve.getTotalLength(), at = (/** @type {number} */ s) => curve.getPointAtLength((s + length) % length);
  const a = at(along - straightFor), b = at(along), c = at(along + straightFor);
  return Math.abs((c.x - a.x) * (b.y - a.y) - (c.y - a.y) * (b.x - a.x)) < 0.05 * Math.hypot(c.x - a.x, c.y - a.y);
}

/** So many places along a profile, evenly, each moved on to where it is straight. @type {(curve: SVGPathElement, count: number) => Place2[]} */
function evenPlaces(curve, count) {
  const length = curve.getTotalLength(), step = length / 200;
  return [...Array(count).keys()].map(k => {
    let along = length * (k + 0.5) / count;
    for (let tries = 0; tries < 200 / count && !isStraightAt(curve, along); ++tries) along = (along + step) % length;
    const {x, y} = curve.getPointAtLength(along);
    return {x, y};
  });
}

/** @type {(name: string, k: number, text: string | null) => void} */
function changeMark(name, k, text) {
  const values = [...(project.now.answers[name] ?? [])];
  values.splice(k, 1, ...text === null ? [] : [text]);
  answer(name, values.length > 0 ? values : null);
}

/** Follows the pointer from a press on a mark to its end. @type {(mark: SVGElement, moved: (at: Place2, from: Place2) => void, ended: () => void) => void} */
function followsPointer(mark, moved, ended) {
  mark.addEventListener('pointerdown', event => {
    const from = placeInDrawing(event);
    if (!from) return;
    event.preventDefault();
    mark.focus();
    mark.setPointerCapture(event.pointerId);
    mark.onpointermove = move => {
      const at = placeInDrawing(move);
      if (at) moved({x: at[0], y: at[1]}, {x: from[0], y: from[1]});
    };
    mark.onpointerup = mark.onpointercancel = () => {
      mark.onpointermove = mark.onpointerup = mark.onpointercancel = null;
      ended();
    };
  });
}

/** Steps of the arrow keys. @type {Record<string, [number, number]>} */
const markSteps = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1]
};

/** @type {(mark: SVGElement, name: string, k: number, step: (dx: number, dy: number) => string) => void} */
function heedsKeys(mark, name, k, step) {
  mark.addEventListener('keydown', event => {
    const by = markSteps[event.key], isRemoved = event.key === 'Delete' || event.key === 'Backspace';
    if (!by && !isRemoved) return;
    event.preventDefault();
    changeMark(name, k, isRemoved ? null : step(...by));
    document.getElementById(`mark${name}-${k}`)?.focus();
  });
}

/** @type {(text: string, k: number, zero: Place2) => SVGElement} */
function tabMark(text, k, zero) {
  const at = placeOfText(text, zero), size = 7 / pixelsPerMm();
  const mark = madeSvg('circle', {
    'id': `mark${tabOption}-${k}`,
    'class': 'tab-mark',
    'cx': at.x,
    'cy': at.y,
    'r': size,
    'tabindex': '0',
    'role': 'button',
    'aria-label': `Tab ${k + 1}: drag it along the profile, arrows move it, Delete takes it away`
  });
  /** @type {OnProfile | null} */
  let on = null;
  followsPointer(mark,
    to => {
      on = nearestOnProfile(to, profileCurves());
      if (!on) return;
      mark.setAttribute('cx', String(on.x));
      mark.setAttribute('cy', String(on.y));
    },
    () => {
      if (on) changeMark(tabOption, k, textOfPlace(on, zero));
    });
  heedsKeys(mark, tabOption, k, (dx, dy) => {
    const here = nearestOnProfile(at, profileCurves());
    if (!here) return text;
    const length = here.curve.getTotalLength(), {x, y} = here.curve.getPointAtLength((here.along + dx + dy + length) % length);
    return textOfPlace({x, y}, zero);
  });
  return mark;
}

/** @type {(clamp: Clamp, k: number, zero: Place2) => SVGElement} */
function clampMark(clamp, k, zero) {
  const mark = madeSvg('rect', {
    'id': `mark${clampOption}-${k}`,
    'class': 'clamp-mark',
    'x': clamp.x[0],
    'y': clamp.y[0],
    'width': clamp.x[1] - clamp.x[0],
    'height': clamp.y[1] - clamp.y[0],
    'tabindex': '0',
    'role': 'button',
    'aria-label': `Clamp ${k + 1}: drag it, arrows move it, Delete takes it away`
  });
  const movedBy = (/** @type {number} */ dx, /** @type {number} */ dy) => ({
    ...clamp,
    x: /** @type {[number, number]} */ ([clamp.x[0] + dx, clamp.x[1] + dx]),
    y: /** @type {[number, number]} */ ([clamp.y[0] + dy, clamp.y[1] + dy])
  });
  let now = clamp;
  followsPointer(mark,
    (at, from) => {
      now = movedBy(at.x - from.x, at.y - from.y);
      mark.setAttribute('x', String(now.x[0]));
      mark.setAttribute('y', String(now.y[0]));
    },
    () => {
      if (now !== clamp) changeMark(clampOption, k, textOfClamp(now, zero));
    });
  heedsKeys(mark, clampOption, k, (dx, dy) => textOfClamp(movedBy(dx, dy), zero));
  return mark;
}

/** @type {() => number} */
const pixelsPerMm = () => Math.abs(element('drawing-curves').getScreenCTM()?.a ?? 1) || 1;

/** Tabs and clamps as they are said. */
function showMarks() {
  const {answers} = project.now, zero = zeroInDrawing(answers), held = document.activeElement?.id ?? '';
  const tabs = zero ? (answers[tabOption] ?? []).map((text, k) => tabMark(text, k, zero)) : [];
  const clamps = zero ? (answers[clampOption] ?? []).flatMap((text, k) => {
    const clamp = clampOfText(text, zero);
    return clamp ? [clampMark(clamp, k, zero)] : [];
  }) :
                        [];
  element('drawing-marks').replaceChildren(...clamps, ...tabs);
  if (held.startsWith('mark--')) document.getElementById(held)?.focus();
}

/** The zero, or a word why places cannot be said. @type {() => Place2 | null} */
function zeroForPlaces() {
  const zero = zeroInDrawing(project.now.answers);
  if (!zero) say(element('plan-status'), 'Pick the zero in the drawing first: places count from it.', true);
  else if (part.outlines.length === 0) say(element('plan-status'), 'Places can be said in a drawing; this part is none.', true);
  return part.outlines.length > 0 ? zero : null;
}

/** Tabs evenly along all profiles, as marks that can be dragged; in place of a number of them. */
function placeTabs() {
  const zero = zeroForPlaces();
  if (!zero) return;
  showMiddle('drawing');
  const others = {...project.now.answers}, count = Number(others['--tabs']?.[0] ?? 4);
  delete others['--tabs'];
  delete others['--tab-spacing'];
  const places = profileCurves().flatMap(curve => evenPlaces(curve, count));
  if (places.length === 0) say(element('plan-status'), 'No outline is cut out: there is nothing that tabs would hold.', true);
  else change('', {answers: {...others, [tabOption]: places.map(place => textOfPlace(place, zero))}});
}

/** The next press in the drawing begins a clamp. @type {(isOn: boolean) => void} */
function drawClamp(isOn) {
  const zero = isOn ? zeroForPlaces() : null;
  element('clamp-draw').setAttribute('aria-pressed', String(Boolean(zero)));
  element('drawing').classList.toggle('picking', Boolean(zero));
  if (!zero) return;
  showMiddle('drawing');
  say(element('plan-status'), 'Draw the clamp as a box in the drawing.');
}

/** @type {(event: PointerEvent) => void} */
function beginClamp(event) {
  const from = placeInDrawing(event), zero = zeroInDrawing(project.now.answers), picture = element('drawing');
  if (!from || !zero || element('clamp-draw').getAttribute('aria-pressed') !== 'true') return;
  event.preventDefault();
  picture.setPointerCapture(event.pointerId);
  const box = madeSvg('rect', {class: 'clamp-mark'}), floor = Math.min(0, ...part.features.map(one => one.floor_z));
  element('drawing-marks').append(box);
  /** @type {Clamp | null} */
  let clamp = null;
  picture.onpointermove = move => {
    const at = placeInDrawing(move);
    if (!at) return;
    clamp = {
      x: [Math.min(from[0], at[0]), Math.max(from[0], at[0])],
      y: [Math.min(from[1], at[1]), Math.max(from[1], at[1])],
      z: [floor, clampHeight]
    };
    for (const [name, value] of Object.entries(
           {x: clamp.x[0], y: clamp.y[0], width: clamp.x[1] - clamp.x[0], height: clamp.y[1] - clamp.y[0]}))
      box.setAttribute(name, String(value));
  };
  picture.onpointerup = picture.onpointercancel = () => {
    picture.onpointermove = picture.onpointerup = picture.onpointercancel = null;
    drawClamp(false);
    box.remove();
    const isBox = clamp && clamp.x[1] > clamp.x[0] && clamp.y[1] > clamp.y[0];
    if (clamp && isBox) answer(clampOption, [...(project.now.answers[clampOption] ?? []), textOfClamp(clamp, zero)]);
  };
}

function setUpPlaces() {
  element('tabs-place').addEventListener('click', placeTabs);
  element('clamp-draw').addEventListener('click', () => drawClamp(element('clamp-draw').getAttribute('aria-pressed') !== 'true'));
  element('drawing').addEventListener('pointerdown', beginClamp);
}
