"""Plans 2.5-D pocket-milling programs and proves them.

    import clearcut

    part = clearcut.read_part("bracket.dxf", depth=5)
    plan = clearcut.plan(part, tools="endmill:6")
    if plan.clean:
        plan.write("bracket.ngc", certificate="bracket.json")

Units     mm, mm/min, degrees and seconds; x right, y up, z the height of the tool's tip.
Errors    InputError for files and wishes that cannot be met, with the command's texts; Cancelled where `cancel` was set;
          KeyboardInterrupt for Ctrl-C. What a plan leaves undone is in its findings and diagnostics, never raised.
Threads   every function may be called from several threads at once; the interpreter's lock is free while they work.
"""

from __future__ import annotations

import difflib
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Iterable, Protocol

from . import _core
from ._core import (
    Cancelled,
    Check,
    Clearance,
    ClearingArea,
    ClearingComponent,
    Comparison,
    Condition,
    StrategySelection,
    CandidateResult,
    Diagnostic,
    Engagement,
    Fault,
    Feature,
    FeatureFindings,
    Figures,
    Findings,
    InputError,
    InternalError,
    Layer,
    LayerFindings,
    LayerPasses,
    LibraryTool,
    Machine,
    Moves,
    Part,
    Pass,
    Place,
    Plan,
    PlanOptions,
    Region,
    Strategy,
    Study,
    Table,
    Tool,
    Tour,
    __version__,
    check_witness,
    description_of,
    dilate,
    inset,
    intersect,
    read_machine,
    read_part_text,
    read_tools,
    reproducible_tables,
    reproduce,
    resolve_even_odd,
    strategy_names,
    study,
    study_names,
    subtract,
    tour,
    unite,
    write_files,
)
from ._notebook import SavedPlan, install as _install
from ._outlines import part, region, regions

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._core import Reading, Settings

    AnyPath = str | os.PathLike[str]
    Progress = Callable[[str, int, int], None]


class Cancel(Protocol):
    """What ends work early: a threading.Event, for example."""

    def is_set(self) -> bool: ...


def read_part(file: AnyPath, **reading: Unpack[Reading]) -> Part:
    _check_reading(reading)
    return _core.read_part(os.fspath(file), **reading)


def read_job(
    file: AnyPath, *, setup: int | None = None, earlier: Iterable[Plan | Check] = (), **reading: Unpack[Reading]
) -> tuple[Part, PlanOptions]:
    """The part of a job file and all that the job asks of its plan; `reading` goes before what the job says.

    Of a job with several set-ups `setup` says which, from 1, and `earlier` gives the plans or checks of all before it, in
    order: its stock is what they leave. plan_setups() does it for all of them.
    """
    name = os.fspath(file)
    _check_reading(reading)
    if setup is None:
        job = _core.read_job(name, **reading)
    else:
        # What is wrong with a program that was checked goes on to what rests on it; a plan says so itself.
        before = [(one.part, one.moves, one.findings if isinstance(one, Check) else None) for one in earlier]
        question = _core._SetupQuestion(name, setup, before)
        job = _core._read_setup(question, **reading)
    return job.part, job.options


def plan(
    part: Part | AnyPath,
    options: PlanOptions | None = None,
    *,
    strategies: Iterable[Strategy] = (),
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    **settings: Unpack[Settings],
) -> Plan:
    """Plans, posts and certifies a part, or the part or job in a file.

    `settings` are the names of PlanOptions and go before `options`. `strategies` are there beside the software's own.
    `progress(stage, done, most)` is called from the threads that plan; what it raises ends the plan. `cancel` is looked at
    every 20 ms, as is Ctrl-C.
    """
    part, options = _asked(part, options, settings)
    return _core._plan(part, options, list(strategies), progress, cancel)


def plan_setups(
    job: AnyPath,
    *,
    reading: Reading | None = None,
    strategies: Iterable[Strategy] = (),
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    **settings: Unpack[Settings],
) -> list[Plan]:
    """Plans every [[setup]] of a job file, each on the stock that those before it leave: one plan each, in order.

    `settings` go before what the job says, for all of them; program numbers count up. Raises InputError for a job without set-ups.
    """
    name = os.fspath(job)
    count = _core._setup_count(name)
    if count == 0:
        raise InputError(f"{name}: has no [[setup]]; plan() plans it")
    plans: list[Plan] = []
    for number in range(1, count + 1):
        part, asked = read_job(name, setup=number, earlier=plans, **(reading or {}))
        options = asked.replaced(**settings)
        plans.append(plan(part, options, strategies=strategies, progress=progress, cancel=cancel))
    return plans


def verify(
    part: Part | AnyPath,
    program: str,
    options: PlanOptions | None = None,
    *,
    name: str = "program",
    dialect: str | None = None,
    cancel: Cancel | None = None,
    **settings: Unpack[Settings],
) -> Check:
    """Checks the text of any program against a part, whoever wrote it. `name` stands in messages."""
    part, options = _asked(part, options, settings)
    return _core._verify(part, program, name, options, dialect, cancel)


def verify_file(
    part: Part | AnyPath,
    program: AnyPath,
    options: PlanOptions | None = None,
    *,
    dialect: str | None = None,
    cancel: Cancel | None = None,
    **settings: Unpack[Settings],
) -> Check:
    """Checks the program in a file against a part, whoever wrote it."""
    name = os.fspath(program)
    part, options = _asked(part, options, settings)
    return _core._verify(part, _core.read_file(name), name, options, dialect, cancel)


def verify_alone(
    program: AnyPath,
    options: PlanOptions | None = None,
    *,
    stock: str | None = None,
    top: float | None = None,
    dialect: str | None = None,
    cancel: Cancel | None = None,
    **settings: Unpack[Settings],
) -> Check:
    """Checks the program in a file as far as can be said without a part: rapids, depths and engagement in `stock`, limits, control.

    `stock` is "100,60,20" (sizes from X 0, Y 0 and down from `top`) or "-5:95,0:60,-20:0", mm; without it the box of what is cut
    below `top` (Z 0, if nothing is cut above it) is taken, which is the condition "stock". What is left and what is gouged is not asked.
    """
    name = os.fspath(program)
    asked = (options or PlanOptions()).replaced(**settings)
    return _core._verify_alone(stock, top, _core.read_file(name), name, asked, dialect, cancel)


def compare(
    part: Part | AnyPath,
    options: PlanOptions | None = None,
    *,
    strategies: Iterable[Strategy] = (),
    **settings: Unpack[Settings],
) -> Comparison:
    """Every strategy on one part, checked alike, as a table; numbers() are its figures. Raises InputError where none can plan it."""
    part, options = _asked(part, options, settings)
    return _core._compare(part, options, list(strategies))


def explain(part: Part | AnyPath, options: PlanOptions | None = None, **settings: Unpack[Settings]) -> str:
    """Every value of a plan and where it comes from, without planning."""
    part, options = _asked(part, options, settings)
    return _core._explain(part, options)


def _check_reading(reading: Any) -> None:
    """Names what a mistyped keyword may have meant."""
    first = (_core.read_part.__doc__ or "").split("\n")[0]
    known = [name for name in re.findall(r"(\w+):", first) if name != "file"]
    for name in reading:
        if name in known:
            continue
        near = difflib.get_close_matches(name, known, 1)
        hint = f"did you mean '{near[0]}'? " if near else ""
        raise TypeError(f"'{name}' says nothing of how a part is read; {hint}there are {', '.join(known)}")


def _asked(given: Part | AnyPath, options: PlanOptions | None, settings: Any) -> tuple[Part, PlanOptions]:
    """A part and its options: those of a job first, then `options`, then `settings`."""
    if isinstance(given, Part):
        return given, (options or PlanOptions()).replaced(**settings)
    file = os.fspath(given)
    if Path(file).suffix != ".toml":
        return read_part(file), (options or PlanOptions()).replaced(**settings)
    if options is not None:
        raise TypeError("a job file has options of its own; change some of them by keywords, or use read_job()")
    if _core._setup_count(file) > 0:
        raise InputError(f"{file}: has several set-ups; use plan_setups(), or read_job() with setup= and earlier=")
    job, asked = read_job(file)
    return job, asked.replaced(**settings)


def _write(
    self: Plan,
    program: AnyPath,
    *,
    certificate: AnyPath | None = None,
    picture: AnyPath | None = None,
    page: AnyPath | None = None,
    segments: AnyPath | None = None,
) -> None:
    """Writes the program and what else is named (JSON, SVG, HTML, segments): all of the files or none, and never over what was read."""
    name = os.fspath(program)
    files = [(name, self.program)]
    if certificate is not None:
        files.append((os.fspath(certificate), self.certificate_text(name)))
    if picture is not None:
        files.append((os.fspath(picture), self.picture()))
    if page is not None:
        files.append((os.fspath(page), self.page()))
    if segments is not None:
        files.append((os.fspath(segments), self.segments()))
    write_files(files, self.inputs)


def _columns(self: Moves, *, engagement: bool = False) -> dict[str, Any]:
    """The moves by the names of their columns, kinds as words: what pandas.DataFrame() takes.

    With `engagement` also what verification measures of each move, which takes as long as that.
    """
    import numpy

    names = ["x", "y", "z", "feed", "time", "length", "line", "tool", "workingstep"]
    names += ["engagement", "mean_engagement", "cutting_mm", "air_mm"] if engagement else []
    table = {name: getattr(self, name) for name in names}
    table["kind"] = numpy.array(Moves.kinds)[self.kind]
    return table


read_part.__doc__ = _core.read_part.__doc__
for owner, name, function in ((Plan, "write", _write), (Moves, "columns", _columns)):
    function.__name__ = name
    setattr(owner, name, function)
del owner, name, function
_install()

__all__ = [
    "Cancel", "Cancelled", "Check", "Clearance", "ClearingArea", "ClearingComponent", "Comparison", "Condition", "StrategySelection",
    "CandidateResult", "Diagnostic", "Engagement", "Fault", "Feature", "FeatureFindings", "Figures", "Findings", "InputError",
    "InternalError", "Layer", "LayerFindings", "LayerPasses", "LibraryTool", "Machine", "Moves", "Part", "Pass", "Place",
    "Plan", "PlanOptions", "Region", "SavedPlan", "Strategy", "Study", "Table", "Tool", "Tour", "__version__", "check_witness", "compare",
    "description_of", "dilate", "explain", "inset", "intersect", "part", "plan", "plan_setups", "read_job", "read_machine", "read_part",
    "read_part_text", "read_tools", "region", "regions", "reproduce", "reproducible_tables", "resolve_even_odd",
    "strategy_names", "study", "study_names", "subtract", "tour", "unite", "verify", "verify_alone", "verify_file", "write_files",
]
