"""Outlines from NumPy arrays, lists and shapely's geometries."""

from __future__ import annotations

import json
from typing import Any, Iterable

import numpy

from . import _core
from ._core import InputError, Part, Region


def part(
    outlines: Any,
    *,
    depth: float,
    top: float = 0.0,
    name: str = "part",
    slope_deg: float = 0.0,
    stock: tuple[tuple[float, float], tuple[float, float], tuple[float, float]] | None = None,
) -> Part:
    """A part with a pocket for each outline, repaired and refused as if it were read from a file.

    outlines  an array of rows x, y or x, y, bulge; a pair (outer, islands); a shapely Polygon or MultiPolygon; a Region; or
              a sequence of these. The bulge is tan(angle / 4) of the arc that leaves a vertex, positive counter-clockwise.
    depth     below `top`, mm. `slope_deg` leans the walls inwards going down, from vertical.
    stock     lowest and highest x, y and z of the block, mm; without it all around is solid.
    """
    pockets = [
        {"outer": outer, "islands": islands, "top": float(top), "depth": float(depth), "slope_rad": numpy.radians(slope_deg)}
        for outer, islands in _outlines(outlines)
    ]
    if not pockets:
        raise InputError("outlines: there are none; give one array at least")
    if len(pockets) == 1:
        text: dict[str, Any] = {"name": name, "units": "mm", **pockets[0]}
    else:
        named = [{"name": f"{name} {number}", **pocket} for number, pocket in enumerate(pockets, 1)]
        text = {"name": name, "units": "mm", "pockets": named}
    if stock is not None:
        text["stock"] = dict(zip("xyz", ([float(v) for v in side] for side in stock)))
    return _core.read_part_text(json.dumps(text), f"{name}.json")


def regions(outlines: Any) -> list[Region]:
    """Valid regions from outlines as part() takes them, repaired in the same way."""
    found: list[Region] = []
    for feature in part(outlines, depth=1.0, name="outline").features:
        found += feature.target
    return found


def region(outer: Any, islands: Iterable[Any] = ()) -> Region:
    """One valid region from its outer boundary and its islands. Raises InputError where it is several."""
    found = regions([(outer, list(islands))])
    if len(found) != 1:
        raise InputError(f"region: these outlines bound {len(found)} regions; use regions()")
    return found[0]


def _outlines(given: Any) -> list[tuple[Any, list[Any]]]:
    """Pairs of outer boundary and islands, each a list of rows."""
    kind = getattr(given, "geom_type", None)
    if kind == "Polygon":
        return [(_ring(given.exterior), [_ring(ring) for ring in given.interiors])]
    if kind is not None and hasattr(given, "geoms"):
        return [outline for geometry in given.geoms for outline in _outlines(geometry)]
    if kind is not None:
        raise InputError(f"outlines: a {kind} bounds no area; give polygons")
    if isinstance(given, Region):
        return [(given.outer.tolist(), [island.tolist() for island in given.islands])]
    if _is_loop(given):
        return [(_rows(given), [])]
    if isinstance(given, tuple) and len(given) == 2 and _is_loop(given[0]):
        return [(_rows(given[0]), [_rows(island) for island in given[1]])]
    if isinstance(given, (list, tuple)):
        return [outline for one in given for outline in _outlines(one)]
    raise InputError(f"outlines: {type(given).__name__} is none; give arrays of rows x, y or x, y, bulge, or polygons")


def _ring(ring: Any) -> list[list[float]]:
    """Without the last point, which shapely repeats, and without heights."""
    return [[float(x), float(y)] for x, y, *_ in list(ring.coords)[:-1]]


def _is_loop(given: Any) -> bool:
    if isinstance(given, Region) or hasattr(given, "geom_type"):
        return False
    if isinstance(given, numpy.ndarray):
        return given.ndim == 2
    return (
        isinstance(given, (list, tuple))
        and len(given) > 0
        and all(isinstance(row, (list, tuple, numpy.ndarray)) and len(row) in (2, 3) and not _nested(row) for row in given)
    )


def _nested(row: Any) -> bool:
    return any(hasattr(value, "__len__") for value in row)


def _rows(loop: Any) -> list[list[float]]:
    array = numpy.asarray(loop, dtype=float)
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise InputError("outlines: an outline is an array of rows x, y or x, y, bulge")
    if not numpy.isfinite(array).all():
        raise InputError("outlines: an outline has numbers that are not finite")
    rows: list[list[float]] = array.tolist()
    return rows
