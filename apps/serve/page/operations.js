// The operations in order: each what, how deep, with which tool, how. What is changed here becomes a job ([[operation]]) of the part.

/** Where a feature lies, whatever it is called: what was said of it holds after it was read anew. @type {(feature: FeatureInfo) => string} */
function placeOfFeature({kind, extent_mm}) {
  const {x, y} = extent_mm ?? {x: [0, 0], y: [0, 0]}, words = [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2, x[1] - x[0], y[1] - y[0]];
  return `${kind} ${words.map(value => value.toFixed(2)).join(' ')}`;
}

/** @type {(feature: FeatureInfo) => string} */
function sizeOfFeature({kind, extent_mm}) {
  if (!extent_mm) return '';
  const {x, y} = extent_mm, width = x[1] - x[0], height = y[1] - y[0];
  if (kind === 'round_hole') return `Ø ${shownLength(width, 2)}`;
  return kind === 'chamfer' ? '' : `${shownLength(width, 1)} × ${shownLength(height, 1)}`;
}

/** Kinds of one row of the list: holes, chamfers, engravings of one layer, size and depth. */
const kindsTogether = ['round_hole', 'chamfer', 'engraving', 'vcarving', 'v_carving'];

/** Features as operations in the reader's order, holes of one kind together; as the sequence says where there is one. @type {(features: FeatureInfo[], sequence: string[]) => OperationRow[]} */
function operationRows(features, sequence) {
  /** @type {Map<string, OperationRow>} */
  const rows = new Map();
  for (const feature of features) {
    const place = placeOfFeature(feature), {kind, source, top_z, floor_z} = feature;
    const together = kindsTogether.includes(kind) ? [kind, source, sizeOfFeature(feature), top_z, floor_z].join('|') : place,
          row = rows.get(together);
    if (row) row.features.push(feature);
    else rows.set(together, {key: place, kind, source: source ?? '', features: [feature]});
  }
  const at = (/** @type {OperationRow} */ row) => {
    const found = sequence.indexOf(row.key);
    return found < 0 ? sequence.length : found;
  };
  return [...rows.values()].sort((a, b) => at(a) - at(b));
}

/** "4 holes Ø 6". @type {(row: OperationRow) => string} */
function titleOfRow({kind, features}) {
  const outline = kind.endsWith('profile') ? outlineOfFeature(features[0], part.outlines) : undefined;
  const names =
    /** @type {Record<string, string>} */ (
      {round_hole: 'hole', closed_pocket: 'pocket', planar_face: 'face', outside_profile: 'cut-out', inside_profile: 'cut-out inside'});
  const one = names[kind] ?? kind.replaceAll('_', ' '), count = features.length;
  return `${count > 1 ? `${count} ${one}s` : one.replace(/^./, letter => letter.toUpperCase())} ${
    outline ? sizeOf(outline) : sizeOfFeature(features[0])}`
    .trim();
}

/** The outline that a feature was read from; of its layer the one whose size is nearest. @type {(feature: FeatureInfo, outlines: OutlineInfo[]) => OutlineInfo | undefined} */
function outlineOfFeature(feature, outlines) {
  const {extent_mm} = feature;
  if (!extent_mm) return undefined;
  const away = (/** @type {OutlineInfo} */ one) => {
    if (!one.extent_mm) return Infinity;
    const a = one.extent_mm, b = extent_mm;
    return Math.max(...[0, 1].flatMap(end => [Math.abs(a.x[end] - b.x[end]), Math.abs(a.y[end] - b.y[end])]));
  };
  const own = outlines.filter(one => one.role && !['island', 'ignore', 'stock'].includes(one.role) && one.layerNow === feature.source);
  return own.reduce((/** @type {OutlineInfo | undefined} */ best, one) => best && away(best) <= away(one) ? best : one, undefined);
}

/** What an operation of a job may say, by its key: the fields of a row. @type {(name: string) => string} */
const keyInJob = name => jobKeys[name]?.key ?? name.slice(2).replaceAll('-', '_');

/** The lines of a job for what was said of the operations. @type {(rows: OperationRow[], said: Record<string, OperationSaid>) => string} */
function operationTables(rows, said) {
  const tables = rows.flatMap(row => {
    const one = said[row.key];
    if (!one) return [];
    const lines = one.isOff ? ['skip = true'] : [
      ...(one.tool ? [`tool = ${one.tool}`] : []), ...Object.entries(one.answers).map(([name,
        [value]]) => `${keyInJob(name)} = ${jobKeys[name]?.number ? tomlValue(value) : tomlText(value)}`)
    ];
    return lines.length === 0 ? [] : row.features.map(({name}) => `[[operation]]\nfeature = ${tomlText(name)}\n${lines.join('\n')}\n`);
  });
  return tables.join('\n');
}

/** Names of features in the order of work; []: nobody has said it. @type {(rows: OperationRow[], sequence: string[]) => string[]} */
const namesInSequence = (rows, sequence) => sequence.length === 0 ? [] : rows.flatMap(row => row.features.map(one => one.name));

/** @type {(key: string, said: Partial<OperationSaid>, what: string) => void} */
function changeOperation(key, said, what) {
  const before = project.now.operations[key] ?? {isOff: false, tool: '', answers: {}}, next = {...before, ...said};
  const operations = {...project.now.operations, [key]: next};
  if (!next.isOff && !next.tool && Object.keys(next.answers).length === 0) delete operations[key];
  change(`operation ${key} ${what}`, {operations});
}

/** To another place in the order of work. @type {(key: string, to: number) => void} */
function moveOperation(key, to) {
  const keys = operationRows(part.features, project.now.sequence).map(row => row.key), from = keys.indexOf(key);
  if (from < 0 || to < 0 || to >= keys.length || to === from) return;
  keys.splice(from, 1);
  keys.splice(to, 0, key);
  change('', {sequence: keys});
}

/** The options that an operation may have. @type {CommandOption[]} */
let operationOptions = [];
const inRow = ['--strategy', '--feed', '--stepdown'];
/** Which rows have their rarer fields open. @type {Set<string>} */
const openOperations = new Set();

/** @type {(row: OperationRow, k: number) => HTMLElement} */
function operationItem(row, k) {
  const {key} = row, said = project.now.operations[key], title = titleOfRow(row);
  const item = made('li', '', {'data-key': key, 'draggable': 'true', ...(said?.isOff ? {class: 'off'} : {})});
  const handle = made('button', '⠿', {
    'type': 'button',
    'class': 'handle',
    'id': `operation-${k}-handle`,
    'aria-label': `Place ${k + 1} of ${title}: arrow up and down move it`,
    'title': 'Drag, or arrow up and down: another place in the order of work'
  });
  handle.addEventListener('keydown', event => {
    const step = event.key === 'ArrowUp' ? -1 : event.key === 'ArrowDown' ? 1 : 0;
    if (step === 0) return;
    event.preventDefault();
    moveOperation(key, k + step);
    document.getElementById(`operation-${k + step}-handle`)?.focus();
  });
  const on = made('input', '', {'type': 'checkbox', 'id': `operation-${k}-on`, 'aria-label': `Mill ${title}`});
  on.checked = !said?.isOff;
  on.addEventListener('change', () => changeOperation(key, {isOff: !on.checked}, 'on'));
  const what = made('span', title, {class: 'what'}),
        source = made('span', row.source, {class: 'source', title: row.features.map(one => one.name).join(', ')});
  const head = made('div', '', {class: 'line'}), body = made('div', '', {class: 'line'});
  head.append(handle, on, what, source, depthField(row, k, title));
  body.append(toolField(row, k, title), ...operationFields(row, k));
  item.append(head, body, moreOfOperation(row, k));
  dragsOperation(item, key);
  return item;
}

/** @type {(item: HTMLElement, key: string) => void} */
function dragsOperation(item, key) {
  item.addEventListener('dragstart', event => event.dataTransfer?.setData('text/operation', key));
  item.addEventListener('dragover', event => {
    if (!event.dataTransfer?.types.includes('text/operation')) return;
    event.preventDefault();
    item.classList.add('over');
  });
  item.addEventListener('dragleave', () => item.classList.remove('over'));
  item.addEventListener('drop', event => {
    const moved = event.dataTransfer?.getData('text/operation');
    if (!moved) return;
    event.preventDefault();
    event.stopPropagation();
    moveOperation(moved, [...element('operations').children].indexOf(item));
  });
}

/** How deep: of a drawing it can be said, for all outlines of the row at once. @type {(row: OperationRow, k: number, title: string) => HTMLElement} */
function depthField(row, k, title) {
  const {top_z, floor_z} = row.features[0], depth = String(shownLength(top_z - floor_z, 3));
  const outlines = row.features.flatMap(one => outlineOfFeature(one, part.outlines) ?? []);
  if (outlines.length < row.features.length) return made('span', `${depth} deep`, {class: 'depth'});
  const label = made('label', '', {class: 'depth'}), input = made('input', '', {
    'id': `operation-${k}-depth`,
    'aria-label': `Depth of ${title}, ${lengthName()}`,
    'inputmode': 'decimal',
    'size': '5',
    'placeholder': depth
  });
  const said = project.now.outlines[outlines[0].number]?.depth ?? '';
  input.value = lengths.inch ? changedNumbers(said, mmToInch) : said;
  input.addEventListener('change', () => {
    const next = {...project.now.outlines};
    for (const {number} of outlines) next[number] = {...saidOfOutline(number), depth: inMm(input.value)};
    change(`operation ${row.key} depth`, {outlines: next});
  });
  label.append(input, ' deep');
  return label;
}

/** @type {(row: OperationRow, k: number, title: string) => HTMLElement} */
function toolField(row, k, title) {
  const select = made('select', '', {'id': `operation-${k}-tool`, 'aria-label': `Tool of ${title}`}),
        said = project.now.operations[row.key]?.tool ?? '';
  const library = hasToolLibrary() || toolsUsed(project.now).length === 0 ? readTools.library : [];
  const tools = [
    ...library.map(one => ({number: one.number, title: titleOfTool(one.kind, one.diameter_mm)})),
    ...numberedTools(project.now, library).map(({tool, number}) => ({number, title: titleOfTool(tool.kind, tool.diameter)}))
  ];
  select.append(made('option', 'tool', {value: '', title: 'the tool that fits'}),
    ...tools.map(one => made('option', `T${one.number} ${one.title}`, {value: one.number})));
  select.value = said;
  select.addEventListener('change', () => changeOperation(row.key, {tool: select.value}, 'tool'));
  return select;
}

/** @type {(row: OperationRow, k: number, options: CommandOption[]) => OptionFields} */
function fieldsOfOperation(row, k, options) {
  const answers = () => project.now.operations[row.key]?.answers ?? {};
  const fields = new OptionFields({
    prefix: `operation-${k}-`,
    files: () => [],
    values: name => answers()[name],
    say(name, values) {
      const next = {...answers()};
      if (values) next[name] = values;
      else delete next[name];
      changeOperation(row.key, {answers: next}, name);
    }
  });
  for (const option of options) fields.field(option);
  return fields;
}

/** The fields that every row shows; short of room, each says in itself what it is. @type {(row: OperationRow, k: number) => HTMLElement[]} */
function operationFields(row, k) {
  const options = operationOptions.filter(one => inRow.includes(nameOfOption(one))), title = titleOfRow(row);
  return fieldsOfOperation(row, k, options).fields.map(({option, box}) => {
    const control = box.querySelector('input, select'), name = labelOf(option).toLowerCase();
    control?.setAttribute(
      'aria-label', `${labelOf(option)} of ${title}${isOfLengths(option) ? `, ${option.place?.unit.replace('mm', lengthName())}` : ''}`);
    control?.setAttribute('placeholder', name);
    const first = control?.querySelector('option');
    if (first) first.textContent = name;
    return box;
  });
}

/** @type {(row: OperationRow, k: number) => HTMLElement} */
function moreOfOperation(row, k) {
  const details = made('details', '', {class: 'more'}), rare = operationOptions.filter(one => !inRow.includes(nameOfOption(one)));
  const said = Object.entries(project.now.operations[row.key]?.answers ?? {}).filter(([name]) => !inRow.includes(name));
  details.append(made('summary', said.length > 0 ? said.map(([name, [value]]) => `${name.slice(2)} ${value}`).join(', ') : 'More'));
  details.open = openOperations.has(row.key);
  const fill = () => {
    if (!details.open || details.children.length > 1) return;
    const box = made('div', '', {class: 'fields'});
    box.append(...fieldsOfOperation(row, k, rare).fields.map(one => one.box));
    details.append(box);
  };
  details.addEventListener('toggle', () => {
    openOperations[details.open ? 'add' : 'delete'](row.key);
    fill();
  });
  fill();
  return details;
}

/** The list anew; what has the focus keeps it. */
function showOperations() {
  if (isTypedIn(element('operations'))) return;
  const held = document.activeElement?.id ?? '', rows = operationRows(part.features, project.now.sequence);
  element('operations-box').hidden = rows.length === 0;
  element('operations').replaceChildren(...(part.isOfSetups ? [] : rows.map(operationItem)));
  const off = rows.filter(row => project.now.operations[row.key]?.isOff).length;
  element('operations-now').textContent = `${rows.length}${off > 0 ? `, ${off} of them off` : ''}`;
  element('operations-note').textContent = part.isOfSetups ? 'The operations of several set-ups are said in the job.' :
    project.now.sequence.length > 0                        ? 'They are cut in this order. ' :
                                                             'They are cut in the order that is shortest; drag one to say another.';
  element('operations-free').hidden = project.now.sequence.length === 0;
  if (held.startsWith('operation-')) document.getElementById(held)?.focus();
}

function setUpOperations() { element('operations-free').addEventListener('click', () => change('', {sequence: []})); }
