"""What is to be milled, as clearcut reads it: from faces of the job's models, depths and stock."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Iterable, Sequence

import Part

from . import host, shapes

# Areas below this are none, mm2.
NOTHING = 1e-6


class Unclear(ValueError):
    """What was picked does not say what is to be milled; one line for the user."""


@dataclass
class Wanted:
    """What an operation asks for: faces, and between which heights."""

    name: str
    faces: list[tuple[str, Any]] = field(default_factory=list)
    top: float = 0.0
    floor: float = 0.0
    # Every face is a floor at its own height; else all are milled down to `floor`.
    own_floors: bool = True
    # What a face leaves open, deeper pockets and holes in it, is cleared down to it as well.
    openings: bool = True


def picked_faces(base: Iterable[Any]) -> list[tuple[str, Any]]:
    """The faces of an operation's Base with their names. Raises Unclear for edges and vertices."""
    found = []
    for owner, names in base or []:
        for name in names if isinstance(names, (list, tuple)) else [names]:
            if not name.startswith("Face"):
                raise Unclear(f"{name} is no face; pick faces")
            found.append((name, owner.Shape.getElement(name)))
    return found


def pockets(wanted: Wanted, model: Any, stock: Any) -> list[dict[str, Any]]:
    """A feature for each connected floor: everything between it and the top that the model leaves free."""
    if not wanted.faces:
        raise Unclear("no face is picked; pick the floors of the pockets")
    floors: dict[float, list[Any]] = {}
    for name, face in wanted.faces:
        if not shapes.is_level(face):
            raise Unclear(f"{name} is not horizontal; pick the floor of the pocket")
        z = face.BoundBox.ZMax if wanted.own_floors else wanted.floor
        if z > wanted.top - shapes.BESIDE:
            raise Unclear(f"{name} at {z:g} mm does not lie below the start depth, {wanted.top:g} mm")
        floors.setdefault(round(z, 6), []).append(shapes.down(Part.Face(shapes.outer_wire(face)) if wanted.openings else face))
    found = []
    for z, faces in sorted(floors.items(), reverse=True):
        solid = shapes.standing(model, z, wanted.top)
        free = shapes.without([shapes.rectangle(stock, shapes.AROUND)], solid)
        for target in shapes.without(shapes.united(faces), solid):
            if target.Area > NOTHING:
                found.append(_pocket(target, free, wanted.top, z))
    if not found:
        raise Unclear("above the faces that are picked nothing is free to be milled")
    return _named(found, wanted.name)


def _pocket(target: Any, free: list[Any], top: float, floor: float) -> dict[str, Any]:
    outer, islands = shapes.outline_of_face(target)
    pocket = {"kind": "closed_pocket", "top": top, "depth": top - floor, "outer": outer, "islands": islands}
    allowed = [face for face in free if _overlap(face, target) > NOTHING]
    if sum(face.Area for face in allowed) > target.Area + NOTHING:
        outlines = [shapes.outline_of_face(face) for face in allowed]
        pocket |= {"kind": "open_pocket", "allowed": [{"outer": one, "islands": inner} for one, inner in outlines]}
    return pocket


def _overlap(a: Any, b: Any) -> float:
    return a.common(b).Area if a.BoundBox.intersect(b.BoundBox) else 0.0


def profiles(
    wanted: Wanted, model: Any, diameter: float, *, outside: bool = True, perimeter: bool = True, holes: bool = False
) -> list[dict[str, Any]]:
    """A feature for each outline that is followed: of the faces picked, else of the whole model as it is seen from above.

    Raises Unclear where the model stands in the way of a cutter of that diameter.
    """
    if wanted.floor > wanted.top - shapes.BESIDE:
        raise Unclear(f"the final depth, {wanted.floor:g} mm, does not lie below the start depth, {wanted.top:g} mm")
    for name, face in wanted.faces:
        if not shapes.is_level(face):
            raise Unclear(f"{name} is not horizontal; pick faces whose outline is to be followed")
    solid = shapes.standing(model, wanted.floor, wanted.top)
    faces = [shapes.down(face) for _, face in wanted.faces] or solid
    found = []
    for face in faces:
        outer, inner = shapes.outline_of_face(face)
        lines = ([(outer, outside)] if perimeter else []) + ([(rows, not outside) for rows in inner] if holes else [])
        for rows, around in lines:
            _refuse_collision(rows, around, diameter, solid)
            kind = "outside_profile" if around else "inside_profile"
            found.append({"kind": kind, "top": wanted.top, "depth": wanted.top - wanted.floor, "line": rows, "closed": True})
    if not found:
        raise Unclear("no outline is left to follow; pick faces, or ask for their perimeter or their holes")
    return _named(found, wanted.name)


def _refuse_collision(rows: shapes.Rows, around: bool, diameter: float, solid: Sequence[Any]) -> None:
    """The cutter takes a strip of its own width: the model must not stand there."""
    clearcut = host.clearcut()
    line = clearcut.region(rows)
    strip = clearcut.subtract(clearcut.dilate([line], diameter), [line]) if around else clearcut.subtract([line], clearcut.inset(line, diameter))
    # Curves that became arcs lie beside the model's by up to their tolerance.
    beside = 2 * shapes.CHORD * shapes.wire_of_rows(rows).Length
    for region in strip:
        lost = sum(_overlap(shapes.face_of_region(region, 0.0), face) for face in solid)
        if lost > beside:
            x, y = rows[0][:2]
            side = "outside" if around else "inside"
            raise Unclear(
                f"a cutter of {diameter:g} mm that follows the outline at {x:g}, {y:g} along its {side} takes {lost:.3g} mm2 of the model; "
                "pick a thinner tool, another side or a higher final depth"
            )


def _named(found: list[dict[str, Any]], name: str) -> list[dict[str, Any]]:
    if len(found) == 1:
        return [{"name": name} | found[0]]
    return [{"name": f"{name} {number}"} | feature for number, feature in enumerate(found, 1)]


def part_of(name: str, features: Sequence[dict[str, Any]], stock: Any, clearance: float) -> Any:
    """A part of clearcut in the document's coordinates. `stock` is the bounding box of the block."""
    top = max(feature["top"] for feature in features)
    low = min([stock.ZMin, *(feature["top"] - feature["depth"] for feature in features)])
    block = {"x": [stock.XMin, stock.XMax], "y": [stock.YMin, stock.YMax], "z": [low, top]}
    text = {"name": name, "units": "mm", "stock": block, "pockets": list(features)}
    part = host.clearcut().read_part_text(json.dumps(text), f"{name}.json")
    part.clearance_z = clearance
    return part
