"""What notebooks show, and what is kept of a plan where it is pickled."""

from __future__ import annotations

import copyreg
import html
import json
import os
from typing import Any

from . import _core
from ._core import Check, Plan, Table

class SavedPlan:
    """A plan after pickling: its texts and figures as they were, without what it was planned from.

    program, verdict, clean, inputs, faults and conditions (texts), time_s; certificate() and certificate_text(), which name no
    program's file; table(), values(), selection_table(), picture(), page(), segments(), columns() of the moves, write().
    """

    def __init__(self, kept: dict[str, Any]) -> None:
        self._kept = kept
        self.program: str = kept["program"]
        self.verdict: str = kept["verdict"]
        self.clean: bool = kept["clean"]
        self.inputs: list[str] = kept["inputs"]
        self.faults: list[str] = kept["faults"]
        self.conditions: list[str] = kept["conditions"]
        self.time_s: float = kept["time_s"]

    def certificate_text(self) -> str:
        return str(self._kept["certificate"])

    def certificate(self) -> dict[str, Any]:
        found: dict[str, Any] = json.loads(self.certificate_text())
        return found

    def table(self) -> str:
        return str(self._kept["table"])

    def values(self) -> str:
        return str(self._kept["values"])

    def selection_table(self) -> str:
        return str(self._kept["selection_table"])

    def picture(self) -> str:
        return str(self._kept["picture"])

    def page(self) -> str:
        return str(self._kept["page"])

    def segments(self) -> str:
        return str(self._kept["segments"])

    def columns(self) -> dict[str, Any]:
        """The moves by the names of their columns: what pandas.DataFrame() takes."""
        return dict(self._kept["columns"])

    def write(self, program: str | os.PathLike[str]) -> None:
        """Writes the program, never over what was read. A certificate that names it is written by the plan itself."""
        _core.write_files([(os.fspath(program), self.program)], self.inputs)

    def _repr_svg_(self) -> str:
        return self.picture()

    def _repr_html_(self) -> str:
        return _page_of(self.verdict, self.faults + self.conditions, self.table(), self.picture())

    def __reduce__(self) -> tuple[Any, ...]:
        return SavedPlan, (self._kept,)

    def __repr__(self) -> str:
        return f"<clearcut.SavedPlan, {self.verdict}, {self.time_s:.1f} s>"


def _kept_of(plan: Plan) -> dict[str, Any]:
    return {
        "program": plan.program,
        "verdict": plan.verdict,
        "clean": plan.clean,
        "inputs": list(plan.inputs),
        "faults": [fault.text for fault in plan.faults],
        "conditions": [condition.text for condition in plan.findings.conditions],
        "time_s": plan.findings.all.time_s,
        "certificate": plan.certificate_text(),
        "table": plan.table(),
        "values": plan.values(),
        "selection_table": plan.selection_table(),
        "picture": plan.picture(),
        "page": plan.page(),
        "segments": plan.segments(),
        "columns": plan.moves.columns(),
    }


def _reduced(plan: Plan) -> tuple[Any, ...]:
    return SavedPlan, (_kept_of(plan),)


def _page_of(verdict: str, reasons: list[str], table: str, picture: str) -> str:
    listed = "".join(f"<li>{html.escape(reason)}</li>" for reason in reasons)
    return (
        f"<div><p><b>{html.escape(verdict)}</b></p>"
        + (f"<ul>{listed}</ul>" if listed else "")
        + f"<pre>{html.escape(table)}</pre>{picture}</div>"
    )


def _svg(self: Plan | Check) -> str:
    return self.picture()


def _html(self: Plan | Check) -> str:
    reasons = [fault.text for fault in self.faults] + [condition.text for condition in self.findings.conditions]
    return _page_of(self.verdict, reasons, self.table(), self.picture())


def _table_html(self: Table) -> str:
    def row(cells: list[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"

    body = "".join(row(cells, "td") for cells in self.rows if cells)
    notes = "".join(f"<p>{html.escape(note)}</p>" for note in self.notes)
    title = f"<caption>{html.escape(self.title)}</caption>" if self.title else ""
    return f"<table>{title}{row(self.columns, 'th')}{body}</table>{notes}"


def install() -> None:
    """Gives the classes what notebooks look for, and tells pickle how a plan is kept."""
    for owner in (Plan, Check):
        setattr(owner, "_repr_svg_", _svg)
        setattr(owner, "_repr_html_", _html)
    setattr(Table, "_repr_html_", _table_html)
    copyreg.pickle(Plan, _reduced)  # type: ignore[arg-type]  # it comes back as a SavedPlan
