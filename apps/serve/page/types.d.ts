// Types of the page's scripts, for the checker (`make lint-viewer`); no page holds this file. What the server sends and takes is as in its
// description (GET /openapi.json), and the JSON of commands as `clearcut info` and `clearcut compare` print it with --json. Lengths are mm, times s.

/** What a file that was chosen is for. */
type FileRole = 'part' | 'program' | 'tools' | 'machine' | 'job' | 'points' | 'file';
interface ChosenFile { file: File; role: FileRole }

/** What can be chosen at the top of the page. */
type TabName = 'plan' | 'check' | 'elements' | 'tour';
/** Those whose work goes on while the page shows how far it is, by the names of their requests. */
type RunTab = 'plan' | 'compare' | 'check' | 'elements' | 'tour';
/** How a tab says how far its run is. */
interface RunWords {
  /** What a plan is counted in. */
  things?: string;
  /** What is done with a program. */
  certifying?: string;
}
/** What a tab shows of its run beside how far it is. */
interface RunShown extends RunWords {
  /** While it goes on. */
  progress?(state: WaitingState | RunningState): void;
  done(state: DoneState): void | Promise<void>;
  /** However it ended. */
  ended(): void;
}

/** How far a search for the best tour is. */
interface SearchProgress {
  stage: 'searching';
  /** The best value so far, and after how many s it was found. */
  best: number; found_s: number;
  /** s at most. */
  left_s?: number;
}
/** How far a comparison is. */
interface CountProgress {
  stage: 'counting';
  /** What is counted. */
  things: string;
  done: number; most: number;
  /** s; absent: not known. */
  left_s?: number;
}
/** How far a plan is. */
interface PlanProgress {
  stage: 'planning' | 'certifying';
  /** Candidates that are done, and how many there may be; of a check pieces of work. */
  done: number; most: number;
  /** s, of a plan at most; absent: not known. */
  left_s?: number;
}

/** Of a plan or a check: GET /plan/{id} and its events. */
type WorkState = WaitingState | RunningState | FailedState | DoneState;
/** `ahead`: plans before it. */
interface WaitingState { state: 'waiting'; ahead: number }
/** `seconds`: since it began. */
interface RunningState { state: 'running'; progress?: PlanProgress | CountProgress | SearchProgress; seconds: number }
/** `message`: why it failed. */
interface FailedState { state: 'failed' | 'cancelled'; message?: string }
interface DoneState {
  state: 'done';
  /** From its beginning to its end. */
  seconds: number;
  /** '': of a tour, which has none. */
  verdict: string;
  /** What was noticed. */
  messages: string[];
  /** Addresses by name: 'program', 'certificate', ..., of several set-ups 'program-1', ... */
  results: Record<string, string>;
  /** In the browser itself: the worst one of a plan or a check. */
  certificate?: Certificate;
}

/** What the page reads of a certificate (docs/certificate.schema.json). */
interface Certificate {
  verdict: string;
  /** Of the whole program; null: no finite number. */
  time_s: number | null; feed_mm: number | null; retracts: number; uncut_thickness_mm: number | null; engagement: { max_deg: number | null };
  features: { clean: boolean }[];
  faults: CertificateFault[];
  conditions: Condition[];
}
interface CertificateFault {
  kind: string;
  feature: string;
  /** Of the program; 0: of no line. */
  line: number;
  text: string;
}
/** POST /info. */
interface InfoAnswer { state?: string; message?: string; info?: PartInfo | SetupInfos | null }

/** From and to. */
interface Extent { x: [number, number]; y: [number, number] }
/** An option of the command that answers what is asked of a drawing. */
interface DrawingAnswer { option: string; value: string }
/** null: not stated. */
interface StockInfo { extent_mm: Extent; z_bottom: number; z_top: number }
interface PartInfo { stock: StockInfo | null; asks: string[]; answers: DrawingAnswer[]; found: Found[]; features: FeatureInfo[]; outlines: OutlineInfo[]; tools: ToolInfo[] }
/** Of a tool library or the part's file. */
interface ToolInfo { number: number; kind: string; diameter_mm: number; teeth: number; name: string }
/** Of a job with several set-ups. */
interface SetupInfos { setups: PartInfo[] }
/** What was mended, left out or is worth a word. */
interface Found { kind: 'note' | 'repair' | 'warning' | 'skipped'; where: string; what: string }
interface FeatureInfo { name: string; kind: string; source?: string; top_z: number; floor_z: number; extent_mm: Extent | null; /** Data of an SVG path, y up, filled by the even-odd rule. */ path: string }
/** A floor of the part in the picture from above. */
interface FloorDrawn { path: string; opacity: number; title: string }
/** Where the numbers of outlines stand in the drawing, y down, and whether in a circle. */
interface NumberPlace { x: number; y: number; isCircle: boolean; text: string }
interface OutlineInfo {
  number: number;
  layer: string;
  /** As it is called after something was said of it; `layer` is how the drawing calls it. */
  layerNow?: string;
  extent_mm: Extent | null;
  /** Data of an SVG path, y up; null: one of too many to be drawn. */
  path: string | null;
  area_mm2: number;
  /** Of a circle; null: it is none. */
  diameter_mm: number | null;
  /** Number of the outline around it; null: none. */
  within: number | null;
  /** null: not said yet. */
  depth_mm: number | null;
  /** What it is read as; '': not said yet. */
  role: string;
  /** Somebody said it; else it is how the outline is read by itself. */
  says_role: boolean;
}

/** A strategy that was planned and certified, or why it was not. */
type StrategyRun = PlannedRun | RefusedRun;
interface RefusedRun { strategy: string; planned: false; refusal: string }
interface PlannedRun {
  strategy: string; planned: true; clean: boolean; fastest: boolean;
  time_s: number | null; feed_mm: number | null; retracts: number; engagement_max_deg: number | null; uncut_thickness_mm: number | null;
}

/** GET /options: of each command. */
type Options = Record<string, CommandOption[]>;
interface CommandOption {
  names: string[]; positional: boolean; group: string; help: string; value: string; values: string[]; many: boolean; file?: boolean;
  /** Whom it is for, whether there are no other values, what its numbers are counted in, its default, and whether an operation may have it. */
  place?: { level: 'first' | 'rest' | 'research'; choice: boolean; unit: string; default: string; operations: boolean } | null;
  job: { table: JobTable; key: string; opposite: boolean; number: boolean } | null;
}

/** The way to the pipeline, by a server or in the browser itself. */
interface Pipeline {
  /** What happens to files, where it is not what the page says. */
  promise: string;
  /** Why STEP solids are not read here, and what to do instead; '': they are. */
  noSolids: string;
  options(): Promise<Options>;
  /** Begins a plan, or what else goes on for long; gives its name. */
  begin(what: RunTab, form: FormData): Promise<string>;
  /** Ends a plan and forgets it. */
  drop(id: string): Promise<void>;
  /** Calls `hear` with each state of a plan until its last, `broken` where none comes any more. Gives what ends that. */
  follow(id: string, hear: (state: WorkState) => void, broken: (error: Error) => void): () => void;
  /** What a part holds. */
  info(form: FormData): Promise<InfoAnswer>;
}

/** Of design elements on a grid, as the options of `clearcut elements` are named. */
type ElementKind = 'pocket' | 'line' | 'arc' | 'hole' | 'slot';
/** A line of the table of elements. */
interface ElementRow { line: HTMLTableRowElement; kind: HTMLSelectElement; numbers: HTMLInputElement; tool: HTMLInputElement; depth: HTMLInputElement }

/** s since the search began, and the best value from then on. */
type TourSample = [number, number];
/** The JSON of `clearcut tour`. */
interface TourFound {
  objective: number; objective_name: string; length: number; turns: number; bound: number; bound_basis: string;
  /** null: not finite. */
  gap: number | null;
  time_s: number; method: string; convergence: TourSample[]; tour: number[];
}

type MiddleName = 'drawing' | 'machining' | 'compare';
/** Where the field of an option stands. */
type FieldPlace = 'drawing' | 'stock' | 'holding' | 'tools' | 'machine' | 'cutting' | 'research';
/** Fields of options, and where what they say is kept. */
interface FieldsOf {
  /** Of the fields' ids. */
  prefix: string;
  /** Names of files that an option may name. */
  files(): string[];
  /** Of an option; [] of a flag that is set, undefined where nothing is said. */
  values(name: string): string[] | undefined;
  say(name: string, values: string[] | null): void;
}

/** A tool of the shop: mm, degrees; `more` by the keys of the fields of tools. */
interface ToolSaid { isOn: boolean; kind: string; diameter: string; more: Record<string, string> }
interface ToolField { key: string; label: string; isLength?: boolean; values?: string[]; word(value: string): string }
/** Of an outline, by the option --op; '': as it is read, which is `role`. mm. */
interface OutlineSaid { kind: string; depth: string; role: string }
/** Of an operation: left out, the number of its tool or '', and options of its own. */
interface OperationSaid { isOff: boolean; tool: string; answers: Record<string, string[]> }
/** The block, mm; bottom '': not said. */
interface StockSaid { margin: string; bottom: string; top: string }
/** Everything that was said of a part. */
interface Project {
  files: ChosenFile[];
  /** By the names of options; [] of a flag. mm. */
  answers: Record<string, string[]>;
  given: DrawingAnswer[];
  /** By the numbers of outlines. */
  outlines: Record<string, OutlineSaid>;
  tools: ToolSaid[];
  /** The tools of the table were chosen for this part. */
  saysTools: boolean;
  /** By the keys of rows. */
  operations: Record<string, OperationSaid>;
  /** Keys of rows in the order of work; []: nobody has said it. */
  sequence: string[];
  stock: StockSaid;
}
/** Features that are one row of the list of operations. */
interface OperationRow { key: string; kind: string; source: string; features: FeatureInfo[] }
/** What the part holds, as it was read last by the options `readBy`. */
interface PartRead { asked: number; outlines: OutlineInfo[]; features: FeatureInfo[]; stock: StockInfo | null; isAsked: boolean; isOfSetups: boolean; isReady: boolean; readBy: string }
/** What the command is asked: the name of its input, options, and files that were made for it. */
interface PlanAsked { input: string; options: string; files: File[] }
/** What a job says that options cannot. */
interface JobMore { operations: string; stock: string; sequence: string[] }
/** In the drawing, mm. */
interface Place2 { x: number; y: number }
interface Clamp { x: [number, number]; y: [number, number]; z: [number, number] }
/** A place on a profile: `along` it, mm, and how far `away` it is. */
interface OnProfile extends Place2 { curve: SVGPathElement; along: number; away: number }
/** A file within a project file. */
interface PackedFile { name: string; text?: string; base64?: string }
/** A project file. */
interface ProjectJson {
  clearcut: string; version: number; files: PackedFile[];
  page?: Omit<Project, 'files'> & { roles: { name: string; role: FileRole }[] };
}

/** A job file and the options that it has no words for. */
interface JobText { text: string; left: string[] }
/** Lines of a job file by their tables. */
interface JobTables { lines: Record<JobTable, string[]>; lists: Record<JobTable, Record<string, string[]>>; each: string[] }
type JobTable = 'part' | 'tools' | 'machine' | 'plan' | 'output';
/** Where a job says an option. */
interface JobKey { table: JobTable; key: string; opposite: boolean; number: boolean; flag: boolean; many: boolean }

/** The elements of index.html by their ids; a test holds them to it. */
interface PageElements {
  'tab-plan': HTMLButtonElement;
  'tab-check': HTMLButtonElement;
  'tab-elements': HTMLButtonElement;
  'tab-tour': HTMLButtonElement;
  'research-go': HTMLButtonElement;
  'undo': HTMLButtonElement;
  'redo': HTMLButtonElement;
  'project-new': HTMLButtonElement;
  'project-save': HTMLButtonElement;
  'lengths': HTMLSelectElement;
  'promise': HTMLParagraphElement;
  'plan': HTMLElement;
  'plan-form': HTMLFormElement;
  'plan-drop': HTMLDivElement;
  'plan-files': HTMLInputElement;
  'example-go': HTMLButtonElement;
  'plan-kinds': HTMLParagraphElement;
  'plan-list': HTMLUListElement;
  'unused': HTMLParagraphElement;
  'found-box': HTMLDetailsElement;
  'found-title': HTMLElement;
  'found': HTMLUListElement;
  'drawing-card': HTMLDetailsElement;
  'drawing-now': HTMLSpanElement;
  'fields-drawing': HTMLDivElement;
  'outlines-box': HTMLDetailsElement;
  'outlines-title': HTMLElement;
  'outlines': HTMLTableElement;
  'stock-box': HTMLDetailsElement;
  'stock-now': HTMLSpanElement;
  'stock-margin': HTMLInputElement;
  'stock-bottom': HTMLInputElement;
  'stock-top': HTMLInputElement;
  'zero-pick': HTMLButtonElement;
  'fields-stock': HTMLDivElement;
  'tools-box': HTMLDetailsElement;
  'tools-now': HTMLSpanElement;
  'tools-note': HTMLParagraphElement;
  'tool-table': HTMLTableElement;
  'tool-add': HTMLButtonElement;
  'tools-save': HTMLButtonElement;
  'fields-tools': HTMLDivElement;
  'machine-box': HTMLDetailsElement;
  'machine-now': HTMLSpanElement;
  'fields-machine': HTMLDivElement;
  'operations-box': HTMLDetailsElement;
  'operations-now': HTMLSpanElement;
  'operations': HTMLOListElement;
  'operations-note': HTMLSpanElement;
  'operations-free': HTMLButtonElement;
  'cutting-box': HTMLDetailsElement;
  'cutting-now': HTMLSpanElement;
  'fields-cutting': HTMLDivElement;
  'holding-box': HTMLDetailsElement;
  'holding-now': HTMLSpanElement;
  'tabs-place': HTMLButtonElement;
  'clamp-draw': HTMLButtonElement;
  'fields-holding': HTMLDivElement;
  'research-box': HTMLDetailsElement;
  'research-now': HTMLSpanElement;
  'fields-research': HTMLDivElement;
  'plan-command': HTMLElement;
  'plan-go': HTMLButtonElement;
  'plan-cancel': HTMLButtonElement;
  'plan-again': HTMLInputElement;
  'compare-go': HTMLButtonElement;
  'compare-cancel': HTMLButtonElement;
  'plan-status': HTMLDivElement;
  'show-drawing': HTMLButtonElement;
  'show-machining': HTMLButtonElement;
  'show-compare': HTMLButtonElement;
  'invitation': HTMLDivElement;
  'plan-progress': HTMLProgressElement;
  'readings': HTMLDivElement;
  'readings-question': HTMLParagraphElement;
  'readings-list': HTMLDivElement;
  'given': HTMLParagraphElement;
  'given-words': HTMLSpanElement;
  'given-again': HTMLButtonElement;
  'compare-status': HTMLDivElement;
  'compare-progress': HTMLProgressElement;
  'compare-result': HTMLDetailsElement;
  'comparison': HTMLTableElement;
  'beside-choice': HTMLParagraphElement;
  'beside-go': HTMLButtonElement;
  'beside': HTMLDivElement;
  'beside-panes': HTMLDivElement;
  'beside-play': HTMLButtonElement;
  'beside-scrub': HTMLInputElement;
  'beside-clock': HTMLSpanElement;
  'beside-by': HTMLSelectElement;
  'plan-result': HTMLDivElement;
  'plan-verdict': HTMLElement;
  'plan-summary': HTMLSpanElement;
  'plan-downloads': HTMLUListElement;
  'plan-notes': HTMLDetailsElement;
  'plan-messages': HTMLUListElement;
  'plan-setups': HTMLLabelElement;
  'plan-setup': HTMLSelectElement;
  'plan-report': HTMLIFrameElement;
  'drawing-box': HTMLElement;
  'drawing': SVGSVGElement;
  'drawing-floors': SVGGElement;
  'drawing-curves': SVGGElement;
  'drawing-marks': SVGGElement;
  'drawing-numbers': SVGGElement;
  'outline-menu': HTMLDivElement;
  'floors-caption': HTMLElement;
  'drawing-caption': HTMLElement;
  'drawing-size': HTMLSpanElement;
  'drawing-unsaid': HTMLSpanElement;
  'check': HTMLElement;
  'check-form': HTMLFormElement;
  'check-drop': HTMLDivElement;
  'check-files': HTMLInputElement;
  'check-kinds': HTMLParagraphElement;
  'check-list': HTMLUListElement;
  'check-kind': HTMLSelectElement;
  'check-diameter': HTMLInputElement;
  'check-depth-box': HTMLLabelElement;
  'check-depth': HTMLInputElement;
  'check-stock-box': HTMLLabelElement;
  'check-stock': HTMLInputElement;
  'dialect': HTMLSelectElement;
  'fields-check': HTMLDivElement;
  'check-command': HTMLElement;
  'check-go': HTMLButtonElement;
  'check-cancel': HTMLButtonElement;
  'check-status': HTMLDivElement;
  'check-progress': HTMLProgressElement;
  'check-result': HTMLDivElement;
  'check-verdict': HTMLElement;
  'check-summary': HTMLSpanElement;
  'check-downloads': HTMLUListElement;
  'check-faults': HTMLUListElement;
  'check-report': HTMLIFrameElement;
  'check-lines-title': HTMLHeadingElement;
  'check-lines': HTMLOListElement;
  'check-notes': HTMLDetailsElement;
  'check-messages': HTMLUListElement;
  'check-text': HTMLPreElement;
  'elements': HTMLElement;
  'elements-form': HTMLFormElement;
  'elements-drop': HTMLDivElement;
  'elements-files': HTMLInputElement;
  'elements-kinds': HTMLParagraphElement;
  'elements-list': HTMLUListElement;
  'elements-editor': HTMLDivElement;
  'elements-table': HTMLTableElement;
  'elements-title': HTMLElement;
  'elements-add': HTMLButtonElement;
  'elements-tool-1': HTMLInputElement;
  'elements-tool-2': HTMLInputElement;
  'elements-resolution': HTMLInputElement;
  'elements-stock': HTMLInputElement;
  'elements-solver': HTMLSelectElement;
  'elements-generations-box': HTMLLabelElement;
  'elements-generations': HTMLInputElement;
  'elements-post': HTMLSelectElement;
  'fields-elements': HTMLDivElement;
  'elements-command': HTMLElement;
  'elements-go': HTMLButtonElement;
  'elements-cancel': HTMLButtonElement;
  'elements-status': HTMLDivElement;
  'elements-progress': HTMLProgressElement;
  'elements-result': HTMLDivElement;
  'elements-verdict': HTMLElement;
  'elements-summary': HTMLSpanElement;
  'elements-downloads': HTMLUListElement;
  'elements-notes': HTMLDetailsElement;
  'elements-messages': HTMLUListElement;
  'elements-report': HTMLIFrameElement;
  'elements-text': HTMLPreElement;
  'tour': HTMLElement;
  'tour-form': HTMLFormElement;
  'tour-drop': HTMLDivElement;
  'tour-files': HTMLInputElement;
  'tour-kinds': HTMLParagraphElement;
  'tour-list': HTMLUListElement;
  'tour-lattice': HTMLInputElement;
  'tour-objective': HTMLSelectElement;
  'tour-solver': HTMLSelectElement;
  'tour-time': HTMLInputElement;
  'tour-seed': HTMLInputElement;
  'tour-shape': HTMLSelectElement;
  'fields-tour': HTMLDivElement;
  'tour-command': HTMLElement;
  'tour-go': HTMLButtonElement;
  'tour-cancel': HTMLButtonElement;
  'tour-status': HTMLDivElement;
  'tour-progress': HTMLProgressElement;
  'tour-figure': HTMLElement;
  'tour-caption': HTMLElement;
  'tour-high': HTMLSpanElement;
  'tour-low': HTMLSpanElement;
  'tour-graph': SVGSVGElement;
  'tour-bound': SVGPathElement;
  'tour-curve': SVGPathElement;
  'tour-until': HTMLSpanElement;
  'tour-said': HTMLParagraphElement;
  'tour-result': HTMLDivElement;
  'tour-downloads': HTMLUListElement;
  'tour-figures': HTMLDListElement;
  'tour-notes': HTMLDetailsElement;
  'tour-messages': HTMLUListElement;
  'tour-picture': HTMLImageElement;
}
