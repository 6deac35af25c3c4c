// A menu beside an outline in the drawing: what it is for, and how deep.

/** What each kind means, in a few words. @type {Record<string, string>} */
const wordsOfKind = {
  pocket: 'Pocket',
  step: 'Step in a deeper pocket',
  profile: 'Cut out along the outside',
  inside: 'Cut out along the inside',
  drill: 'Hole',
  engrave: 'Engrave along it',
  tslot: 'T-slot',
  vcarve: 'V-carve',
  isolate: 'Isolate',
  chamfer: 'Chamfer the edge',
  face: 'Face',
  island: 'Island: stays',
  ignore: 'Leave out'
};

/** @type {(within: HTMLElement, focus: Element | null) => void} */
function closeMenu(within, focus) {
  within.hidden = true;
  within.replaceChildren();
  markOutline(undefined);
  if (focus instanceof HTMLElement || focus instanceof SVGElement) focus.focus();
}

/** Opens it beside an outline; `curve` has the focus again afterwards. @type {(index: number, curve: Element, at: { x: number, y: number }) => void} */
function openMenu(index, curve, at) {
  const menu = element('outline-menu'), outline = part.outlines[index], said = project.now.outlines[outline.number];
  const kind = made('select', '', {id: 'menu-kind'}), depth = made('input', '', {id: 'menu-depth', inputmode: 'decimal', size: '6'});
  kind.append(made('option', roleAsRead(outline), {value: ''}), ...outlineKinds.map(value => made('option', wordsOfKind[value], {value})));
  kind.value = said?.kind ?? '';
  depth.placeholder = outline.depth_mm === null ? '' : String(shownLength(outline.depth_mm, 3));
  depth.value = lengths.inch ? changedNumbers(said?.depth ?? '', mmToInch) : said?.depth ?? '';
  kind.addEventListener('change', () => changeOutline(outline.number, {kind: kind.value}, 'kind'));
  depth.addEventListener('change', () => changeOutline(outline.number, {depth: inMm(depth.value)}, 'depth'));
  const labels = [made('label', 'Is for '), made('label', `Depth, ${lengthName()} `)], done = made('button', 'Done', {type: 'button'});
  labels[0].append(kind);
  labels[1].append(depth);
  done.addEventListener('click', () => closeMenu(menu, curve));
  menu.replaceChildren(made('strong', `Outline ${outline.number}, ${outline.layer}, ${sizeOf(outline)}`), ...labels, done);
  menu.onkeydown = event => {
    if (event.key === 'Escape' || event.key === 'Enter' && event.target === depth) {
      event.preventDefault();
      depth.blur();
      closeMenu(menu, curve);
    }
  };
  menu.hidden = false;
  const box = element('drawing-box').getBoundingClientRect();
  menu.style.left = `${Math.max(0, Math.min(at.x - box.left + 8, box.width - menu.offsetWidth - 4))}px`;
  menu.style.top = `${Math.max(0, Math.min(at.y - box.top + 8, box.height - menu.offsetHeight - 4))}px`;
  markOutline(String(index));
  kind.focus();
}

/** Where a click in the drawing lies, mm. @type {(event: MouseEvent) => [number, number] | null} */
function placeInDrawing(event) {
  const matrix = element('drawing-curves').getScreenCTM();
  if (!matrix) return null;
  const {x, y} = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  return [round(x, 3), round(y, 3)];
}

/** Corners, middles and the places of holes, which a click near them means. @type {(at: [number, number], outlines: OutlineInfo[], reach: number) => [number, number]} */
function snapped(at, outlines, reach) {
  const places = outlines.flatMap(({extent_mm}) => {
    if (!extent_mm) return [];
    const {x, y} = extent_mm, xs = [x[0], (x[0] + x[1]) / 2, x[1]], ys = [y[0], (y[0] + y[1]) / 2, y[1]];
    return xs.flatMap(one => ys.map(other => /** @type {[number, number]} */ ([one, other])));
  });
  const away = (/** @type {[number, number]} */[x, y]) => Math.hypot(x - at[0], y - at[1]);
  const best = places.reduce((/** @type {[number, number] | null} */ near, one) => near && away(near) <= away(one) ? near : one, null);
  return best && away(best) <= reach ? [round(best[0], 4), round(best[1], 4)] : at;
}

/** The next click in the drawing is the program's zero. @type {(isOn: boolean) => void} */
function pickZero(isOn) {
  element('zero-pick').setAttribute('aria-pressed', String(isOn));
  element('drawing').classList.toggle('picking', isOn);
  if (!isOn) return;
  showMiddle('drawing');
  say(element('plan-status'), 'Click where the zero of the program is: a corner, a middle or a hole near the click is taken.');
}
const picksZero = () => element('zero-pick').getAttribute('aria-pressed') === 'true';

/** @type {(event: MouseEvent) => void} */
function takeZero(event) {
  const at = placeInDrawing(event), matrix = element('drawing-curves').getScreenCTM();
  if (!at || !matrix) return;
  const [x, y] = snapped(at, part.outlines, 12 / Math.abs(matrix.a));
  pickZero(false);
  answer('--origin', [`${x},${y},${project.now.answers['--top']?.[0] ?? '0'}`]);
}

function setUpMenu() {
  const curves = element('drawing-curves');
  element('zero-pick').addEventListener('click', () => pickZero(!picksZero()));
  element('drawing').addEventListener('click', event => {
    const curve = event.target instanceof Element ? event.target.closest('[data-index]') : null;
    if (picksZero()) takeZero(event);
    else if (curve) openMenu(Number(curve.getAttribute('data-index')), curve, {x: event.clientX, y: event.clientY});
    else closeMenu(element('outline-menu'), null);
  });
  curves.addEventListener('keydown', event => {
    const curve = event.target instanceof Element ? event.target.closest('[data-index]') : null;
    if (!curve || event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    const box = curve.getBoundingClientRect();
    openMenu(Number(curve.getAttribute('data-index')), curve, {x: box.left + box.width / 2, y: box.top + box.height / 2});
  });
}
