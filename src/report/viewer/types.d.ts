// Types of the report page's scripts, for the checker (`make lint-viewer`); no page holds this file. Lengths are mm, times s, angles
// rad, unless a name says otherwise. The job is what html.cpp writes.

/** Smallest x and y, greatest x and y; mm. */
type Corners = [number, number, number, number];

/** Moves as columns of differences, one entry for each move: whole micrometres from one end to the next, times in 0.1 ms. */
interface MoveColumns {
  /** One digit for each move: its index among KINDS. */
  kinds: string;
  x: number[]; y: number[]; z: number[];
  t: number[];
  /** Differences of line numbers. */
  line: number[];
  /** Moves that begin elsewhere than the one before ended: index, and x, y, z in micrometres. */
  starts: [number, number, number, number][];
  /** Index, centre less start in x and y in micrometres, 1 counter-clockwise or -1. */
  arcs: [number, number, number, number][];
  /** Moves from which on another feed holds: index, mm/min; 0 for rapids. */
  feeds: [number, number][];
  sections: JobSection[];
}

/** All work of one tool on one feature. */
interface JobSection {
  label: string;
  /** Index of the feature, -1: none. */
  feature: number;
  /** Index of the tool, -1: not known. */
  tool: number;
  /** Index of its first move. */
  first: number;
  /** Of what was cut before: nothing is left below this height; null: nothing at any. Absent otherwise. */
  below?: number | null;
}

/** A cutter. What nobody stated is null, or 0 where it is no length otherwise. */
interface JobTool {
  /** Number. */
  n: number;
  /** Diameter. */
  d: number;
  /** Radius of the corners, that of a ball likewise. */
  r: number;
  /** Length of the flutes. */
  f: number | null;
  /** Of a cone: how much the radius grows for each mm of height. */
  a: number | null;
  /** Diameter at the tip. */
  t: number;
  /** Diameter of the shank. */
  k: number;
  /** From the tip to the holder. */
  s: number | null;
  /** Diameter of the holder. */
  h: number;
  /** In words. */
  w: string;
}

/** What is to be cut, and how that came out. */
interface JobFeature {
  name: string;
  floor: number; top: number;
  /** Outline as path data: M, L, A with equal radii, Z. */
  path: string;
  time: number | null;
  /** Thickness of what is left at most. */
  left: number | null;
  /** Depth of the deepest gouge. */
  gouge: number | null;
  /** null: not asked. */
  clean: boolean | null;
  /** Where the cutter's centre may be at the floor: areas and lines as path data; and the cutter's diameter. Absent where all is clean. */
  reach?: { centers: string; lines: string; d: number };
}

interface JobFault {
  kind: string;
  feature: string;
  /** The place; null: none is known. */
  x: number | null; y: number | null; z: number | null;
  /** A few words. */
  head: string;
  /** Of the program; 0: of no line. */
  line: number;
  text: string;
}

/** Of the whole program; null: no finite number. */
interface JobFigures {
  time_s: number | null; feed_mm: number | null; rapid_mm: number | null; retracts: number;
  /** Per cent by which the feed of levels that clear areas exceeds the least possible at most; null: no level has a bound. */
  percent_above_bound: number | null;
  uncut_thickness_mm: number | null; gouge_mm: number | null; rapid_in_material: number; max_deg: number | null;
}

interface Job extends MoveColumns {
  name: string;
  clean: boolean;
  /** CLEAN, CONDITIONAL or FAULTY, perhaps followed by more words. */
  verdict: string;
  /** Whether a part was stated: else what is left and what is gouged was not asked. */
  asked: boolean;
  /** Colour of what is left, "#rrggbb", as all colours here. */
  bad: string;
  /** Heights of the stock's top and of the lowest cut. */
  top: number; bottom: number;
  /** Colours of 256 heights from `bottom` to `top`. */
  shades: string[];
  stock: Corners | null;
  /** Height of the stock's lower side. */
  stock_z: number | null;
  /** What the page shows. */
  world: Corners;
  /** Clamps: plan, lower and upper side. */
  keep_outs: [number, number, number, number, number, number][];
  tools: JobTool[];
  features: JobFeature[];
  faults: JobFault[];
  conditions: Condition[];
  figures: JobFigures;
  /** Degrees, the largest on each move; null: not measured. */
  engagement: number[] | null;
  /** N, likewise; null: the material of the work is not known. */
  force: number[] | null;
  /** What was cut before the program begins. */
  earlier: MoveColumns | null;
  /** The program's lines; none: not known. */
  program: string[];
}

/** Moves as columns of absolute values. */
interface Moves {
  kind: Uint8Array;
  x0: Float64Array; y0: Float64Array; z0: Float64Array;
  x1: Float64Array; y1: Float64Array; z1: Float64Array;
  /** Since the beginning; one more than there are moves. */
  t: Float64Array;
  line: Int32Array;
  /** mm/min; 0: rapid. */
  feed: Float64Array;
  section: Uint32Array;
  /** Centre of an arc. */
  cx: Float64Array; cy: Float64Array;
  /** 1 counter-clockwise, -1 clockwise, 0: a line. */
  turn: Int8Array;
  /** Of each section its tool, and the height below which nothing of what it cut is left. */
  tools: number[]; below: (number | null)[];
}

/** A place in plan, mm; or a point of the stage, pixels from its upper left corner. */
interface Point { x: number; y: number }
/** A place in space, mm. */
interface Place extends Point { z: number }
type Triple = [number, number, number];

type Context2D = CanvasRenderingContext2D;

/** A unit of length: its name, how many make a mm, that of its feeds, and decimals that it needs more than mm. */
interface Unit { per: number; name: string; feed: string; more: number }

/** Which class each move belongs to, by its index; the colours of the classes; and what the legend says of them or of both ends. */
interface Coloring {
  of: (i: number) => number;
  colors: string[];
  words?: string[];
  from?: string; to?: string;
}

/** Columns and rows of cells: from, up to and not with. May be fractions, or empty. */
interface CellBox { x0: number; y0: number; x1: number; y1: number }
/** The same in whole cells: first column and row, and how many. */
interface CellPart { x0: number; y0: number; w: number; h: number }
/** Plan of a piece of a move in cells: both ends; of an arc its centre, radius, first angle and positive sweep, rad, rows downwards. */
interface Strip { ax: number; ay: number; bx: number; by: number; arc: { x: number; y: number; r: number; from: number; sweep: number } | null }
/** A cutter's end: mm above the tip by sixteenths of a cell from the axis, its reach in cells, mm above the tip at the reach. */
interface CutterEnd { above: Float32Array; full: number; lip: number }
/** Heights over a rectangle of the plan, row by row from the greatest y, at the middles of the cells. */
interface Grid {
  /** The upper left corner, mm; cells per mm; columns and rows. */
  x0: number; y1: number; scale: number; width: number; height: number;
  /** Columns and rows of the stock: from, up to and not with. */
  block: CellBox;
  /** Plan of the stock within the grid. */
  edges: Corners;
  heights: Float32Array;
  /** Of hollows that an earlier set-up cut from below; empty where there was none. */
  ceilings: Float32Array;
  ends: CutterEnd[];
  /** Cells that have changed since the flat picture and since the view in space were drawn last. */
  dirty: CellBox; soiled: CellBox;
  relief: HTMLCanvasElement;
  /** What is left at the end; null: not looked for yet. */
  rests: HTMLCanvasElement | null;
}
/** A grid as the graphics processor has it: pieces of its tiles by their least size in cells, and the units of its textures. */
interface Surface {
  grid: Grid;
  textures: { heights: WebGLTexture; rests: WebGLTexture };
  units: { heights: number; rests: number };
  array: WebGLVertexArrayObject; corners: WebGLBuffer; indices: WebGLBuffer;
  /** How many pieces the buffer holds, and how many the indices suffice for. */
  quads: number; room: number;
  tiles: Record<number, Uint8Array>[]; across: number; down: number;
  /** What the buffer holds, and how often the heights have changed. */
  key: string; version: number;
  restsLoaded: boolean;
}
/** Heights when the machine was about to begin a move. */
interface Snapshot { move: number; heights: Float32Array }

/** A curve of the plot: the value of each move, the greatest of all, and how it is drawn. */
interface PlotStrip { value: (i: number) => number; most: number; color: string; alpha: number; words: string }
/** A curve and where it lies on the canvas: y of its upper side, height and width in pixels. */
interface PlacedStrip extends PlotStrip { y: number; h: number; w: number }

/** A linked program with the places of its uniforms by name. */
interface Shader { program: WebGLProgram; uniforms: Record<string, WebGLUniformLocation | null> }
/** What a uniform is given: a whole number as {i: number}, else a number, a vector or a matrix. */
type UniformValue = { i: number } | number | number[] | Float32Array;
type UniformValues = Record<string, UniformValue>;
/** Corners in a buffer, ready to be drawn. */
interface Mesh { array: WebGLVertexArrayObject; count: number }
/** Lines in a buffer; `key` says of what they were made. */
interface LineBuffer { array: WebGLVertexArrayObject; buffer: WebGLBuffer; count: number; key: string }
/** Of a cutter's outline: radius, height above the tip, and 0 where it cuts, 1 shank, 2 holder. */
type ProfileRow = Triple;
/** A rectangle of the surface: columns and rows of its corners, and whether it is level. */
type Piece = [number, number, number, number, boolean];
/** How finely the view in space is drawn: cells of a step, samples of a pixel, pixels for each of the stage's. */
interface Detail { step: number; samples: number; share: number }
/** A frame buffer of a size with its parts. */
interface FrameBuffer { key: string; frame: WebGLFramebuffer; parts: WebGLRenderbuffer[] }
/** What the viewer in space sees in each direction of the screen, in the part's frame. */
interface CameraAxes { right: Triple; up: Triple; near: Triple }
/** What of an operation's change is shown: the stock before it, after it, or both parted by a curtain. */
type ChangeShown = 'none' | 'before' | 'after' | 'both';
type Standpoint = 'iso' | 'top' | 'front' | 'right';

/** The elements of body.html by their ids; a test holds them to it. */
interface PageElements {
  'title': HTMLHeadingElement;
  'unit': HTMLSelectElement;
  'tiles': HTMLDListElement;
  'work': HTMLElement;
  'tools': HTMLDivElement;
  'views': HTMLDivElement;
  'finished': HTMLButtonElement;
  'color-by': HTMLSelectElement;
  'more-tools': HTMLDetailsElement;
  'more-panel': HTMLDivElement;
  'path': HTMLSelectElement;
  'rapids': HTMLInputElement;
  'operation': HTMLSelectElement;
  'layer': HTMLSelectElement;
  'section-box': HTMLSpanElement;
  'section': HTMLSelectElement;
  'change': HTMLSpanElement;
  'stage': HTMLDivElement;
  'space': HTMLCanvasElement;
  'overlay': HTMLCanvasElement;
  'space-note': HTMLSpanElement;
  'section-slider': HTMLDivElement;
  'section-at': HTMLInputElement;
  'section-place': HTMLOutputElement;
  'curtain': HTMLInputElement;
  'zoom': HTMLDivElement;
  'zoom-in': HTMLButtonElement;
  'zoom-out': HTMLButtonElement;
  'fit': HTMLButtonElement;
  'measure': HTMLButtonElement;
  'legend': HTMLDivElement;
  'path-note': HTMLSpanElement;
  'change-note': HTMLSpanElement;
  'measured': HTMLOutputElement;
  'controls': HTMLDivElement;
  'play': HTMLButtonElement;
  'back': HTMLButtonElement;
  'forward': HTMLButtonElement;
  'scrub': HTMLInputElement;
  'clock': HTMLSpanElement;
  'speed': HTMLSelectElement;
  'timeline': HTMLDivElement;
  'plot': HTMLCanvasElement;
  'verdict-box': HTMLDivElement;
  'verdict': HTMLElement;
  'reason': HTMLSpanElement;
  'faults': HTMLUListElement;
  'conditions': HTMLUListElement;
  'now': HTMLDListElement;
  'program-box': HTMLDivElement;
  'program': HTMLDivElement;
  'program-space': HTMLDivElement;
  'features-title': HTMLHeadingElement;
  'features': HTMLTableElement;
}
