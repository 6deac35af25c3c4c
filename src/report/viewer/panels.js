// ---- Figures, verdict, features, the present move.
function writeHeader() {
  by('title').textContent = job.name;
  by('tiles').replaceChildren();
  const f = job.figures, has = (/** @type {string} */ kind) => job.faults.some(fault => fault.kind === kind);
  /** @type {[string | number, string, boolean?][]} */
  const figures = [
    [clock(f.time_s), 'machining time'], [lengthText(f.feed_mm, 0), 'feed'], [lengthText(f.rapid_mm, 0), 'rapid'], [f.retracts, 'retracts'],
    [job.asked ? lengthText(f.uncut_thickness_mm, 4) : 'not asked', 'left at most, proven', has('uncut')],
    [job.asked ? lengthText(f.gouge_mm, 4) : 'not asked', 'deepest gouge', has('gouge')],
    [f.rapid_in_material, 'rapids in material', f.rapid_in_material > 0], [fixed(f.max_deg, 0) + '\u00b0', 'largest engagement']
  ];
  if (f.percent_above_bound !== null)
    figures.push([fixed(f.percent_above_bound, 1) + ' %', 'longer than the shortest clearing possible, at most']);
  for (const [figure, words, bad] of figures) {
    const tile = element('div', undefined, by('tiles'), bad ? 'bad' : '');
    element('dt', words, tile);
    element('dd', figure, tile);
  }
}

/** @type {(n: number, word: string) => string} */
const counted = (n, word) => n + ' ' + word + (n === 1 ? '' : 's');

/** The verdict in one line, then what speaks against it and what it rests on. */
function writeVerdict() {
  const open = job.conditions.filter(condition => !condition.met_by).length, faults = job.faults.length;
  by('verdict').textContent = job.verdict;
  const [verdict] = job.verdict.split(' ');
  by('verdict').className = verdict.toLowerCase();
  by('faults').replaceChildren();
  by('conditions').replaceChildren();
  by('reason').textContent = verdict === 'CLEAN' && !job.asked ?
    'No fault. What is left and what is gouged was not asked: no part was stated.' :
    verdict === 'CLEAN'       ? 'Nothing is left beyond the tolerance, nothing gouged, no fault.' :
    verdict === 'CONDITIONAL' ? 'No fault, as long as ' + (open === 1 ? 'this condition holds:' : 'these ' + open + ' conditions hold:') :
    faults > 0                ? counted(faults, 'fault') + (open ? ', ' + counted(open, 'open condition') : '') + ':' :
                                'The figures are beyond the tolerances.';
  job.faults.forEach((fault, k) => {
    const button = listButton(by('faults'), sentence(fault.head),
      (fault.feature ? ' in ' + fault.feature : '') + (fault.line ? ', line ' + fault.line : ''), sentence(fault.text));
    button.onclick = () => goToFault(k);
  });
  for (const condition of [...job.conditions].sort((a, b) => (a.met_by ? 1 : 0) - (b.met_by ? 1 : 0))) {
    const words = (condition.line ? ', line ' + condition.line : '') + (condition.met_by ? ' (met: ' + condition.met_by + ')' : '');
    const button = listButton(by('conditions'), condition.name, words, sentence(condition.text));
    button.parentElement?.classList.toggle('met', condition.met_by !== '');
    if (condition.line > 0 && lineCount > 0)
      button.onclick = () => {
        play(false);
        goToLine(condition.line);
      };
    else button.disabled = true;
  }
}

/** @type {(list: HTMLElement, head: string, words: string, text: string) => HTMLButtonElement} */
function listButton(list, head, words, text) {
  const button = element('button', undefined, element('li', undefined, list), 'row');
  button.type = 'button';
  element('b', head, button);
  button.append(words, element('br'), text);
  return button;
}

/** @type {(fault: JobFault) => Place | null} */
const placeOfFault = ({x, y, z}) => x === null || y === null ? null : {x, y, z: z ?? 0};

/** @type {(k: number) => void} */
function goToFault(k) {
  const fault = job.faults[k], buttons = by('faults').querySelectorAll('button');
  play(false);
  marked = placeOfFault(fault);
  const i = fault.line > 0 ? moves.line.indexOf(fault.line) : -1;
  if (marked) bringIntoView(marked);
  if (i >= 0) selectMove(i, true);
  else show(timeOfFault(fault), true);
  buttons.forEach((button, n) => button.classList.toggle('chosen', n === k));
}

/** @type {(s: number) => number} */
function sectionTime(s) { return moves.t[Math.min(job.sections[s].first, count)]; }
/** @type {(s: number) => number} */
function sectionEnd(s) { return s + 1 < job.sections.length ? sectionTime(s + 1) : total; }
/** @type {(feature: JobFeature) => string} */
const shadeOf = feature => job.shades[Math.max(0, Math.min(255, Math.round(255 * (feature.floor - job.bottom) / depth)))];

function writeFeatures() {
  by('features').replaceChildren();
  by('features').hidden = by('features-title').hidden = job.features.length === 0;
  const head = element('tr', undefined, element('thead', undefined, by('features')));
  for (const words of ['feature', 'floor z', 'time', 'left ' + unit.name, 'clean']) element('th', words, head).scope = 'col';
  const body = element('tbody', undefined, by('features'));
  job.features.forEach((feature, i) => {
    const row = element('tr', undefined, body), name = element('td', undefined, row);
    const s = job.sections.findIndex(section => section.feature === i);
    const button = element('button', undefined, name, 'row');
    button.type = 'button';
    element('span', undefined, button, 'swatch').style.background = shadeOf(feature);
    button.append(feature.name);
    element('td', bare(feature.floor, 2), row);
    element('td', clock(feature.time), row);
    element('td', bare(feature.left, 4), row);
    element('td',
      feature.clean === null ? '?' :
        feature.clean        ? 'yes' :
                               'no',
      row,
      feature.clean === null ? '' :
        feature.clean        ? 'good' :
                               'bad');
    row.dataset.feature = String(i);
    button.disabled = s < 0;
    button.onclick = () => show(sectionTime(s) + 1e-3);
  });
}

/** When a fault can be seen: at its line, else when its feature is done, else at the end. @type {(fault: JobFault) => number} */
function timeOfFault(fault) {
  const i = fault.line > 0 ? moves.line.indexOf(fault.line) : -1;
  if (i >= 0) return moves.t[i + 1];
  for (let s = job.sections.length - 1; s >= 0; --s) {
    const feature = job.features[job.sections[s].feature];
    if (feature && feature.name === fault.feature) return sectionEnd(s);
  }
  return total;
}

const faultTimes = job.faults.map(timeOfFault), faultPlaces = job.faults.map(placeOfFault).filter(place => place !== null);

const timeMark = element('b');
function writeTimeline() {
  job.sections.forEach((section, s) => {
    const piece = element('span', undefined, by('timeline')), feature = job.features[section.feature];
    piece.style.flex = Math.max(sectionEnd(s) - sectionTime(s), 0) + ' 0 0';
    piece.style.background = feature ? shadeOf(feature) : css('rule');
    piece.style.borderRight = '1px solid ' + css('page');
    piece.title = section.label;
  });
  for (const time of faultTimes) element('i', undefined, by('timeline')).style.left = 100 * time / (total || 1) + '%';
  by('timeline').append(timeMark);
}

/** @type {Record<string, HTMLElement>} */
const nowCells = {};
function writeNow() {
  for (const words of ['feature', 'tool', 'move', 'feed', 'line', 'engaged', ...forces ? ['force'] : [], 'position']) {
    element('dt', words, by('now'));
    nowCells[words] = element('dd', '', by('now'), ['feature', 'tool', 'force', 'position'].includes(words) ? 'wide' : '');
  }
}

/** Programs of others name no operations. @type {(section: JobSection) => string} */
const nameOfSection = section => section.label || job.features[section.feature]?.name || 'not named';

function updateNow() {
  by('clock').textContent = clock(at.time) + ' / ' + clock(total);
  by('scrub').value = String(total > 0 ? Math.round(100000 * at.time / total) : 0);
  by('scrub').setAttribute('aria-valuetext', clock(at.time) + ' of ' + clock(total));
  by('play').textContent = playing ? 'Pause' : 'Play';
  timeMark.style.left = 100 * at.time / (total || 1) + '%';
  if (count === 0) return;
  const i = Math.max(0, shownMove()), section = job.sections[moves.section[i]], tool = toolOf(i), p = pointAt(i, shownFraction());
  nowCells.feature.textContent = nameOfSection(section);
  nowCells.tool.textContent = tool ? tool.w : '?';
  nowCells.move.textContent = KINDS[moves.kind[i]] || '?';
  nowCells.feed.textContent = feedText(moves.feed[i]);
  nowCells.position.textContent = 'x ' + bare(p.x, 3) + '  y ' + bare(p.y, 3) + '  z ' + lengthText(p.z, 3);
  nowCells.line.textContent = moves.line[i] > 0 ? String(moves.line[i]) : 'planned';
  nowCells.engaged.textContent = engagements ? 'up to ' + engagements[i] + '\u00b0' : 'not known';
  if (forces) nowCells.force.textContent = 'up to ' + forceText(forces[i]);
  for (const row of by('features').rows) row.classList.toggle('now', row.dataset.feature === String(section.feature));
  selectLine(moves.line[i]);
}
