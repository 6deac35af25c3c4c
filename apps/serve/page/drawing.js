// The outlines of a drawing as a picture: what each is for, its number, and the way to its line in the list.

const svgSpace = 'http://www.w3.org/2000/svg';
const mostNumbers = 80;  // outlines that have their numbers beside them
const numberSize = 13;   // pixels

/** An element of a picture. @template {keyof SVGElementTagNameMap} Kind @param {Kind} kind @param {Record<string, string | number>} [attributes] @param {string} [text] @returns {SVGElementTagNameMap[Kind]} */
function madeSvg(kind, attributes = {}, text = '') {
  const one = document.createElementNS(svgSpace, kind);
  if (text) one.textContent = text;
  for (const [name, value] of Object.entries(attributes)) one.setAttribute(name, String(value));
  return one;
}

/** What lies around all outlines that can be drawn, mm; null: there are none. @type {(outlines: OutlineInfo[]) => Extent | null} */
function extentOfDrawing(outlines) {
  const extents = outlines.flatMap(one => one.path && one.extent_mm ? [one.extent_mm] : []);
  if (extents.length === 0) return null;
  const around = (/** @type {'x' | 'y'} */ axis) => /** @type {[number, number]} */ (
    [0, 1].map(end => extents.reduce((most, one) => (end ? Math.max : Math.min)(most, one[axis][end]), end ? -Infinity : Infinity)));
  return {x: around('x'), y: around('y')};
}

/** What an outline is for, as chosen or as read; 'unsaid': nothing says it. @type {(outline: OutlineInfo) => string} */
function roleNow(outline) { return project.now.outlines[outline.number]?.kind || (isOpen(outline) ? 'unsaid' : outline.role) || 'unsaid'; }

/** The curves of a drawing, the largest first, so that a click finds what lies in it. @type {(outlines: OutlineInfo[], roleOf: (one: OutlineInfo, index: number) => string) => SVGPathElement[]} */
function curvesOf(outlines, roleOf) {
  const drawn = outlines.map((one, index) => ({one, index})).filter(({one}) => one.path).sort((a, b) => b.one.area_mm2 - a.one.area_mm2);
  return drawn.map(({one, index}) => madeSvg('path', {'d': one.path ?? '', 'data-index': index, 'class': roleOf(one, index)}));
}

/** With a little room around it, y down. @type {(extent: Extent) => string} */
function viewBoxOf({x: [x0, x1], y: [y0, y1]}) {
  const edge = 0.04 * Math.max(x1 - x0, y1 - y0, 1e-3);
  return [x0 - edge, -y1 - edge, x1 - x0 + 2 * edge, y1 - y0 + 2 * edge].join(' ');
}

/** After something else was chosen. */
function colourDrawing() {
  let unsaid = 0;
  for (const curve of element('drawing-curves').children) {
    const index = Number(curve.getAttribute('data-index')), {number, layer} = part.outlines[index], role = roleNow(part.outlines[index]);
    curve.setAttribute('class', curve.classList.contains('marked') ? `${role} marked` : role);
    curve.setAttribute('tabindex', '0');
    curve.setAttribute('role', 'button');
    curve.setAttribute('aria-label', `Outline ${number}, layer ${layer}: ${role === 'unsaid' ? 'not said yet' : role}`);
    curve.replaceChildren(madeSvg('title', {}, `outline ${number}, layer ${layer}: ${role === 'unsaid' ? 'not said yet' : role}`));
    if (role === 'unsaid') ++unsaid;
  }
  element('drawing-unsaid').textContent =
    unsaid > 0 ? ` ${unsaid === 1 ? 'One outline is' : `${unsaid} outlines are`} not said yet, drawn in orange.` : '';
}

/** Numbers stay as large as the page's text, however large the drawing is. */
function sizeNumbers() {
  const picture = element('drawing'), box = picture.viewBox.baseVal,
        scale = Math.min(picture.clientWidth / (box?.width || 1), picture.clientHeight / (box?.height || 1));
  if (scale > 0) element('drawing-numbers').setAttribute('font-size', String(numberSize / scale));
}

const faintest = 0.12, strongest = 0.6;  // opacity of the shallowest and of the deepest floor

/**
 * What is cut of a part that no drawing shows, a solid or STEP-NC, deeper over shallower and darker.
 * @type {(features: FeatureInfo[], stock: StockInfo | null) => FloorDrawn[]}
 */
function floorsOf(features, stock) {
  const cut = features.filter(one => one.path).sort((a, b) => b.floor_z - a.floor_z), deepest = cut.at(-1)?.floor_z ?? 0;
  const top = Math.max(stock?.z_top ?? -Infinity, ...cut.map(one => one.top_z)), range = Math.max(top - deepest, 1e-9);
  return cut.map(one => ({
    path: one.path,
    opacity: round(faintest + (strongest - faintest) * (top - one.floor_z) / range, 3),
    title: `${one.name}, z ${round(one.top_z, 3)} to ${round(one.floor_z, 3)}`
  }));
}

/** @type {(floor: FloorDrawn) => SVGPathElement} */
function floorDrawn({path, opacity, title}) {
  const floor = madeSvg('path', {'class': 'floor', 'd': path, 'fill-rule': 'evenodd'});
  floor.style.fillOpacity = String(opacity);
  floor.append(madeSvg('title', {}, title));
  return floor;
}

/** The block that is milled. @type {(stock: StockInfo) => SVGPathElement} */
function stockDrawn({extent_mm: {x, y}}) { return madeSvg('path', {'class': 'stock', 'd': `M${x[0]} ${y[0]}H${x[1]}V${y[1]}H${x[0]}Z`}); }

/** The part as it is read, where no drawing shows it; of a job of several set-ups the parts lie differently. @type {() => Extent | null} */
function showFloors() {
  const isShown = part.outlines.length === 0 && !part.isOfSetups && part.features.some(one => one.path);
  element('drawing-floors')
    .replaceChildren(
      ...isShown ? [...part.stock ? [stockDrawn(part.stock)] : [], ...floorsOf(part.features, part.stock).map(floorDrawn)] : []);
  element('drawing-caption').hidden = isShown;
  element('floors-caption').hidden = !isShown;
  if (!isShown) return null;
  const extents = [...part.features, ...part.stock ? [part.stock] : []].flatMap(one => one.extent_mm ? [one.extent_mm] : []);
  const around = (/** @type {'x' | 'y'} */ axis) =>
    /** @type {[number, number]} */ ([0, 1].map(end => (end ? Math.max : Math.min)(...extents.map(one => one[axis][end]))));
  return {x: around('x'), y: around('y')};
}

/** Draws the outlines that were read, or else what is cut of the part. */
function showDrawing() {
  const outlines = part.outlines, extent = extentOfDrawing(outlines) ?? showFloors();
  if (outlines.length > 0) showFloors();
  element('drawing-box').hidden = !extent;
  element('drawing-curves').replaceChildren();
  element('drawing-numbers').replaceChildren();
  if (!extent) return;
  element('drawing').setAttribute('viewBox', viewBoxOf(extent));
  element('drawing-size').textContent = sizeOfDrawing(outlines);
  const curves = curvesOf(outlines, roleNow);
  element('drawing-curves').replaceChildren(...curves);
  if (curves.length <= mostNumbers)
    element('drawing-numbers').replaceChildren(...numbersOfOutlines(outlines.filter(one => one.path)).map(numberAt));
  colourDrawing();
  sizeNumbers();
  showMarks();
}

/**
 * Numbers with their places, y down: within a circle at its top, so that those of one middle have their own; else within the corner at the upper left.
 * Outlines on each other share one.
 * @type {(outlines: OutlineInfo[]) => NumberPlace[]}
 */
function numbersOfOutlines(outlines) {
  /** @type {Map<string, NumberPlace>} */
  const places = new Map();
  for (const {number, extent_mm, diameter_mm} of outlines) {
    const {x, y} = extent_mm ?? {x: [0, 0], y: [0, 0]}, isCircle = diameter_mm !== null;
    const place = {x: isCircle ? (x[0] + x[1]) / 2 : x[0], y: -y[1], isCircle, text: String(number)};
    const key = `${round(place.x, 3)} ${round(place.y, 3)}`, there = places.get(key);
    if (there) there.text += `, ${number}`;
    else places.set(key, place);
  }
  return [...places.values()];
}

/** @type {(place: NumberPlace) => SVGTextElement} */
const numberAt = ({x, y, isCircle, text}) =>
  madeSvg('text', {x, y, 'dx': isCircle ? '0' : '0.4em', 'dy': '1.1em', 'text-anchor': isCircle ? 'middle' : 'start'}, text);

/** @type {(target: EventTarget | null) => HTMLTableRowElement | undefined} */
const rowAround = target => target instanceof Element ? target.closest('tr') ?? undefined : undefined;

/** @type {(index: string | undefined) => void} */
function markOutline(index) {
  for (const curve of element('drawing-curves').children) curve.classList.toggle('marked', curve.getAttribute('data-index') === index);
}

function setUpDrawing() {
  const list = element('outlines');
  list.addEventListener('input', colourDrawing);
  for (const kind of ['focusin', 'mouseover']) list.addEventListener(kind, event => markOutline(rowAround(event.target)?.dataset.index));
  for (const kind of ['focusout', 'mouseleave']) list.addEventListener(kind, () => markOutline(undefined));
  new ResizeObserver(sizeNumbers).observe(element('drawing'));
}
