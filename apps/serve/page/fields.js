// A field for every row of the options' table, in the place of its group: what a first program needs at once, rare ones behind "More",
// research behind "Research".

/** Where a group of options has its place. @type {Record<string, FieldPlace>} */
const placeOfGroup = {
  'Input': 'stock',
  'Solids': 'stock',
  'Drawings': 'drawing',
  'Tools': 'tools',
  'Machine': 'machine',
  'Controller': 'machine',
  'Limits': 'cutting',
  'Strategy': 'cutting',
  'Entry': 'cutting',
  'Leads and links': 'cutting',
  'Feeds and speeds': 'cutting',
  'Rest and finishing': 'cutting',
  'Copies': 'stock',
  'Search': 'research',
  'Published solver': 'research'
};
/** Options that a machinist looks for elsewhere than in their group. @type {Record<string, FieldPlace>} */
const placeOfOption = {
  '--material': 'stock',
  '--unit': 'drawing',
  '--layer': 'drawing',
  '--depth': 'drawing',
  '--mirror': 'drawing',
  '--stock-oversize': 'stock',
  '--tabs': 'holding',
  '--tab-spacing': 'holding',
  '--tab-at': 'holding',
  '--tab-shape': 'holding',
  '--tab-width': 'holding',
  '--tab-height': 'holding',
  '--skin': 'holding',
  '--keep-out': 'holding',
  '--accept': 'holding'
};
/** Options whose numbers are lengths, in texts of several. */
const textsOfLengths = ['--origin', '--tab-at', '--keep-out', '--start', '--predrilled'];
/** What a field is called where the option's name does not say it. @type {Record<string, string>} */
const labelOfOption = {
  '--origin': 'Zero',
  '--post': 'Controller',
  '--material': 'Material of the work',
  '--unit': 'Unit of the drawing',
  '--keep-out': 'Clamps, X, Y, Z as LOW:HIGH',
  '--tab-at': 'Tabs at X,Y',
  '--accept': 'Holds at the machine',
  '--inch': 'Program in inches',
  '--op': 'What it is for',
  '--nest-with': 'Other parts on the sheet, FILE or FILE:NUMBER',
  '--setup': 'Set-up to plan alone',
  '--earlier-setup': 'Programs of the set-ups before it'
};
/** @type {(option: CommandOption) => string} */
const nameOfOption = option => option.names.at(-1) ?? '';
/** @type {(option: CommandOption) => FieldPlace} */
const placeOf = option =>
  option.place?.level === 'research' ? 'research' : placeOfOption[nameOfOption(option)] ?? placeOfGroup[option.group] ?? 'cutting';
/** @type {(option: CommandOption) => string} */
function labelOf(option) {
  const name = nameOfOption(option),
        words = labelOfOption[name] ?? name.slice(2).replaceAll('-', ' ').replace(/^./, letter => letter.toUpperCase());
  const unit = option.place?.unit ?? '';
  return unit && !/^mm/.test(unit) ? `${words}, ${unit}` : words;
}

/** Whether a field's numbers are in the unit chosen at the top. @type {(option: CommandOption) => boolean} */
const isOfLengths = option => /^mm(\/min)?$/.test(option.place?.unit ?? '') || textsOfLengths.includes(nameOfOption(option));
/** @type {(option: CommandOption, mm: string) => string} */
const shownAnswer = (option, mm) => isOfLengths(option) && lengths.inch ? changedNumbers(mm, mmToInch) : mm;
/** @type {(option: CommandOption, text: string) => string} */
const answerInMm = (option, text) => isOfLengths(option) ? inMm(text) : text.trim();
/** Options that name a file which was chosen. @type {(option: CommandOption) => boolean} */
const namesFile = option => option.file === true && !['--machine', '--nest-with'].includes(nameOfOption(option));

/** The values that a field proposes, once in the page. @type {(option: CommandOption) => string} */
function listOfValues(option) {
  const id = `values${nameOfOption(option)}`;
  if (document.getElementById(id)) return id;
  const list = made('datalist', '', {id});
  list.append(...option.values.map(value => made('option', '', {value})));
  document.body.append(list);
  return id;
}

/** Whether published methods are offered, too. */
const research = {
  isShown: false
};
/** The values that are offered: published methods where somebody asks for research. @type {(option: CommandOption) => string[]} */
function offeredValues({values, help}) {
  const published = /published method: ([\w, -]+)/.exec(help)?.[1].split(', ').map(name => name.trim()) ?? [];
  return research.isShown ? values : values.filter(value => !published.includes(value));
}

/** Fields for options of a command; what they say is kept elsewhere. */
class OptionFields {
  /** @param {FieldsOf} of */
  constructor(of) {
    this.of = of;
    /** @type {{ option: CommandOption, box: HTMLElement }[]} */
    this.fields = [];
  }

  /** Those first that a first program needs, others behind "More". @type {(options: CommandOption[], within: HTMLElement) => void} */
  put(options, within) {
    const shown = options.filter(one => (one.place?.level ?? 'rest') === 'first'), rare = options.filter(one => !shown.includes(one));
    const box = made('div', '', {class: 'fields'});
    box.append(...shown.map(one => this.field(one)));
    within.append(box);
    if (rare.length === 0) return;
    const more = made('div', '', {class: 'fields'});
    more.append(...rare.map(one => this.field(one)));
    if (shown.length === 0) {
      within.append(more);
      return;
    }
    const details = made('details', '', {class: 'more'});
    details.append(made('summary', `More: ${rare.length}`), more);
    within.append(details);
  }

  /** @type {(option: CommandOption) => HTMLElement} */
  field(option) {
    const box = made('div', '', {'class': 'field', 'title': option.help, 'data-option': nameOfOption(option)});
    this.fields.push({option, box});
    this.fill(option, box);
    return box;
  }

  /** @type {(option: CommandOption, box: HTMLElement) => void} */
  fill(option, box) {
    const values = this.of.values(nameOfOption(option));
    if (option.value === '') box.replaceChildren(this.flag(option, values));
    else if (option.many) box.replaceChildren(this.several(option, values ?? []));
    else box.replaceChildren(this.single(option, values?.[0] ?? ''));
  }

  /** @type {(option: CommandOption, values: string[] | undefined) => HTMLElement} */
  flag(option, values) {
    const label = made('label', '', {class: 'flag'}), input = made('input', '', {type: 'checkbox', id: this.idOf(option)});
    input.checked = values !== undefined;
    input.addEventListener('change', () => this.of.say(nameOfOption(option), input.checked ? [] : null));
    label.append(input, ` ${labelOf(option)}`);
    return label;
  }

  /** @type {(option: CommandOption) => string} */
  idOf(option) { return `${this.of.prefix}${nameOfOption(option).slice(2)}`; }

  /** @type {(option: CommandOption, text: string) => HTMLElement} */
  single(option, text) {
    const label = made('label'), input = this.control(option, text, this.idOf(option));
    input.addEventListener('change', () => {
      const value = answerInMm(option, input.value);
      this.of.say(nameOfOption(option), value ? [value] : null);
    });
    label.append(this.caption(option), input);
    return label;
  }

  /** @type {(option: CommandOption) => HTMLElement} */
  caption(option) {
    const caption = made('span', labelOf(option), {class: 'caption'});
    if (isOfLengths(option)) caption.append(' ', made('span', (option.place?.unit || 'mm').replace('mm', lengthName()), {class: 'unit'}));
    return caption;
  }

  /** A field for each value, and an empty one for the next. @type {(option: CommandOption, values: string[]) => HTMLElement} */
  several(option, values) {
    const box = made('div', '', {'class': 'several', 'role': 'group', 'aria-label': labelOf(option)});
    box.append(this.caption(option), ...[...values, ''].map((value, k) => {
      const input = this.control(option, value, `${this.idOf(option)}-${k + 1}`);
      input.setAttribute('aria-label', `${labelOf(option)} ${k + 1}`);
      input.addEventListener('change', () => {
        const next = [...values];
        next.splice(k, 1, ...[answerInMm(option, input.value)].filter(one => one));
        this.of.say(nameOfOption(option), next.length > 0 ? next : null);
      });
      return input;
    }));
    return box;
  }

  /** @type {(option: CommandOption, text: string, id: string) => HTMLInputElement | HTMLSelectElement} */
  control(option, text, id) {
    const shown = shownAnswer(option, text), usual = option.place?.default ?? '';
    if (option.place?.choice || namesFile(option) || ['--strategy', '--objective', '--unit'].includes(nameOfOption(option))) {
      const select = made('select', '', {id});
      const values = namesFile(option) ? this.of.files() : offeredValues(option);
      fillSelect(
        select, values.includes(text) || !text ? values : [...values, text], usual ? `as usual: ${usual}`.slice(0, 60) : 'as usual');
      select.value = text;
      return select;
    }
    const input = made('input', '', {
      id,
      spellcheck: 'false',
      autocomplete: 'off',
      placeholder: usual,
      ...(isOfLengths(option) ? {'data-field': '1'} : {}),
      ...(option.job?.number ? {inputmode: 'decimal'} : {})
    });
    input.value = shown;
    if (option.values.length > 0) { input.setAttribute('list', listOfValues(option)); }
    return input;
  }

  /** Shows what is said now; a field that has the focus keeps it. `names`: the options that may have changed. @type {(names?: string[]) => void} */
  show(names) {
    for (const {option, box} of this.fields) {
      if (names && !names.includes(nameOfOption(option)) || isTypedIn(box)) continue;
      const held = box.contains(document.activeElement) ? document.activeElement?.id : '';
      this.fill(option, box);
      if (held) document.getElementById(held)?.focus();
    }
  }
}

/** The words of answers, as on the command line. @type {(answers: Record<string, string[]>) => string[]} */
const wordsOfAnswers = answers =>
  Object.entries(answers).flatMap(([name, values]) => values.length === 0 ? [name] : values.map(value => optionWord(name, value)));
/** A value that begins with a minus would be an option of its own. @type {(name: string, value: string) => string} */
const optionWord = (name, value) => value.startsWith('-') ? `${name}=${quoted(value)}` : `${name} ${quoted(value)}`;

/** Fields of a tab without a history, and what they say. @type {(prefix: string, options: CommandOption[], within: HTMLElement, changed: () => void) => Record<string, string[]>} */
function fieldsWithin(prefix, options, within, changed) {
  /** @type {Record<string, string[]>} */
  const answers = {};
  const fields = new OptionFields({
    prefix,
    files: () => [],
    values: name => answers[name],
    say(name, values) {
      if (values) answers[name] = values;
      else delete answers[name];
      fields.show([name]);
      changed();
    }
  });
  fields.put(options, within);
  shownFields.push(fields);
  return answers;
}
/** All that there are, to be shown anew in another unit. @type {OptionFields[]} */
const shownFields = [];
