// ---- Words.
const fixed = (v, n) => v === null || !isFinite(v) ? '?' : v.toFixed(n);
function clock(s) {
  if (s === null || !isFinite(s)) return '?';
  s = Math.round(s);
  const two = v => String(v).padStart(2, '0');
  const hours = Math.floor(s / 3600), minutes = Math.floor(s / 60) % 60;
  return (hours ? hours + ':' + two(minutes) : minutes) + ':' + two(s % 60);
}
function element(name, text, parent, type) {
  const e = document.createElement(name);
  if (text !== undefined) e.textContent = text;
  if (type) e.className = type;
  if (parent) parent.append(e);
  return e;
}

function writeHeader() {
  by('title').textContent = job.name;
  const faults = job.faults.length;
  by('verdict').textContent = job.clean ? 'certified clean' : faults ? 'faulty: ' + faults + (faults === 1 ? ' fault' : ' faults') : job.verdict.toLowerCase();
  by('verdict').style.background = css(job.clean ? 'good' : 'bad');
  const f = job.figures, has = kind => job.faults.some(fault => fault.kind === kind);
  for (const [figure, words, bad] of [[clock(f.time_s), 'machining time'], [fixed(f.feed_mm, 0) + ' mm', 'feed'],
    [fixed(f.rapid_mm, 0) + ' mm', 'rapid'], [f.retracts, 'retracts'],
    [fixed(f.uncut_thickness_mm, 4) + ' mm', 'left at most, proven', has('uncut')],
    [fixed(f.gouge_mm, 4) + ' mm', 'deepest gouge', has('gouge')],
    [f.rapid_in_material, 'rapids in material', f.rapid_in_material > 0], [fixed(f.max_deg, 0) + '\u00b0', 'largest engagement']]) {
    const tile = element('div', undefined, by('tiles'), bad ? 'bad' : '');
    element('b', figure, tile);
    tile.append(words);
  }
}

function sectionTime(s) { return moves.t[Math.min(job.sections[s].first, count)]; }
function sectionEnd(s) { return s + 1 < job.sections.length ? sectionTime(s + 1) : total; }
const shadeOf = feature => job.shades[Math.max(0, Math.min(255, Math.round(255 * (feature.floor - job.bottom) / depth)))];

function writeFeatures() {
  const head = element('tr', undefined, by('features'));
  for (const words of ['', 'floor z', 'time', 'left mm', '']) element('th', words, head);
  job.features.forEach((feature, i) => {
    const row = element('tr', undefined, by('features')), name = element('td', undefined, row);
    element('span', undefined, name, 'swatch').style.background = shadeOf(feature);
    name.append(feature.name);
    element('td', fixed(feature.floor, 2), row);
    element('td', clock(feature.time), row);
    element('td', fixed(feature.left, 4), row);
    element('span', undefined, element('td', undefined, row), 'dot ' + (feature.clean === null ? '' : feature.clean ? 'good' : 'bad-dot'));
    const s = job.sections.findIndex(section => section.feature === i);
    row.dataset.feature = i;
    if (s >= 0) {
      row.dataset.t = sectionTime(s);
      row.onclick = () => show(sectionTime(s) + 1e-3);
    }
  });
}

/** When a fault can be seen: at its line, else when its feature is done, else at the end. */
function timeOfFault(fault) {
  const i = fault.line > 0 ? moves.line.indexOf(fault.line) : -1;
  if (i >= 0) return moves.t[i + 1];
  for (let s = job.sections.length - 1; s >= 0; --s) {
    const feature = job.features[job.sections[s].feature];
    if (feature && feature.name === fault.feature) return sectionEnd(s);
  }
  return total;
}

function writeFaults() {
  by('faults-box').hidden = job.faults.length === 0;
  for (const fault of job.faults) {
    const item = element('li', undefined, by('faults'));
    element('b', fault.head, item);
    item.append((fault.feature ? ' in ' + fault.feature : '') + (fault.line ? ', line ' + fault.line : ''));
    element('div', fault.text, item);
    item.onclick = () => { marked = fault.x === null || fault.y === null ? null : fault; show(timeOfFault(fault)); };
  }
}

function writeTimeline() {
  job.sections.forEach((section, s) => {
    const piece = element('span', undefined, by('timeline')), feature = job.features[section.feature];
    piece.style.flex = Math.max(sectionEnd(s) - sectionTime(s), 0) + ' 0 0';
    piece.style.background = feature ? shadeOf(feature) : css('rule');
    piece.style.borderRight = '1px solid #fff';
    piece.title = section.label;
  });
  for (const fault of job.faults) element('i', undefined, by('timeline')).style.left = 100 * timeOfFault(fault) / (total || 1) + '%';
  by('timeline').onclick = event => {
    const box = by('timeline').getBoundingClientRect();
    show(total * (event.clientX - box.left) / box.width);
  };
}

const nowCells = {};
function writeNow() {
  for (const words of ['feature', 'tool', 'move', 'feed', 'position', 'line']) {
    const row = element('tr', undefined, by('now'));
    element('td', words, row);
    nowCells[words] = element('td', '', row);
  }
  by('code').hidden = job.program.length === 0;
}

function updateNow() {
  by('clock').textContent = clock(at.time) + ' / ' + clock(total);
  by('scrub').value = total > 0 ? Math.round(100000 * at.time / total) : 0;
  by('play').textContent = playing ? 'Pause' : 'Play';
  if (count === 0) return;
  const i = Math.min(at.move, count - 1), section = job.sections[moves.section[i]], tool = toolOf(i);
  const p = pointAt(i, at.move < count ? at.fraction : 1);
  nowCells.feature.textContent = section.label;
  nowCells.tool.textContent = tool ? tool.w : '?';
  nowCells.move.textContent = KINDS[moves.kind[i]] || '?';
  nowCells.feed.textContent = moves.feed[i] > 0 ? fixed(moves.feed[i], 0) + ' mm/min' : 'rapid';
  nowCells.position.textContent = 'x ' + fixed(p.x, 2) + '  y ' + fixed(p.y, 2) + '  z ' + fixed(p.z, 2);
  nowCells.line.textContent = moves.line[i] > 0 ? moves.line[i] : 'planned';
  for (const row of by('features').rows) row.classList.toggle('now', row.dataset.feature === String(section.feature));
  updateCode(moves.line[i]);
}

function updateCode(line) {
  if (job.program.length === 0) return;
  const around = 4, first = Math.max(1, Math.min(line - around, job.program.length - 2 * around));
  by('code').replaceChildren();
  for (let k = first; k <= Math.min(first + 2 * around, job.program.length); ++k) {
    const text = String(k).padStart(6) + '  ' + job.program[k - 1];
    if (k === line) element('b', text, by('code'));
    else by('code').append(text + '\n');
  }
}
