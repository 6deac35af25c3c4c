// The shop's tools as a table: kept by the browser for every part, saved as a file, and beside it what a library that was dropped holds.

const toolKinds = [
  'endmill', 'facemill', 'bullnose', 'ball', 'drill', 'spotdrill', 'reamer', 'vbit', 'chamfer', 'tapered', 'tslot', 'boringbar',
  'counterbore', 'tap', 'threadmill'
];
/** What may be said of a tool besides kind and diameter: its words on the command line. `isLength`: mm; `values`: there are no others. @type {ToolField[]} */
const toolFields = [
  {key: 'number', label: 'Number T', word: value => `T${value}`}, {key: 'name', label: 'Name', word: value => `name=${value}`},
  {key: 'teeth', label: 'Flutes', word: value => `flutes=${value}`},
  {key: 'angle', label: 'Tip angle, degrees', word: value => `${value}deg`},
  {key: 'tip', label: 'Tip Ø', isLength: true, word: value => `tip=${value}`},
  {key: 'corner', label: 'Corner radius', isLength: true, word: value => `corner=${value}`},
  {key: 'taper', label: 'Taper of a side, degrees', word: value => `taper=${value}deg`},
  {key: 'length', label: 'Flute length', isLength: true, word: value => `length=${value}`},
  {key: 'shank', label: 'Shank Ø', isLength: true, word: value => `shank=${value}`},
  {key: 'stickout', label: 'Stickout', isLength: true, word: value => `stickout=${value}`},
  {key: 'holder', label: 'Holder Ø', isLength: true, word: value => `holder=${value}`},
  {key: 'max_spindle', label: 'Most rpm', word: value => `max_spindle=${value}`},
  {key: 'material', label: 'Made of', values: ['hss', 'carbide'], word: value => value},
  {key: 'coated', label: 'Coated', values: ['coated'], word: value => value},
  {key: 'plunge', label: 'Plunges', values: ['noplunge'], word: value => value}
];

/** As on the command line; `number`: where it says none itself and has to have one. @type {(tool: ToolSaid, number?: number) => string} */
function wordOfTool(tool, number) {
  const words = toolFields.flatMap(({key, word}) => tool.more[key] ? [word(tool.more[key])] : []);
  if (number !== undefined && !tool.more.number) words.unshift(`T${number}`);
  return [tool.kind, ...(tool.diameter ? [tool.diameter] : []), ...words].join(':');
}

/** Tools of the table that the part is cut with: where its file or a library says tools, those of the table only once somebody has said them for it. @type {(now: Project) => ToolSaid[]} */
function toolsUsed(now) {
  const chosen = now.files.find(one => one.role === 'part'), hasLibrary = now.files.some(one => one.role === 'tools');
  const isSaid = chosen !== undefined && saysTools(chosen.file.name) || hasLibrary;
  return isSaid && !now.saysTools ? [] : now.tools.filter(one => one.isOn && (one.diameter || one.kind === 'tap'));
}

/** Each with a number of its own: those of a library keep theirs. @type {(now: Project, library: ToolInfo[]) => { tool: ToolSaid, number: number }[]} */
function numberedTools(now, library) {
  const taken =
    new Set([...library.map(one => one.number), ...toolsUsed(now).flatMap(one => one.more.number ? [Number(one.more.number)] : [])]);
  let last = 0;
  return toolsUsed(now).map(tool => {
    if (tool.more.number) return {tool, number: Number(tool.more.number)};
    do ++last;
    while (taken.has(last));
    return {tool, number: last};
  });
}

/** Tools that a library or the part's file brings. @type {{ library: ToolInfo[] }} */
const readTools = {
  library: []
};
/** @type {() => boolean} */
const hasToolLibrary = () => project.now.files.some(one => one.role === 'tools');

/** Words of the tools, with numbers where a library has some too. @type {(now: Project) => string[]} */
const toolOptions = now => numberedTools(now, hasToolLibrary() ? readTools.library : []).map(({tool,
  number}) => optionWord('--tool', wordOfTool(tool, hasToolLibrary() ? number : undefined)));

/** A tool in a line. @type {(kind: string, diameter: number | string, name?: string) => string} */
const titleOfTool = (kind, diameter, name = '') =>
  `${kind} ${shownLength(Number(diameter), 3)}${name && !/^T?\d+$/.test(name) ? `, ${name}` : ''}`;

/** @type {(index: number, said: Partial<ToolSaid>, what: string) => void} */
function changeTool(index, said, what) {
  const tools = project.now.tools.map((one, k) => k === index ? {...one, ...said} : one);
  change(`tool ${index} ${what}`, {tools, saysTools: true});
}

/** @type {(tool: ToolSaid, index: number) => HTMLElement} */
function toolRow(tool, index) {
  const row = made('tr'), name = `tool ${index + 1}`;
  const on = made('input', '', {'type': 'checkbox', 'id': `tool-${index}-on`, 'aria-label': `Use ${name}`});
  on.checked = tool.isOn;
  on.addEventListener('change', () => changeTool(index, {isOn: on.checked}, 'on'));
  const kind = made('select', '', {'id': `tool-${index}-kind`, 'aria-label': `Kind of ${name}`});
  fillSelect(kind, toolKinds);
  kind.value = tool.kind;
  kind.addEventListener('change', () => changeTool(index, {kind: kind.value}, 'kind'));
  const diameter =
    made('input', '', {'id': `tool-${index}-diameter`, 'aria-label': `Diameter of ${name}, ${lengthName()}`, 'inputmode': 'decimal'});
  diameter.value = lengths.inch ? changedNumbers(tool.diameter, mmToInch) : tool.diameter;
  diameter.addEventListener('change', () => changeTool(index, {diameter: inMm(diameter.value)}, 'diameter'));
  const remove = made('button', '×', {'type': 'button', 'id': `tool-${index}-remove`, 'aria-label': `Remove ${name}`});
  remove.addEventListener('click', () => change('', {tools: project.now.tools.filter((_, k) => k !== index), saysTools: true}));
  row.append(...[on, kind, diameter, toolMore(tool, index), remove].map(one => {
    const cell = made('td');
    cell.append(one);
    return cell;
  }));
  return row;
}

/** Which tools have their rarer fields open. @type {Set<number>} */
const openTools = new Set();

/** @type {(tool: ToolSaid, index: number) => HTMLElement} */
function toolMore(tool, index) {
  const details = made('details'), box = made('div', '', {class: 'fields'});
  details.open = openTools.has(index);
  details.addEventListener('toggle', () => openTools[details.open ? 'add' : 'delete'](index));
  box.append(...toolFields.map(field => {
    const label = made('label', field.label + (field.isLength ? `, ${lengthName()}` : '')), id = `tool-${index}-${field.key}`;
    const control = field.values ? made('select', '', {id}) : made('input', '', {id, autocomplete: 'off'});
    if (control instanceof HTMLSelectElement) fillSelect(control, field.values ?? [], 'not said');
    const value = tool.more[field.key] ?? '';
    control.value = field.isLength && lengths.inch ? changedNumbers(value, mmToInch) : value;
    control.addEventListener('change', () => {
      const said = field.isLength ? inMm(control.value) : control.value.trim(), more = {...tool.more, [field.key]: said};
      if (!said) delete more[field.key];
      changeTool(index, {more}, field.key);
    });
    label.append(control);
    return label;
  }));
  const said = toolFields.flatMap(({key, word}) => tool.more[key] ? [word(tool.more[key])] : []).join(' ');
  details.append(made('summary', said || 'more'), box);
  return details;
}

/** @type {(one: ToolInfo) => HTMLElement} */
function libraryRow(one) {
  const row = made('tr', '', {class: 'library'});
  row.append(made('td', `T${one.number}`), made('td', one.kind), made('td', String(shownLength(one.diameter_mm, 3))),
    made('td', [one.name, `${one.teeth} flutes`].filter(word => word).join(', ')), made('td'));
  return row;
}

/** The table anew; what has the focus keeps it. */
function showTools() {
  if (isTypedIn(element('tool-table'))) return;
  const held = document.activeElement?.id ?? '', {tools} = project.now, used = toolsUsed(project.now);
  const shown = hasToolLibrary() || used.length === 0 ? readTools.library : [];
  theOne('tbody', element('tool-table')).replaceChildren(...shown.map(libraryRow), ...tools.map(toolRow));
  element('tools-now').textContent =
    [...shown.map(one => titleOfTool(one.kind, one.diameter_mm)), ...used.map(one => titleOfTool(one.kind, one.diameter))].join('; ') ||
    'none said';
  element('tools-note').textContent = used.length === 0 && tools.length > 0 && shown.length > 0 ?
    'The part\'s own tools are used; a change below puts the table in their place.' :
    '';
  if (held.startsWith('tool-')) document.getElementById(held)?.focus();
}

/** The table as a tool library. @type {(now: Project) => string} */
const toolFileText = now => ['# Tools of the page; clearcut plan PART --tools FILE, or drop it on the page',
  ...now.tools.map((tool, k) => toolTable(wordOfTool(tool), k + 1) ?? '')]
                              .join('\n');

/** Gives a text away as a file. @type {(name: string, text: string, type: string) => void} */
function giveFile(name, text, type) {
  const link = made('a', '', {href: URL.createObjectURL(new Blob([text], {type})), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function setUpTools() {
  element('tool-add').addEventListener('click', () => {
    change('', {tools: [...project.now.tools, {...firstTool}], saysTools: true});
    document.getElementById(`tool-${project.now.tools.length - 1}-kind`)?.focus();
  });
  element('tools-save').addEventListener('click', () => giveFile('tools.toml', toolFileText(project.now), 'application/toml'));
}
