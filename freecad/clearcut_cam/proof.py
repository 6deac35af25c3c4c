"""Proves a job: the text that FreeCAD posts, whoever made its paths, against what its operations are to mill."""

from __future__ import annotations

from typing import Any

import FreeCAD

from . import certificate, host, overlay, tools
from .features import Unclear, Wanted, part_of, picked_faces, pockets, profiles
from .operation import Pocket, Profile, model_of, wanted_features

# FreeCAD's operations that clear faces down to a floor, and those that follow outlines, by the names of their classes.
CLEARING = ("ObjectPocket", "ObjectPocketShape", "PathAdaptive", "ObjectFace")
FOLLOWING = ("ObjectProfile", "ObjectContour")
HOLES = ("ObjectDrilling", "ObjectHelix")


class JobProof:
    """The verdict on a job as an object of the document; recomputing it posts and checks again."""

    def __init__(self, obj: Any, job: Any):
        group = "Clearcut"
        obj.addProperty("App::PropertyLink", "Job", group, "The job that is proven").Job = job
        obj.addProperty("App::PropertyString", "Post", group, "FreeCAD's post whose text is checked; empty: the job's, else linuxcnc")
        obj.addProperty("App::PropertyString", "Dialect", group, "The control that reads it, as clearcut names it; empty: recognised")
        obj.addProperty("App::PropertyStringList", "Accept", group, "Conditions that hold at the machine, by their names")
        obj.addProperty("App::PropertyStringList", "NotJudged", group, "Operations that the proof leaves out, and why", 1)
        obj.addProperty("App::PropertyString", "Program", group, "The text that was checked", 2)
        certificate.add_properties(obj)
        obj.Proxy = self

    def execute(self, obj: Any) -> None:
        try:
            _prove(obj)
        except Exception as error:
            certificate.clear(obj, "NOT PROVEN", [str(error)])
            if not host.is_said(error):
                raise

    def onDocumentRestored(self, obj: Any) -> None:
        certificate.lock(obj)

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None

    __getstate__, __setstate__ = dumps, loads


def _prove(obj: Any) -> None:
    job = obj.Job
    features, left_out = features_of_job(job)
    obj.NotJudged = left_out
    if left_out:
        raise Unclear("not every operation can be checked: " + "; ".join(left_out))
    if not features:
        raise Unclear(f"{job.Label} has no active operations")
    operations = _active(job)
    cutters = {controller.ToolNumber: tools.tool_of(controller) for controller in map(host.tool_controller, operations)}
    clearance = max(operation.ClearanceHeight.Value for operation in operations)
    part = part_of(job.Label, features, job.Stock.Shape.BoundBox, clearance)
    post = obj.Post or job.PostProcessor or "linuxcnc"
    obj.Program = host.posted(job, post)
    asked = {"tools": list(cutters.values()), "accept": list(obj.Accept), **_left_on_purpose(operations), **_fastest(operations)}
    checked = host.clearcut().verify(part, obj.Program, name=job.Label, dialect=obj.Dialect or None, **asked)
    certificate.show(obj, checked, job.Label, overlay.left(part, checked, list(cutters.values()), asked.get("allowance", 0.0)))


def _left_on_purpose(operations: list[Any]) -> dict[str, float]:
    """Stock that every operation leaves; one that leaves none finishes the part, and then nothing may be left."""
    found = {"allowance": min(_mm(operation, "StockToLeave") for operation in operations)}
    return found | {"allowance_floor": min(_mm(operation, "StockToLeaveFloor") for operation in operations)}


def _fastest(operations: list[Any]) -> dict[str, float]:
    """The highest feeds of the tool controllers: what goes down into material faster than any of them says is a fault."""
    found: dict[str, float] = {}
    for controller in map(host.tool_controller, operations):
        for name, value in tools.cutting_of(controller).items():
            found[name] = max(value, found.get(name, 0.0))
    return found


def _mm(operation: Any, name: str) -> float:
    return getattr(operation, name).Value if hasattr(operation, name) else 0.0


def _active(job: Any) -> list[Any]:
    return [operation for operation in job.Operations.Group if host.Util.opProperty(operation, "Active")]


def features_of_job(job: Any) -> tuple[list[dict[str, Any]], list[str]]:
    """What the operations of a job are to mill, each place once, and those that cannot be said, with the reason."""
    found: list[dict[str, Any]] = []
    left_out = []
    for operation in _active(job):
        try:
            found += [feature for feature in features_of(operation) if not _same(feature, found)]
        except Unclear as why:
            left_out.append(f"{operation.Label}: {why}")
    return found, left_out


def _same(feature: dict[str, Any], found: list[dict[str, Any]]) -> bool:
    """Whether a feature is one of these but for its name: roughing and finishing of one pocket are two operations."""
    plain = {key: value for key, value in feature.items() if key != "name"}
    return any({key: value for key, value in other.items() if key != "name"} == plain for other in found)


def features_of(operation: Any) -> list[dict[str, Any]]:
    """What an operation of ours or of FreeCAD is to mill. Raises Unclear."""
    plain = _undressed(operation)
    if isinstance(plain.Proxy, (Pocket, Profile)):
        return wanted_features(plain)
    name = type(plain.Proxy).__name__
    job = host.find_job(operation)
    if name not in CLEARING + FOLLOWING + HOLES:
        raise Unclear(f"what an operation of the kind {name} is to mill cannot be told from its faces; make it inactive, and prove the rest")
    if name in HOLES:
        return _holes(plain)
    model, stock = model_of(job), job.Stock.Shape.BoundBox
    top, floor = plain.StartDepth.Value, plain.FinalDepth.Value
    openings = getattr(plain, "UseOutline", False) or name == "ObjectFace"
    wanted = Wanted(plain.Label, picked_faces(plain.Base), top, floor, own_floors=False, openings=openings)
    if name in CLEARING:
        return pockets(wanted, model, stock)
    diameter = tools.tool_of(host.tool_controller(operation)).diameter
    outside = getattr(plain, "Side", "Outside") == "Outside"
    holes = getattr(plain, "processHoles", False) or getattr(plain, "processCircles", False)
    perimeter = getattr(plain, "processPerimeter", True)
    return profiles(wanted, model, diameter, outside=outside, perimeter=perimeter, holes=holes)


def _undressed(operation: Any) -> Any:
    """A dressup changes the path of its Base, not what is to be milled."""
    while hasattr(operation, "Base") and hasattr(operation.Base, "Path"):
        operation = operation.Base
    return operation


def _holes(operation: Any) -> list[dict[str, Any]]:
    """The round walls and edges that are picked, each a hole of its own diameter; a drill makes holes of its own."""
    found = []
    for owner, names in operation.Base or []:
        for name in names:
            shape = owner.Shape.getElement(name)
            circle = next((edge for edge in shape.Edges if edge.Curve.TypeId == "Part::GeomCircle"), None)
            if circle is None:
                raise Unclear(f"{name} is not round")
            center, radius = circle.Curve.Center, circle.Curve.Radius
            rows = [[center.x - radius, center.y, 1.0], [center.x + radius, center.y, 1.0]]
            depth = operation.StartDepth.Value - operation.FinalDepth.Value
            found.append({"kind": "round_hole", "top": operation.StartDepth.Value, "depth": depth, "outer": rows, "islands": []})
    if not found:
        raise Unclear("no hole is picked")
    return [{"name": f"{operation.Label} {number}"} | hole for number, hole in enumerate(found, 1)]


def create(job: Any) -> Any:
    """The proof of a job, made if there is none; recompute the document to have it checked."""
    for obj in job.InList:
        if isinstance(getattr(obj, "Proxy", None), JobProof):
            obj.touch()
            return obj
    obj = FreeCAD.ActiveDocument.addObject("App::FeaturePython", "ClearcutProof")
    obj.Label = f"Proof of {job.Label}"
    JobProof(obj, job)
    return obj


def report(obj: Any) -> str:
    """What a person reads after a proof."""
    lines = [f"{obj.Label}: {obj.Verdict}"]
    if obj.Certificate:
        lines += [
            f"left where a cutter reaches: {obj.LeftThickness.Value:.4f} mm thick, {obj.LeftArea.Value:.3f} mm2",
            f"cut into the part: {obj.Gouge.Value:.4f} mm; rapids through material: {obj.RapidsInMaterial}",
            f"out of reach: {obj.Unreachable.Value:.3f} mm2; time: {obj.MachiningSeconds:.1f} s",
        ]
    for title, rows in (("wrong", obj.Faults), ("must hold at the machine", obj.Conditions), ("noticed", obj.Notes)):
        lines += [f"{title}:", *(f"  {row}" for row in rows)] if rows else []
    return "\n".join(lines)
