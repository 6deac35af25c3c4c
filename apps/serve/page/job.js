// The same work as a job file: what the choices and further options say, in the keys of a job.

/** Where a job says each option of plan, by its name; learnt from the command's own table. @type {Record<string, JobKey>} */
const jobKeys = {};

/** @type {(options: Options) => void} */
function learnJobKeys(options) {
  for (const {names, value, many, job} of options.plan ?? []) {
    const name = names.at(-1);
    if (job && name) jobKeys[name] = {...job, flag: value === '', many};
  }
}

/** Words as the server takes them apart. @type {(text: string) => string[]} */
function wordsOf(text) {
  return [...text.matchAll(/(?:[^\s"']+|"[^"]*"|'[^']*')+/g)].map(([word]) => word.replace(/"([^"]*)"|'([^']*)'/g, (all, a, b) => a ?? b));
}

/** Options with their values: [name, [value, ...]]. @type {(text: string) => [string, string[]][]} */
function optionsOf(text) {
  /** @type {[string, string[]][]} */
  const options = [];
  for (const word of wordsOf(text)) {
    const equals = word.indexOf('=');
    if (word.startsWith('--')) options.push(equals > 0 ? [word.slice(0, equals), [word.slice(equals + 1)]] : [word, []]);
    else options.at(-1)?.[1].push(word);
  }
  return options;
}

/** @type {(text: string) => string} */
const tomlText = text => JSON.stringify(text);
/** @type {(text: string) => string} */
const tomlValue = text => /^-?\d+(\.\d+)?$/.test(text) ? text : tomlText(text);

/** mm of a length as on the command line, null where it is none. @type {(text: string) => number | null} */
function mmOf(text) {
  const [, number, unit_] = /^(\d+(?:\.\d+)?)(mm|in|")?$/.exec(text) ?? [];
  return number === undefined ? null : unit_ === 'in' || unit_ === '"' ? Number((25.4 * Number(number)).toFixed(9)) : Number(number);
}

/** What may follow a tool's kind, as a line of its table; `length`: it is a length. @type {{ pattern: RegExp, key: string, length?: boolean }[]} */
const toolWords = [
  {pattern: /^T(\d+)$/, key: 'number'}, {pattern: /^(\d+(?:\.\d+)?)deg$/, key: 'tip_angle'},
  {pattern: /^taper=(\d+(?:\.\d+)?)deg$/, key: 'taper_angle'}, {pattern: /^flutes=(\d+)$/, key: 'teeth'},
  {pattern: /^max_spindle=(\d+(?:\.\d+)?)$/, key: 'max_spindle'}, {pattern: /^tip=(.+)$/, key: 'tip_diameter', length: true},
  {pattern: /^corner=(.+)$/, key: 'corner_radius', length: true}, {pattern: /^length=(.+)$/, key: 'flute_length', length: true},
  {pattern: /^shank=(.+)$/, key: 'shank_diameter', length: true}, {pattern: /^stickout=(.+)$/, key: 'stickout', length: true},
  {pattern: /^holder=(.+)$/, key: 'holder_diameter', length: true}, {pattern: /^(.+)$/, key: 'diameter', length: true}
];
/** @type {Record<string, string>} */
const toolFlags = {
  hss: 'material = "hss"',
  carbide: 'material = "carbide"',
  coated: 'coated = true',
  noplunge: 'center_cutting = false'
};

/** Key and value of a word of a tool, null where a job has none for it. @type {(word: string) => string | null} */
function toolLine(word) {
  if (toolFlags[word]) return toolFlags[word];
  if (word.startsWith('name=')) return `name = ${tomlText(word.slice(5))}`;
  for (const {pattern, key, length} of toolWords) {
    const value = pattern.exec(word)?.[1];
    if (value === undefined) continue;
    const number = length ? mmOf(value) : Number(value);
    return number === null ? null : `${key} = ${number}`;
  }
  return null;
}

/** A tool as a table, null where more is said of it than a job has words for. @type {(text: string, number: number) => string | null} */
function toolTable(text, number) {
  const [kind, ...words] = text.split(':'), lines = words.map(toolLine);
  if (!/^[a-z]+$/.test(kind) || lines.some(line => line === null) || !lines.some(line => line?.startsWith('diameter'))) return null;
  if (!lines.some(line => line?.startsWith('number'))) lines.unshift(`number = ${number}`);
  return `[[tool]]\nkind = ${tomlText(kind)}\n${lines.join('\n')}\n`;
}

/** Files one option under its table; false where a job has no key for it. @type {(option: [string, string[]], job: JobTables) => boolean} */
function takeOption([name, values], job) {
  if (name === '--tool') {
    const tables = values.map(value => toolTable(value, job.each.length + 1)).filter(table => table !== null);
    if (tables.length < values.length) return false;
    job.each.push(...tables);
    return true;
  }
  const place = jobKeys[name];
  if (!place || place.flag !== (values.length === 0)) return false;
  if (place.many) {
    const lists = job.lists[place.table];
    lists[place.key] = [...(lists[place.key] ?? []), ...values];
    return true;
  }
  if (values.length > 1) return false;
  job.lines[place.table].push(`${place.key} = ${
    place.flag     ? String(!place.opposite) :
      place.number ? tomlValue(values[0]) :
                     tomlText(values[0])}`);
  return true;
}

/** The job's text, and the options that it cannot hold. `more`: what options cannot say. @type {(file: string, options: string, more?: JobMore | null) => JobText} */
function jobOf(file, options, more = null) {
  /** @type {JobTables} */
  const job = {
    lines: {part: [`file = ${tomlText(file)}`], tools: [], machine: [], plan: [], output: [`program = ${tomlText(stemOf(file) + '.ngc')}`]},
    lists: {part: {}, tools: {}, machine: {}, plan: {}, output: {}},
    each: []
  };
  const left = optionsOf(options).filter(option => !takeOption(option, job)).map(([name, values]) => [name, ...values].join(' '));
  /** @type {(name: JobTable) => string[]} */
  const table = name => {
    const lists = Object.entries(job.lists[name]).map(([key, values]) => `${key} = [${values.map(tomlText).join(', ')}]`);
    const lines = [...job.lines[name], ...lists];
    return lines.length > 0 ? [`[${name}]\n${lines.join('\n')}\n`] : [];
  };
  if (more && more.sequence.length > 0) job.lists.plan.sequence = more.sequence;
  const text = [
    ...table('part'), ...more?.stock ? [more.stock] : [], ...table('tools'), ...job.each, ...table('machine'), ...table('plan'),
    ...table('output'), ...more?.operations ? [more.operations] : []
  ].join('\n');
  const note = left.length > 0 ? `# A job has no words for these; say them on the command line: ${left.join(' ')}\n` : '';
  return {text: `${note}# clearcut plan ${stemOf(file)}.toml, beside ${file}\n${text}`, left};
}
