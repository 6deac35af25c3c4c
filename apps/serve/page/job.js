// The same work as a job file: what the choices and further options say, in the keys of a job.

/** @type {Record<string, [JobTable, string, string]>} */
const flagKeys = { '--rest': ['plan', 'rest', 'true'], '--inch': ['output', 'inch', 'true'], '--exact-stop': ['output', 'exact_stop', 'true'], '--no-arcs': ['output', 'arcs', 'false'],
  '--no-tool-change': ['output', 'tool_change', 'false'], '--no-length-offset': ['output', 'length_offset', 'false'],
  '--block-numbers': ['output', 'block_numbers', 'true'], '--optional-stop': ['output', 'optional_stop', 'true'] };
/** @type {Record<Exclude<JobTable, 'library'>, string[]>} */
const keysOf = { part: ['unit', 'depth', 'top', 'join-gap', 'open-curves', 'strokes', 'text', 'up', 'turn', 'body', 'breakthrough'], machine: ['rapid', 'acceleration', 'junction-deviation'],
  output: ['post', 'decimals', 'spindle-wait', 'work-offset', 'end-position', 'program-number'],
  plan: ['strategy', 'stepover', 'stepdown', 'allowance', 'allowance-floor', 'scallop', 'lead', 'lead-angle', 'entry', 'entry-angle', 'direction', 'feed', 'plunge-feed', 'ramp-feed', 'slot-feed', 'spindle', 'coolant',
    'passage', 'grid', 'solver', 'clearance', 'engagement', 'objective', 'time', 'seed', 'helix-diameter', 'helix-min', 'lead-feed', 'lead-overlap', 'overrun', 'link-feed', 'link-lift', 'slot-angle', 'after',
    'finish', 'finish-stock', 'finish-stock-floor', 'finish-depths', 'material', 'style', 'dogbones', 'angle', 'order', 'tabs', 'tab-spacing', 'tab-shape', 'tab-width', 'tab-height', 'skin'] };
/** @type {Exclude<JobTable, 'library'>[]} */
const tablesWithKeys = ['part', 'machine', 'output', 'plan'];
/** @type {Record<string, [JobTable, string]>} */
const listKeys = { '--layer': ['part', 'layers'], '--accept': ['plan', 'accept'] };

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
const toolWords = [{ pattern: /^T(\d+)$/, key: 'number' }, { pattern: /^(\d+(?:\.\d+)?)deg$/, key: 'tip_angle' }, { pattern: /^taper=(\d+(?:\.\d+)?)deg$/, key: 'taper_angle' },
  { pattern: /^flutes=(\d+)$/, key: 'teeth' }, { pattern: /^max_spindle=(\d+(?:\.\d+)?)$/, key: 'max_spindle' }, { pattern: /^tip=(.+)$/, key: 'tip_diameter', length: true },
  { pattern: /^corner=(.+)$/, key: 'corner_radius', length: true }, { pattern: /^length=(.+)$/, key: 'flute_length', length: true }, { pattern: /^shank=(.+)$/, key: 'shank_diameter', length: true },
  { pattern: /^stickout=(.+)$/, key: 'stickout', length: true }, { pattern: /^holder=(.+)$/, key: 'holder_diameter', length: true }, { pattern: /^(.+)$/, key: 'diameter', length: true }];
/** @type {Record<string, string>} */
const toolFlags = { hss: 'material = "hss"', carbide: 'material = "carbide"', coated: 'coated = true', noplunge: 'center_cutting = false' };

/** Key and value of a word of a tool, null where a job has none for it. @type {(word: string) => string | null} */
function toolLine(word) {
  if (toolFlags[word]) return toolFlags[word];
  if (word.startsWith('name=')) return `name = ${tomlText(word.slice(5))}`;
  for (const { pattern, key, length } of toolWords) {
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

/** What outlines are for, null where a job has no word for it. @type {(text: string) => string | null} */
function layerTable(text) {
  const found = /^([a-z]+)(?:_d(\d+(?:\.\d+)?))?:(.+)$/.exec(text);
  if (!found) return null;
  const role = found[1] === 'drill' ? 'hole' : found[1];
  return `[[layer]]\nname = ${tomlText(found[3])}\nrole = ${tomlText(role)}\n${found[2] ? `depth = ${found[2]}\n` : ''}`;
}

/** Files one option under its table; false where a job has no key for it. @type {(option: [string, string[]], job: JobTables) => boolean} */
function takeOption([name, values], job) {
  /** @type {(table: JobTable, key: string, value: string) => void} */
  const add = (table, key, value) => job[table].push(`${key.replaceAll('-', '_')} = ${value}`);
  if (name === '--tool' || name === '--op') {
    const tables = values.map(value => name === '--tool' ? toolTable(value, job.tools.length + 1) : layerTable(value)).filter(table => table !== null);
    if (tables.length < values.length) return false;
    (name === '--tool' ? job.tools : job.layers).push(...tables);
  } else if (name === '--tools' && values.length === 1) job.library.push(`library = ${tomlText(values[0])}`);
  else if (name === '--machine') add('machine', 'file', tomlText(values[0]));
  else if (flagKeys[name] && values.length === 0) add(...flagKeys[name]);
  else if (listKeys[name]) job.lists.set(name, [...(job.lists.get(name) ?? []), ...values]);
  else {
    const table = tablesWithKeys.find(one => keysOf[one].includes(name.slice(2)));
    if (!table || values.length !== 1) return false;
    add(table, name.slice(2), name === '--turn' ? values[0] : tomlValue(values[0]));
  }
  return true;
}

/** The job's text, and the options that it cannot hold. @type {(file: string, options: string) => JobText} */
function jobOf(file, options) {
  /** @type {JobTables} */
  const job = { part: [`file = ${tomlText(file)}`], layers: [], library: [], tools: [], machine: [], plan: [], output: [`program = ${tomlText(stemOf(file) + '.ngc')}`], lists: new Map() };
  const left = optionsOf(options).filter(option => !takeOption(option, job)).map(([name, values]) => [name, ...values].join(' '));
  for (const [name, values] of job.lists) job[listKeys[name][0]].push(`${listKeys[name][1]} = [${values.map(tomlText).join(', ')}]`);
  /** @type {(name: string, lines: string[]) => string[]} */
  const table = (name, lines) => lines.length > 0 ? [`[${name}]\n${lines.join('\n')}\n`] : [];
  const text = [...table('part', job.part), ...job.layers, ...table('tools', job.library), ...job.tools, ...table('machine', job.machine), ...table('plan', job.plan), ...table('output', job.output)].join('\n');
  const note = left.length > 0 ? `# A job has no words for these; say them on the command line: ${left.join(' ')}\n` : '';
  return { text: `${note}# clearcut plan ${stemOf(file)}.toml, beside ${file}\n${text}`, left };
}
