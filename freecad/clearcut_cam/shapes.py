"""Shapes of FreeCAD as outlines of clearcut (rows x, y, bulge), and back. Only plan views: heights are left out."""

from __future__ import annotations

import math
from typing import Any, Iterable, Sequence

import Part
from FreeCAD import Vector

Row = list[float]
Rows = list[Row]

# Points that are nearer than this are one, mm.
SAME = 1e-6
# Curves that are neither lines nor circles become arcs within this, mm.
CHORD = 0.001
# What lies beyond the stock counts as free up to here, mm.
AROUND = 1000.0
# Sections are taken this far from heights where something ends, mm.
BESIDE = 1e-3


def rows_of_wire(wire: Any) -> Rows:
    """A closed wire; the bulge is tan(angle / 4) of the arc that leaves a vertex, positive counter-clockwise."""
    pieces = [piece for edge in wire.OrderedEdges for piece in [_pieces(edge)] if piece]
    rows: Rows = []
    at = _start(pieces)
    for piece in pieces:
        if at.distanceToPoint(piece[0][0]) > at.distanceToPoint(piece[-1][1]):
            piece = [(end, begin, -bulge) for begin, end, bulge in reversed(piece)]
        rows += [[begin.x, begin.y, bulge] for begin, _, bulge in piece]
        at = piece[-1][1]
    return rows


def _start(pieces: list[Any]) -> Vector:
    """Where the first of these chains of segments begins when the second follows it."""
    if len(pieces) < 2:
        return pieces[0][0][0]
    ends = (pieces[1][0][0], pieces[1][-1][1])
    first, last = pieces[0][0][0], pieces[0][-1][1]
    return first if min(last.distanceToPoint(end) for end in ends) <= min(first.distanceToPoint(end) for end in ends) else last


def _pieces(edge: Any) -> list[tuple[Vector, Vector, float]]:
    """An edge as segments: begin, end, bulge."""
    if edge.Length < SAME:
        return []
    low, high = edge.FirstParameter, edge.LastParameter
    kind = edge.Curve.TypeId
    if kind == "Part::GeomLine":
        return [(_flat(edge.valueAt(low)), _flat(edge.valueAt(high)), 0.0)]
    if kind == "Part::GeomCircle":
        cuts = [low, (low + high) / 2, high] if high - low > 1.5 * math.pi else [low, high]
        return [_arc(edge, begin, end) for begin, end in zip(cuts, cuts[1:])]
    nurbs = edge.toNurbs().Edges[0]
    spline = nurbs.Curve.copy()
    spline.segment(*nurbs.ParameterRange)
    return [piece for curve in spline.toBiArcs(CHORD) for piece in _pieces(curve.toShape())]


def _arc(edge: Any, begin: float, end: float) -> tuple[Vector, Vector, float]:
    first, middle, last = (_flat(edge.valueAt(at)) for at in (begin, (begin + end) / 2, end))
    turn = (middle - first).cross(last - middle).z
    return first, last, math.copysign(math.tan((end - begin) / 4), turn)


def _flat(point: Vector) -> Vector:
    return Vector(point.x, point.y, 0.0)


def wire_of_rows(rows: Sequence[Sequence[float]], z: float = 0.0) -> Any:
    edges = []
    for row, following in zip(rows, [*rows[1:], rows[0]]):
        begin, end = Vector(row[0], row[1], z), Vector(following[0], following[1], z)
        bulge = row[2] if len(row) > 2 else 0.0
        if begin.distanceToPoint(end) < SAME:
            continue
        if abs(bulge) < 1e-9:
            edges.append(Part.makeLine(begin, end))
            continue
        across = end - begin
        # The middle of an arc lies beside that of its chord by bulge times half the chord, to the right when it turns left.
        middle = (begin + end) * 0.5 + Vector(across.y, -across.x, 0) * (bulge / 2)
        edges.append(Part.Arc(begin, middle, end).toShape())
    return Part.Wire(edges)


def face_of_region(region: Any, z: float) -> Any:
    """A region of clearcut as a face at a height."""
    wires = [wire_of_rows(rows.tolist(), z) for rows in (region.outer, *region.islands)]
    return Part.makeFace(wires, "Part::FaceMakerBullseye")


def outer_wire(face: Any) -> Any:
    """The wire around all others; FreeCAD's own answer is wrong for some faces that booleans have turned over."""
    return max(face.Wires, key=lambda wire: wire.BoundBox.DiagonalLength)


def outline_of_face(face: Any) -> tuple[Rows, list[Rows]]:
    """Outer boundary and islands."""
    outer = outer_wire(face)
    return rows_of_wire(outer), [rows_of_wire(wire) for wire in face.Wires if not wire.isSame(outer)]


def down(shape: Any) -> Any:
    """The same face, at height 0."""
    moved = shape.copy()
    moved.translate(Vector(0, 0, -shape.BoundBox.ZMin))
    return moved


def is_level(face: Any) -> bool:
    """Whether a face is a horizontal plane."""
    return face.Surface.TypeId == "Part::GeomPlane" and abs(abs(face.normalAt(0, 0).z) - 1) < 1e-6


def is_upright(face: Any) -> bool:
    """Whether a face is a vertical wall, plane or not."""
    low, high, left, right = face.ParameterRange[2], face.ParameterRange[3], face.ParameterRange[0], face.ParameterRange[1]
    places = [(left + (right - left) * u / 4, low + (high - low) * v / 4) for u in (0, 1, 2, 3, 4) for v in (0, 2, 4)]
    return all(abs(face.normalAt(u, v).z) < 1e-6 for u, v in places)


def standing(model: Any, low: float, high: float) -> list[Any]:
    """What of a solid stands above `low` and below `high`, seen from above: faces at height 0.

    Exact for walls that are upright; drafted ones are taken where they begin and where they end.
    """
    heights = {vertex.Z for vertex in model.Vertexes} | {low, high}
    for face in model.Faces:
        heights |= {face.BoundBox.ZMin, face.BoundBox.ZMax}
    levels = sorted(z for z in heights if low - SAME <= z <= high + SAME)
    drafted = not all(is_level(face) or is_upright(face) for face in model.Faces if face.BoundBox.ZMax > low + SAME)
    found: list[Any] = []
    for bottom, top in zip(levels, levels[1:]):
        if top - bottom < 4 * BESIDE:
            continue
        for z in (bottom + BESIDE, (bottom + top) / 2, top - BESIDE) if drafted else ((bottom + top) / 2,):
            wires = model.slice(Vector(0, 0, 1), z)
            if wires:
                found += down(Part.makeFace(wires, "Part::FaceMakerBullseye")).Faces
    return united(found)


def united(faces: Iterable[Any]) -> list[Any]:
    """Faces at height 0 that do not overlap, of any faces at height 0."""
    faces = list(faces)
    if len(faces) < 2:
        return faces
    return faces[0].multiFuse(faces[1:]).removeSplitter().Faces


def without(faces: Iterable[Any], away: Sequence[Any]) -> list[Any]:
    """Faces less other faces, all at height 0."""
    return [part for face in faces for part in (face.cut(list(away)).Faces if away else [face])]


def rectangle(box: Any, margin: float) -> Any:
    """A face at height 0 around a bounding box."""
    size = (box.XLength + 2 * margin, box.YLength + 2 * margin)
    return Part.makePlane(*size, Vector(box.XMin - margin, box.YMin - margin, 0))
