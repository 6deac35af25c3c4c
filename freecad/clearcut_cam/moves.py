"""Moves of clearcut as FreeCAD's Path commands, and Path commands as G-code text."""

from __future__ import annotations

import math
from typing import Any, Iterable, Sequence

import Path

# Words that FreeCAD keeps in mm/s and machines read in mm/min.
SPEEDS = ("F",)
ORDER = "XYZABCIJKFSTQRLHDP"


def commands_of(moves: Any) -> list[Any]:
    """The way to where the moves begin, and the moves, unrounded: G0, G1, and arcs with centres from where they begin.

    FreeCAD's feeds are mm/s.
    """
    kinds = [moves.kinds[kind] for kind in moves.kind]
    columns = zip(
        kinds, moves.turn.tolist(), moves.from_x.tolist(), moves.from_y.tolist(), moves.from_z.tolist(), moves.x.tolist(),
        moves.y.tolist(), moves.z.tolist(), moves.center_x.tolist(), moves.center_y.tolist(), moves.feed.tolist(),
    )  # fmt: skip
    found: list[Any] = []
    for kind, turn, from_x, from_y, from_z, x, y, z, center_x, center_y, feed in columns:
        if not found:
            found += [Path.Command("G0", {"Z": from_z}), Path.Command("G0", {"X": from_x, "Y": from_y})]
        words = {name: to for name, to, of in (("X", x, from_x), ("Y", y, from_y), ("Z", z, from_z)) if to != of}
        if turn:
            words = {"X": x, "Y": y, "Z": z, "I": center_x - from_x, "J": center_y - from_y}
        if kind != "rapid":
            words["F"] = feed / 60
        if words.keys() - {"F"}:
            found.append(Path.Command("G0" if kind == "rapid" else {0: "G1", 1: "G3", -1: "G2"}[turn], words))
    return found


def text_of(commands: Iterable[Any], tool: Any, spindle: float) -> str:
    """The path of one operation as a program of its own: what FreeCAD's posts say around it, and every word unrounded."""
    lines = ["G21", "G17 G40 G49 G54 G80 G90 G91.1 G94", f"T{tool.number} M6", f"G43 H{tool.number}", f"M3 S{spindle:g}"]
    lines += [line_of(command) for command in commands]
    return "\n".join([*lines, "M5", "M2", ""])


def line_of(command: Any) -> str:
    if command.Name.startswith("("):
        return ""
    words = command.Parameters
    return " ".join([command.Name, *(_word(name, words[name]) for name in ORDER if name in words)])


def _word(name: str, value: float) -> str:
    number = f"{value * 60 if name in SPEEDS else value:.9f}".rstrip("0").rstrip(".")
    return name + ("0" if number in ("-0", "") else number)


def points_of(commands: Sequence[Any]) -> list[tuple[float, float, float]]:
    """Where each of these moves ends; words that are not said stay as they were."""
    at = {"X": math.nan, "Y": math.nan, "Z": math.nan}
    found = []
    for command in commands:
        if command.Name in ("G0", "G1", "G2", "G3"):
            at |= {name: value for name, value in command.Parameters.items() if name in at}
            found.append((at["X"], at["Y"], at["Z"]))
    return found
