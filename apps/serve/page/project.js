// What was said of the part, as one value: answers to the options' table, outlines, tools, operations, stock. Every change goes through
// change(), so that it can be undone, is kept by the browser, and everything that shows it is drawn anew.

/** @type {ToolSaid} */
const firstTool = {
  isOn: true,
  kind: 'endmill',
  diameter: '6',
  more: {}
};
/** Nothing said of any part; tools are those of the shop. @type {(tools?: ToolSaid[]) => Project} */
const emptyProject = (tools = [firstTool]) => ({
  files: [],
  answers: {},
  given: [],
  outlines: {},
  tools,
  saysTools: false,
  operations: {},
  sequence: [],
  stock: {margin: '', bottom: '', top: ''},
});

/** @type {{ now: Project, past: Project[], future: Project[], what: string, at: number, shown: ((before: Project) => void) | null }} */
const project = {
  now: emptyProject(),
  past: [],
  future: [],
  what: '',
  at: 0,
  shown: null
};
const mostUndone = 200;
const oneChange = 1500;  // ms within which changes of one thing are undone together

/** Shows it, and has the browser keep it. @type {(before: Project) => void} */
function projectChanged(before) {
  project.shown?.(before);
  keepProject();
}

/** `what`: names the thing, so that what is typed letter by letter is undone as one. @type {(what: string, said: Partial<Project>) => void} */
function change(what, said) {
  const before = project.now, now = Date.now();
  const isSame = what !== '' && what === project.what && now - project.at < oneChange && project.past.length > 0;
  if (!isSame) project.past = [...project.past, before].slice(-mostUndone);
  Object.assign(project, {now: {...before, ...said}, future: [], what, at: now});
  projectChanged(before);
}

/** @type {(from: Project[], to: Project[]) => void} */
function stepInHistory(from, to) {
  const next = from.pop(), before = project.now;
  if (!next) return;
  to.push(before);
  Object.assign(project, {now: next, what: ''});
  projectChanged(before);
}
const undo = () => stepInHistory(project.past, project.future);
const redo = () => stepInHistory(project.future, project.past);

/** Another project in place of this one, which can be undone, too. @type {(next: Project) => void} */
function replaceProject(next) {
  project.what = '';
  change('', next);
}

/** An answer to an option: its values, none for a flag; null: not said. @type {(name: string, values: string[] | null) => void} */
function answer(name, values) {
  const answers = {...project.now.answers};
  if (values) answers[name] = values;
  else delete answers[name];
  change(name, {answers});
}

// State kept by the browser: the part, every answer given for it, and the tools of the shop.

const database = 'clearcut', kept = 'kept';

/** @type {(work: (store: IDBObjectStore) => IDBRequest) => Promise<unknown>} */
function inDatabase(work) {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open(database, 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore(kept);
    opening.onerror = () => reject(opening.error);
    opening.onsuccess = () => {
      const asked = work(opening.result.transaction(kept, 'readwrite').objectStore(kept));
      asked.onsuccess = () => resolve(asked.result);
      asked.onerror = () => reject(asked.error);
    };
  });
}

let keeping = 0;
/** Soon, and once for many changes. A browser that keeps nothing works all the same. */
function keepProject() {
  clearTimeout(keeping);
  keeping = setTimeout(() => {
    inDatabase(store => store.put(project.now, 'project')).catch(() => {});
  }, 200);
}

/** What was worked on when the page was left, and the shop's tools; null: nothing is kept. @type {() => Promise<Project | null>} */
async function keptProject() {
  try {
    const found = /** @type {Project | undefined} */ (await inDatabase(store => store.get('project')));
    return found && Array.isArray(found.files) ? {...emptyProject(), ...found} : null;
  } catch { return null; }
}

// The project file, <name>.clearcut.json: the files, what the command is asked, and what the page shows of it.

const projectEnding = '.clearcut.json';
/** @type {(bytes: Uint8Array) => string} */
const inBase64 = bytes => btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(''));
/** @type {(text: string) => Uint8Array<ArrayBuffer>} */
const fromBase64 = text => Uint8Array.from(atob(text), letter => letter.charCodeAt(0));

/** A file as the project file holds it: as text where it is such. @type {(name: string, bytes: Uint8Array) => PackedFile} */
function packed(name, bytes) {
  const text = new TextDecoder('utf-8', {ignoreBOM: true}).decode(bytes), again = new TextEncoder().encode(text);
  const isText = again.length === bytes.length && again.every((byte, k) => byte === bytes[k]);
  return isText ? {name, text} : {name, base64: inBase64(bytes)};
}

/** `asked`: what the command is asked. @type {(now: Project, asked: PlanAsked) => Promise<string>} */
async function projectText(now, asked) {
  const files = await Promise.all(
    [...asked.files, ...now.files.map(one => one.file)].map(async file => packed(file.name, new Uint8Array(await file.arrayBuffer()))));
  const {files: chosen, ...said} = now;
  /** @type {Record<string, string[]>} */
  const options = {};
  for (const [name, values] of optionsOf(asked.options)) options[name.slice(2)] = [...(options[name.slice(2)] ?? []), ...values];
  const page = {...said, roles: chosen.map(one => ({name: one.file.name, role: one.role}))};
  return `${JSON.stringify({clearcut: 'project', version: 1, plan: {input: asked.input, options}, page, files}, null, 1)}\n`;
}

/** Throws an Error where the text is no project file. @type {(name: string, text: string) => Project} */
function projectOf(name, text) {
  /** @type {ProjectJson | null} */
  let json = null;
  try {
    json = JSON.parse(text);
  } catch { /* said below */
  }
  if (json?.clearcut !== 'project' || json.version !== 1 || !Array.isArray(json.files) || !json.page)
    throw new Error(`${name}: is no project file of this version; the page writes one with Save.`);
  const {roles, ...said} = json.page, files = json.files;
  const chosen = roles.flatMap(({name: file, role}) => {
    const found = files.find(one => one.name === file);
    if (!found) return [];
    return [{file: new File([found.text ?? fromBase64(found.base64 ?? '')], file), role}];
  });
  return {...emptyProject(), ...said, files: chosen};
}
