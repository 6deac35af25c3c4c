"""What is left uncut, as shapes: red what the cutter reaches, amber what it cannot reach."""

from __future__ import annotations

import math
from typing import Any, Iterable, Sequence

import FreeCAD
import Part

from . import host, shapes

RED, AMBER = (0.86, 0.08, 0.08), (1.0, 0.68, 0.0)
# Slivers thinner than this are not shown, mm; the certificate counts them.
THINNEST = 0.005
# Faces lie this far above the floor, mm, so that the model's own do not hide them.
ABOVE = 0.05


def left(part: Any, checked: Any, tools: Sequence[Any], stock_to_leave: float = 0.0) -> tuple[list[Any], list[Any]]:
    """Faces on the floors of the features: what is left although a cutter reaches it, and what no cutter reaches."""
    clearcut = host.clearcut()
    uncut = checked.findings.all.uncut_mm2 > 0 or any(fault.kind == "uncut" for fault in checked.faults)
    radius = {tool.number: tool.diameter / 2 for tool in tools}
    red, amber = [], []
    for feature in part.features:
        if "profile" in feature.kind and not uncut:
            continue
        reached: list[Any] = []
        swept: list[Any] = []
        for number, r in radius.items():
            centres = [region for area in feature.allowed for region in clearcut.inset(area, r + stock_to_leave)]
            reached = clearcut.unite(reached, clearcut.dilate(centres, r))
            if uncut:
                swept = clearcut.unite(swept, strips(checked.moves, number, r, feature.floor_z))
        reached = clearcut.intersect(feature.target, reached)
        red += _faces(clearcut.subtract(reached, swept) if uncut else [], feature.floor_z)
        amber += _faces(clearcut.subtract(_shrunk(feature.target, stock_to_leave), reached), feature.floor_z)
    return red, amber


def _shrunk(target: Iterable[Any], by: float) -> list[Any]:
    return [region for area in target for region in host.clearcut().inset(area, by)] if by > 0 else list(target)


def strips(moves: Any, tool: int, radius: float, floor: float) -> list[Any]:
    """What a cutter sweeps at the floor or below it: one region for each move that cuts there."""
    clearcut = host.clearcut()
    low = (moves.z <= floor + 0.02) & (moves.from_z <= floor + 0.02) & (moves.tool == tool) & (moves.kind != moves.kinds.index("rapid"))
    found = []
    for at in low.nonzero()[0]:
        begin, end = (moves.from_x[at], moves.from_y[at]), (moves.x[at], moves.y[at])
        if moves.turn[at]:
            found += _swept_by_arc(begin, end, (moves.center_x[at], moves.center_y[at]), int(moves.turn[at]), radius)
        elif math.dist(begin, end) > shapes.SAME:
            found.append(clearcut.region(_swept_by_line(begin, end, radius)))
    return found


def _swept_by_line(begin: Any, end: Any, radius: float) -> shapes.Rows:
    length = math.dist(begin, end)
    across = (-(end[1] - begin[1]) / length * radius, (end[0] - begin[0]) / length * radius)
    return [
        [begin[0] - across[0], begin[1] - across[1], 0.0], [end[0] - across[0], end[1] - across[1], 1.0],
        [end[0] + across[0], end[1] + across[1], 0.0], [begin[0] + across[0], begin[1] + across[1], 1.0],
    ]  # fmt: skip


def _swept_by_arc(begin: Any, end: Any, center: Any, turn: int, radius: float) -> list[Any]:
    """In pieces of at most a quarter turn, so that no piece meets itself; each is the line's strip bent along the arc."""
    clearcut = host.clearcut()
    big = math.dist(begin, center)
    first = math.atan2(begin[1] - center[1], begin[0] - center[0])
    sweep = (math.atan2(end[1] - center[1], end[0] - center[0]) - first) * turn % (2 * math.pi) or 2 * math.pi
    count = math.ceil(sweep / (math.pi / 2))
    found = []
    for piece in range(count):
        angles = [first + turn * sweep * (piece + share) / count for share in (0, 1)]
        bulge = turn * math.tan(sweep / count / 4)
        points = [(center[0] + big * math.cos(a), center[1] + big * math.sin(a)) for a in angles]
        if big <= radius:
            found += [clearcut.region(_swept_by_line(*points, radius))]
            found.append(clearcut.region([[points[0][0] - radius, points[0][1], 1.0], [points[0][0] + radius, points[0][1], 1.0]]))
            continue
        near, far = ([(center[0] + r * math.cos(a), center[1] + r * math.sin(a)) for a in angles] for r in (big - radius, big + radius))
        right, left_side = (far, near) if turn > 0 else (near, far)
        found.append(clearcut.region([[*right[0], bulge], [*right[1], 1.0], [*left_side[1], -bulge], [*left_side[0], 1.0]]))
    return found


def _faces(regions: Iterable[Any], z: float) -> list[Any]:
    found = []
    for region in regions:
        if host.clearcut().Clearance(region).max * 2 >= THINNEST:
            found.append(shapes.face_of_region(region, z + ABOVE))
    return found


def compound(faces: Sequence[Any]) -> Any:
    return Part.Compound(list(faces)) if faces else Part.Shape()


class Overlay:
    """A shape that shows what `Source` has left; it follows it when that is computed again."""

    def __init__(self, obj: Any, source: Any):
        obj.addProperty("App::PropertyLink", "Source", "Clearcut", "The operation or proof whose rest is shown").Source = source
        obj.addProperty("App::PropertyArea", "Uncut", "Clearcut", "What the cutter reaches and has left, as it is shown", 1)
        obj.addProperty("App::PropertyArea", "OutOfReach", "Clearcut", "What the cutter does not reach, as it is shown", 1)
        obj.Proxy = self

    def execute(self, obj: Any) -> None:
        red, amber = (list(shape.Faces) if shape and not shape.isNull() else [] for shape in (obj.Source.Left, obj.Source.OutOfReach))
        obj.Shape = compound([*red, *amber])
        obj.Uncut, obj.OutOfReach = sum(face.Area for face in red), sum(face.Area for face in amber)
        if FreeCAD.GuiUp and red + amber:
            obj.ViewObject.DiffuseColor = [(*RED, 0.0)] * len(red) + [(*AMBER, 0.0)] * len(amber)

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None

    __getstate__, __setstate__ = dumps, loads


def show(source: Any) -> Any:
    """The overlay of an operation or proof, made if there is none."""
    document = source.Document
    for obj in source.InList:
        if isinstance(getattr(obj, "Proxy", None), Overlay):
            return obj
    obj = document.addObject("Part::FeaturePython", "ClearcutLeft")
    obj.Label = f"Left by {source.Label}"
    Overlay(obj, source)
    if FreeCAD.GuiUp:
        obj.ViewObject.Proxy = 0
        obj.ViewObject.LineColor = RED
    return obj
