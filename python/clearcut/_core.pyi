"""The compiled part of clearcut, as far as types are concerned. The texts are in the module itself: help(clearcut.Plan)."""

import os
from typing import Any, Callable, Iterable, Sequence, TypedDict

import numpy
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Unpack

__version__: str

Floats = NDArray[numpy.float64]
Integers = NDArray[numpy.int32]
Length = float | str
Feed = float | str
AnyTool = str | Tool | LibraryTool

class InputError(ValueError): ...
class Cancelled(RuntimeError): ...
class InternalError(RuntimeError): ...

class Reading(TypedDict, total=False):
    """What may be said of a file that does not say it itself."""

    unit: str | None
    layers: Sequence[str]
    ops: Sequence[str]
    top: float | None
    depth: float | None
    scale: float | None
    join_gap: float | None
    open_curves: str | None
    strokes: str | None
    letters: str | None
    up: str
    turn: float
    body: str
    breakthrough: float | None
    drills: Sequence[float]
    mirror: bool
    origin: str | None

class Settings(TypedDict, total=False):
    """The attributes of PlanOptions as keywords."""

    tools: AnyTool | Sequence[AnyTool]
    strategy: str | None
    stepover: float | str | None
    angle: float | None
    stepdown: Length | None
    allowance: Length | None
    allowance_floor: Length | None
    engagement: float | None
    entry: str | None
    entry_angle: float | None
    lead: Length | None
    lead_angle: float | None
    scallop: Length | None
    direction: str | None
    order: str
    start: tuple[float, float] | None
    toolpaths: str | None
    feed: Feed | None
    plunge_feed: Feed | None
    ramp_feed: Feed | None
    slot_feed: Feed | None
    lead_feed: Feed | None
    link_feed: Feed | None
    spindle: float | None
    coolant: str | None
    helix_diameter: Length | None
    helix_min: Length | None
    lead_overlap: Length | None
    overrun: Length | None
    stock_oversize: Length | None
    link_lift: Length | None
    slot_angle: float | None
    feed_by: str | None
    reference_engagement: float | None
    reference_feed: Feed | None
    feed_cap: Feed | None
    margin: bool
    margin_at_least: Length | None
    margin_uncut: Length | None
    margin_gouge: Length | None
    rest: bool | None
    finish: str | None
    finish_stock: Length | None
    finish_stock_floor: Length | None
    finish_depths: float | None
    finish_steps: float | None
    spring_passes: float | None
    compensation: str | None
    wear_range: Length | None
    copies: str | None
    nest: str | None
    nest_with: Sequence[str]
    gap: Length | None
    edge: Length | None
    count: int | None
    subprograms: bool
    dogbones: str | None
    style: str | None
    material: str | None
    tabs: int
    tab_spacing: Length | None
    tab_at: Sequence[tuple[float, float]]
    tab_shape: str
    tab_width: Length
    tab_height: Length | None
    skin: Length | None
    predrilled: Sequence[tuple[float, float, float]]
    keep_out: Sequence[str]
    after: str | os.PathLike[str] | None
    machine: Machine | str | os.PathLike[str]
    rapid: Feed
    acceleration: float
    junction_deviation: float
    accept: Sequence[str]
    post: str
    inch: bool
    program_name: str
    decimals: int | None
    arcs: bool
    tool_change: bool
    length_offset: bool
    exact_stop: bool
    corner_tolerance: Length | None
    spindle_wait: float | None
    program_number: int | None
    work_offset: str
    end_position: str | None
    block_numbers: bool
    optional_stop: bool
    passage: str | None
    reflex: str | None
    grid: str | None
    solver: str | None
    generations: int | None
    population: int | None
    selection: str | None
    crossover: str | None
    mutation: str | None
    crossover_rate: float | None
    mutation_rate: float | None
    most_shared: float | None
    objective: str
    time: float | None
    seed: int
    threads: int

class Region:
    @property
    def outer(self) -> Floats: ...
    @property
    def islands(self) -> list[Floats]: ...
    @property
    def area(self) -> float: ...
    @property
    def box(self) -> tuple[float, float, float, float]: ...
    def contains(self, x: float, y: float) -> bool: ...
    def boundary_distance(self, x: float, y: float) -> float: ...
    def polygon(self, chord: float = 0.0002) -> list[Floats]: ...
    polygon_chord: float
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...

class Clearance:
    def __init__(self, region: Region) -> None: ...
    def inset(self, d: float) -> list[Region]: ...
    def insets(self, ascending: Sequence[float]) -> list[list[Region]]: ...
    @property
    def max(self) -> float: ...
    @property
    def centers(self) -> Floats: ...
    def axis(self) -> tuple[Floats, Integers]: ...
    def axis_curve(self, edge: int, chord: float = 0.01) -> Floats: ...
    def fit_lines(self, d: float) -> list[Floats]: ...

def unite(a: Sequence[Region], b: Sequence[Region]) -> list[Region]: ...
def subtract(a: Sequence[Region], b: Sequence[Region]) -> list[Region]: ...
def intersect(a: Sequence[Region], b: Sequence[Region]) -> list[Region]: ...
def inset(region: Region, d: float) -> list[Region]: ...
def dilate(regions: Sequence[Region], d: float) -> list[Region]: ...
def resolve_even_odd(loops: Sequence[ArrayLike]) -> list[Region]: ...

class Tool:
    def __init__(self, text: str) -> None: ...
    number: int
    name: str
    @property
    def kind(self) -> str: ...
    diameter: float
    corner_radius: float
    teeth: int
    flute_length: float | None
    stickout: float | None
    holder_diameter: float
    shank_diameter: float
    max_spindle_rpm: float | None
    center_cutting: bool

class LibraryTool:
    @property
    def tool(self) -> Tool: ...
    @property
    def presets(self) -> list[str]: ...

class Feature:
    @property
    def name(self) -> str: ...
    @property
    def source(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def target(self) -> list[Region]: ...
    @property
    def allowed(self) -> list[Region]: ...
    @property
    def top_z(self) -> float: ...
    @property
    def floor_z(self) -> float: ...
    @property
    def wall_slope_deg(self) -> float: ...
    @property
    def hole_diameter(self) -> float | None: ...
    @property
    def through(self) -> bool: ...

class Diagnostic:
    @property
    def severity(self) -> str: ...
    @property
    def where(self) -> str: ...
    @property
    def what(self) -> str: ...

class Part:
    @property
    def name(self) -> str: ...
    @property
    def source_file(self) -> str: ...
    @property
    def features(self) -> list[Feature]: ...
    @property
    def tools(self) -> list[Tool]: ...
    @property
    def workplan(self) -> list[str]: ...
    clearance_z: float | None
    @property
    def top_z(self) -> float: ...
    @property
    def diagnostics(self) -> list[Diagnostic]: ...
    def to_json(self) -> str: ...
    def to_stepnc(self) -> str: ...

class Job:
    @property
    def part(self) -> Part: ...
    @property
    def options(self) -> PlanOptions: ...

class Machine:
    def __init__(self, kind: str) -> None: ...
    @property
    def name(self) -> str: ...
    acceleration: float
    junction_deviation: float

def read_tools(file: str, unit: str | None = None) -> list[LibraryTool]: ...
def read_machine(file: str) -> Machine: ...
def read_part(file: str, name: str = "", **reading: Unpack[Reading]) -> Part: ...
def read_part_text(text: str, name: str = "", **reading: Unpack[Reading]) -> Part: ...
def read_job(file: str, name: str = "", **reading: Unpack[Reading]) -> Job: ...

class _SetupQuestion:
    def __init__(self, file: str, number: int, earlier: list[tuple[Part, Moves, Findings | None]]) -> None: ...

def _read_setup(question: _SetupQuestion, name: str = "", **reading: Unpack[Reading]) -> Job: ...
def _setup_count(file: str) -> int: ...

class PlanOptions:
    def __init__(self, **settings: Unpack[Settings]) -> None: ...
    def replaced(self, **settings: Unpack[Settings]) -> PlanOptions: ...
    def check(self) -> None: ...
    tools: AnyTool | Sequence[AnyTool]
    strategy: str | None
    stepover: float | str | None
    angle: float | None
    stepdown: Length | None
    allowance: Length | None
    allowance_floor: Length | None
    engagement: float | None
    entry: str | None
    entry_angle: float | None
    lead: Length | None
    lead_angle: float | None
    scallop: Length | None
    direction: str | None
    order: str
    start: tuple[float, float] | None
    toolpaths: str | None
    feed: Feed | None
    plunge_feed: Feed | None
    ramp_feed: Feed | None
    slot_feed: Feed | None
    lead_feed: Feed | None
    link_feed: Feed | None
    spindle: float | None
    coolant: str | None
    helix_diameter: Length | None
    helix_min: Length | None
    lead_overlap: Length | None
    overrun: Length | None
    stock_oversize: Length | None
    link_lift: Length | None
    slot_angle: float | None
    feed_by: str | None
    reference_engagement: float | None
    reference_feed: Feed | None
    feed_cap: Feed | None
    margin: bool
    margin_at_least: Length | None
    margin_uncut: Length | None
    margin_gouge: Length | None
    rest: bool | None
    finish: str | None
    finish_stock: Length | None
    finish_stock_floor: Length | None
    finish_depths: float | None
    finish_steps: float | None
    spring_passes: float | None
    compensation: str | None
    wear_range: Length | None
    copies: str | None
    nest: str | None
    nest_with: Sequence[str]
    gap: Length | None
    edge: Length | None
    count: int | None
    subprograms: bool
    dogbones: str | None
    style: str | None
    material: str | None
    tabs: int
    tab_spacing: Length | None
    tab_at: Sequence[tuple[float, float]]
    tab_shape: str
    tab_width: Length
    tab_height: Length | None
    skin: Length | None
    predrilled: Sequence[tuple[float, float, float]]
    keep_out: Sequence[str]
    after: str | os.PathLike[str] | None
    machine: Machine | str | os.PathLike[str]
    rapid: Feed
    acceleration: float
    junction_deviation: float
    accept: Sequence[str]
    post: str
    inch: bool
    program_name: str
    decimals: int | None
    arcs: bool
    tool_change: bool
    length_offset: bool
    exact_stop: bool
    corner_tolerance: Length | None
    spindle_wait: float | None
    program_number: int | None
    work_offset: str
    end_position: str | None
    block_numbers: bool
    optional_stop: bool
    passage: str | None
    reflex: str | None
    grid: str | None
    solver: str | None
    generations: int | None
    population: int | None
    selection: str | None
    crossover: str | None
    mutation: str | None
    crossover_rate: float | None
    mutation_rate: float | None
    most_shared: float | None
    objective: str
    time: float | None
    seed: int
    threads: int

class Layer:
    @property
    def z_top(self) -> float: ...
    @property
    def z(self) -> float: ...
    @property
    def target(self) -> list[Region]: ...
    @property
    def allowed(self) -> list[Region]: ...
    @property
    def tool_radius(self) -> float: ...
    @property
    def wall_stock(self) -> float: ...
    @property
    def closed_all_round(self) -> bool: ...
    def clearing_area(self) -> ClearingArea: ...

class Pass:
    @property
    def path(self) -> Floats: ...
    @property
    def closed(self) -> bool: ...
    @property
    def parent(self) -> int: ...
    @property
    def component(self) -> int: ...
    @property
    def offset(self) -> float: ...
    @property
    def reversible(self) -> bool: ...

class LayerPasses:
    @property
    def z(self) -> float: ...
    @property
    def legal(self) -> list[Region]: ...
    @property
    def passes(self) -> list[Pass]: ...
    residual: float
    outside_in: bool
    def add(
        self,
        path: ArrayLike,
        closed: bool = True,
        parent: int = -1,
        component: int = 0,
        offset: float = 0.0,
        reversible: bool = True,
    ) -> int: ...

class ClearingComponent:
    @property
    def legal(self) -> Region: ...
    @property
    def rest(self) -> list[Region]: ...
    @property
    def outer_wall(self) -> int: ...

class ClearingArea:
    @property
    def components(self) -> list[ClearingComponent]: ...
    @property
    def walls(self) -> LayerPasses: ...

class Strategy:
    def __init__(
        self, name: str, function: Callable[[Layer], LayerPasses], description: str = "", in_auto: bool = False
    ) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def description(self) -> str: ...

def strategy_names() -> list[str]: ...
def description_of(strategy: str) -> str: ...

class Place:
    @property
    def x(self) -> float: ...
    @property
    def y(self) -> float: ...
    @property
    def z(self) -> float: ...
    @property
    def line(self) -> int: ...

class Fault:
    @property
    def kind(self) -> str: ...
    @property
    def feature(self) -> str: ...
    @property
    def at(self) -> Place: ...
    @property
    def size(self) -> float: ...
    @property
    def text(self) -> str: ...

class Condition:
    @property
    def name(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def line(self) -> int: ...
    @property
    def met_by(self) -> str: ...

class Engagement:
    @property
    def max_deg(self) -> float: ...
    @property
    def max_at(self) -> Place | None: ...
    @property
    def mean_deg(self) -> float: ...
    @property
    def over_limit_mm(self) -> float: ...
    @property
    def histogram_mm(self) -> list[float]: ...
    @property
    def climb_mm(self) -> float: ...
    @property
    def conventional_mm(self) -> float: ...

class Figures:
    @property
    def feed_mm(self) -> float: ...
    @property
    def rapid_mm(self) -> float: ...
    @property
    def plunge_mm(self) -> float: ...
    @property
    def turns(self) -> int: ...
    @property
    def turn_angle_deg(self) -> float: ...
    @property
    def retracts(self) -> int: ...
    @property
    def time_s(self) -> float: ...
    @property
    def waits_s(self) -> float: ...
    @property
    def time_naive_s(self) -> float: ...
    @property
    def uncut_mm2(self) -> float: ...
    @property
    def uncut_thickness_mm(self) -> float: ...
    @property
    def uncut_at(self) -> Place | None: ...
    @property
    def gouge_mm(self) -> float: ...
    @property
    def gouge_at(self) -> Place | None: ...
    @property
    def unreachable_mm2(self) -> float: ...
    @property
    def rapid_in_material(self) -> int: ...
    @property
    def max_axial_mm(self) -> float: ...
    @property
    def engagement(self) -> Engagement: ...
    @property
    def air_cut_mm(self) -> float: ...
    @property
    def lower_bound_mm(self) -> float: ...
    @property
    def clean(self) -> bool: ...

class LayerFindings:
    @property
    def z(self) -> float: ...
    @property
    def figures(self) -> Figures: ...

class FeatureFindings:
    @property
    def name(self) -> str: ...
    @property
    def workingstep(self) -> int: ...
    @property
    def tool_number(self) -> int: ...
    @property
    def tool_diameter(self) -> float: ...
    @property
    def figures(self) -> Figures: ...
    @property
    def layers(self) -> list[LayerFindings]: ...

class Findings:
    @property
    def all(self) -> Figures: ...
    @property
    def features(self) -> list[FeatureFindings]: ...
    @property
    def faults(self) -> list[Fault]: ...
    @property
    def conditions(self) -> list[Condition]: ...
    @property
    def verdict(self) -> str: ...
    def reasons(self) -> str: ...

class Moves:
    kinds: list[str]
    def __len__(self) -> int: ...
    @property
    def x(self) -> Floats: ...
    @property
    def y(self) -> Floats: ...
    @property
    def z(self) -> Floats: ...
    @property
    def from_x(self) -> Floats: ...
    @property
    def from_y(self) -> Floats: ...
    @property
    def from_z(self) -> Floats: ...
    @property
    def center_x(self) -> Floats: ...
    @property
    def center_y(self) -> Floats: ...
    @property
    def length(self) -> Floats: ...
    @property
    def feed(self) -> Floats: ...
    @property
    def time(self) -> Floats: ...
    @property
    def engagement(self) -> Floats: ...
    @property
    def mean_engagement(self) -> Floats: ...
    @property
    def cutting_mm(self) -> Floats: ...
    @property
    def air_mm(self) -> Floats: ...
    @property
    def turn(self) -> NDArray[numpy.int8]: ...
    @property
    def kind(self) -> NDArray[numpy.uint8]: ...
    @property
    def line(self) -> Integers: ...
    @property
    def tool(self) -> Integers: ...
    @property
    def workingstep(self) -> Integers: ...
    def columns(self, *, engagement: bool = False) -> dict[str, Any]: ...

class CandidateResult:
    @property
    def strategy(self) -> str: ...
    @property
    def stepover(self) -> str: ...
    @property
    def outcome(self) -> str: ...
    @property
    def time_s(self) -> float: ...
    @property
    def feed_mm(self) -> float: ...

class StrategySelection:
    @property
    def feature(self) -> str: ...
    @property
    def candidates(self) -> list[CandidateResult]: ...
    @property
    def kept(self) -> str: ...

class _Checked:
    @property
    def part(self) -> Part: ...
    @property
    def program(self) -> str: ...
    @property
    def copies(self) -> dict[str, Any] | None: ...
    @property
    def inputs(self) -> list[str]: ...
    @property
    def findings(self) -> Findings: ...
    @property
    def verdict(self) -> str: ...
    @property
    def clean(self) -> bool: ...
    @property
    def faults(self) -> list[Fault]: ...
    @property
    def diagnostics(self) -> list[Diagnostic]: ...
    @property
    def moves(self) -> Moves: ...
    def certificate_text(self, program_name: str = "") -> str: ...
    def certificate(self, program_name: str = "") -> dict[str, Any]: ...
    def table(self) -> str: ...
    def picture(self) -> str: ...
    def _repr_svg_(self) -> str: ...
    def _repr_html_(self) -> str: ...

class Plan(_Checked):
    @property
    def selections(self) -> list[StrategySelection]: ...
    def values(self) -> str: ...
    def selection_table(self) -> str: ...
    def page(self) -> str: ...
    def segments(self) -> str: ...
    def write(
        self,
        program: str | os.PathLike[str],
        *,
        certificate: str | os.PathLike[str] | None = None,
        picture: str | os.PathLike[str] | None = None,
        page: str | os.PathLike[str] | None = None,
        segments: str | os.PathLike[str] | None = None,
    ) -> None: ...

class Check(_Checked):
    @property
    def dialect(self) -> str: ...
    def page(self) -> str: ...

class Table:
    @property
    def title(self) -> str: ...
    @property
    def columns(self) -> list[str]: ...
    @property
    def rows(self) -> list[list[str]]: ...
    @property
    def notes(self) -> list[str]: ...
    def markdown(self) -> str: ...
    def _repr_html_(self) -> str: ...

class Comparison(Table):
    def numbers(self) -> dict[str, list[Any]]: ...
    @property
    def fastest_clean(self) -> str | None: ...

def write_files(files: Sequence[tuple[str, str]], inputs: Sequence[str] = ()) -> None: ...
def read_file(path: str) -> bytes: ...
def check_witness(program: str, part: str, witness: bytes, uncut: float = 0.01, straight: bool = False, partial: bool = False) -> str: ...
def _plan(
    part: Part, options: PlanOptions, strategies: list[Strategy], progress: Callable[[str, int, int], None] | None, cancel: Any
) -> Plan: ...
def _verify(
    part: Part, program: str | bytes, name: str, options: PlanOptions, dialect: str | None, cancel: Any
) -> Check: ...
def _verify_alone(
    stock: str | None, top: float | None, program: str | bytes, name: str, options: PlanOptions, dialect: str | None, cancel: Any
) -> Check: ...
def _compare(part: Part, options: PlanOptions, strategies: list[Strategy]) -> Comparison: ...
def _explain(part: Part, options: PlanOptions) -> str: ...

class Tour:
    @property
    def points(self) -> Floats: ...
    @property
    def order(self) -> Integers: ...
    @property
    def objective(self) -> float: ...
    @property
    def length(self) -> float: ...
    @property
    def turns(self) -> int: ...
    @property
    def angle_deg(self) -> float: ...
    @property
    def bound(self) -> float: ...
    @property
    def gap(self) -> float: ...
    @property
    def seconds(self) -> float: ...
    def json(self) -> str: ...
    def picture(self) -> str: ...

def tour(
    points: ArrayLike | str | os.PathLike[str],
    *,
    objective: str = "length",
    closed: bool | None = None,
    time: float = 10.0,
    seed: int = 1,
    threads: int = 0,
    feed: float = 1000.0,
    diameter: float | None = None,
    engagement: float = 50.0,
    solver: str = "modern",
    generations: int | None = None,
) -> Tour: ...

class Study:
    def columns(self) -> dict[str, Any]: ...
    def table(self) -> Table: ...
    def csv(self) -> str: ...
    def picture(self) -> str: ...

def study(
    name: str,
    *,
    runs: int | None = None,
    generations: int | None = None,
    side: int | None = None,
    objective: str = "length",
    islands: int = 1,
    migrate_every: int = 100,
    migrants: int = 1,
    seed: int = 1,
    threads: int = 0,
    csv: str = "",
    progress: Callable[[int, int], None] | None = None,
) -> Study: ...
def study_names() -> list[str]: ...
def reproduce(table: str) -> Table: ...
def reproducible_tables() -> list[str]: ...
