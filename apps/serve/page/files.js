// Lists of files that were chosen or dropped, each with what it is for.

const partKinds = ['dxf', 'svg', 'step', 'stp', 'p21', 'stpnc', '238', 'json', 'edges', 'toml'];
/** Layers and drill files of circuit boards by the usual endings of their names. */
const boardKinds = ['gbr', 'ger', 'pho', 'gtl', 'gbl', 'gts', 'gbs', 'gto', 'gbo', 'gtp', 'gbp', 'gko', 'gm1', 'gml', 'drl', 'xln', 'exc'];
const programKinds = ['ngc', 'nc', 'gcode', 'tap', 'cnc', 'h', 'mpf', 'txt', 'gc', 'eia', 'min'];
const libraryKinds = ['fctb', 'fctl', 'tbl'];
/** What files are for whose endings leave it open, by what they say; the first row that fits counts. @type {{ kinds: string[], role: FileRole, says: RegExp }[]} */
const toldByText = [
  {kinds: ['toml'], role: 'part', says: /^\s*(\[part\]|\[\[setup\]\])/m}, {kinds: ['toml'], role: 'tools', says: /^\s*\[\[tool\]\]/m},
  {kinds: ['toml'], role: 'machine', says: /^\s*(rapid|acceleration|junction_deviation|max_feed|max_spindle|travel)\s*=/m},
  {kinds: ['json'], role: 'tools', says: /"geometry"\s*:\s*\{[^}]*"DC"/},            // Fusion
  {kinds: ['ini'], role: 'machine', says: /^\s*\[(TRAJ|KINS|AXIS_\w|JOINT_\d)\]/m},  // LinuxCNC
  {kinds: ['txt'], role: 'machine', says: /^\s*(\$110\s*=|(echo:)?\s*M203 X)/m}      // what Grbl answers to $$, Marlin to M503
];
const mostRead = 65536;  // bytes of a file
/** @type {(name: string) => string} */
const kindOf = name => name.slice(name.lastIndexOf('.') + 1).toLowerCase();
/** @type {(name: string) => boolean} */
const mayBeTold = name => toldByText.some(row => row.kinds.includes(kindOf(name)));

/** A list of files with their roles: 'part', 'program', 'tools', 'machine', 'job', 'points' or 'file'; of one role alone there is one file. */
class ChosenFiles {
  /** @param {HTMLElement} drop @param {HTMLInputElement} input @param {HTMLElement} list @param {FileRole[]} roles @param {() => void} changed */
  constructor(drop, input, list, roles, changed) {
    /** @type {ChosenFile[]} */
    this.entries = [];
    this.input = input;
    this.list = list;
    this.roles = roles;
    this.changed = changed;
    input.addEventListener('change', () => {
      this.add(input.files ?? []);
      input.value = '';
    });
    drop.addEventListener('dragover', event => {
      event.preventDefault();
      drop.classList.add('over');
    });
    drop.addEventListener('dragleave', () => drop.classList.remove('over'));
    drop.addEventListener('drop', event => {
      event.preventDefault();
      drop.classList.remove('over');
      this.add(event.dataTransfer?.files ?? []);
    });
  }

  /** @type {(files: Iterable<File>) => Promise<void>} */
  async add(files) {
    const all = [...files], isAsked = this.roles.length > 1 && all.some(file => mayBeTold(file.name));
    const texts = isAsked ? await Promise.all(all.map(file => file.slice(0, mostRead).text())) : [];
    all.forEach((file, i) => {
      if (this.roles.length === 1) this.entries = [];
      this.entries = this.entries.filter(entry => entry.file.name !== file.name);
      this.entries.push({file, role: this.likelyRole(file.name, texts[i] ?? '')});
    });
    // A job names its library and its machine itself; they are only beside it.
    if (kindOf(this.of('part')?.name ?? '') === 'toml') {
      for (const entry of this.entries)
        if (all.includes(entry.file) && ['tools', 'machine'].includes(entry.role)) entry.role = 'file';
    }
    this.show();
  }

  /** What a file that is called and begins like this is for, where its role is not taken. @type {(name: string, text: string) => FileRole} */
  likelyRole(name, text) {
    const kind = kindOf(name), told = toldByText.find(row => row.kinds.includes(kind) && row.says.test(text))?.role;
    if (this.roles.length === 1) return this.roles[0];
    if (this.roles.includes('program') && programKinds.includes(kind) && !this.of('program')) return 'program';
    if (told) return this.roles.includes(told) && !this.of(told) ? told : 'file';
    if (this.roles.includes('tools') && libraryKinds.includes(kind) && !this.of('tools')) return 'tools';
    return (partKinds.includes(kind) || boardKinds.includes(kind)) && !this.of('part') ? 'part' : 'file';
  }

  /** @type {(role: FileRole) => File | undefined} */
  of(role) { return this.entries.find(entry => entry.role === role)?.file; }

  /** @type {(chosen: ChosenFile, role: FileRole) => void} */
  setRole(chosen, role) {
    for (const entry of this.entries)
      if (role !== 'file' && entry.role === role) entry.role = 'file';
    chosen.role = role;
    this.show();
  }

  /** The list is written anew; what had the focus has it again, and where its line is gone, the next one or the choice of files. */
  show() {
    const held = this.list.contains(document.activeElement) ? document.activeElement : null, lines = [...this.list.children];
    const row = lines.findIndex(line => line.contains(held)), isSame = lines.length === this.entries.length;
    this.list.replaceChildren(...this.entries.map(entry => this.line(entry)));
    this.changed();
    if (!held) return;
    const controls = this.list.children[Math.min(row, this.entries.length - 1)]?.querySelectorAll(isSame ? held.tagName : 'button');
    const next = controls?.[0] ?? this.input;
    if (next instanceof HTMLElement) next.focus();
  }

  /** @type {(entry: ChosenFile) => HTMLElement} */
  line(entry) {
    const line = made('li');
    const role = made('select', '', {'aria-label': `What ${entry.file.name} is`});
    const words = {
      part: 'the part',
      program: 'the program',
      job: 'the job',
      points: 'the points',
      tools: 'a tool library',
      machine: 'a machine file',
      file: 'a further file'
    };
    role.replaceChildren(...this.roles.map(value => made('option', words[value], {value})));
    role.value = entry.role;
    role.addEventListener('change', () => this.setRole(entry, this.roles[role.selectedIndex]));
    const remove = made('button', 'Remove', {type: 'button', 'aria-label': `Remove ${entry.file.name}`});
    remove.addEventListener('click', () => {
      this.entries = this.entries.filter(one => one !== entry);
      this.show();
    });
    line.append(made('span', entry.file.name, {class: 'name'}), ...(this.roles.length > 1 ? [role] : []), remove);
    return line;
  }

  /** As a form for the server. @type {(options: string) => FormData} */
  form(options) {
    const form = new FormData();
    form.append('options', options);
    for (const entry of this.entries)
      form.append(['tools', 'machine'].includes(entry.role) ? 'file' : entry.role, entry.file, entry.file.name);
    return form;
  }
}

/** The list of a tab, whose elements have names that begin with the tab's. @type {(tab: TabName, roles: FileRole[], changed: () => void) => ChosenFiles} */
const listOfFiles = (tab, roles, changed) =>
  new ChosenFiles(element(`${tab}-drop`), element(`${tab}-files`), element(`${tab}-list`), roles, changed);
