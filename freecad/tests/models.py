"""Models and jobs that the tests mill, made anew for each."""

from __future__ import annotations

from typing import Any

import FreeCAD
import Part
from clearcut_cam import host
from FreeCAD import Vector


def document(name: str = "Test") -> Any:
    return FreeCAD.newDocument(name)


def box_with_pockets() -> Any:
    """A block with a pocket around a round island, a slot that opens to a side, and a pocket in the first one's floor."""
    block = Part.makeBox(80, 60, 20)
    block = block.cut(_rounded(10, 12, 44, 36, 12, 20, 5))
    block = block.fuse(Part.makeCylinder(6, 8, Vector(30, 30, 12)))
    block = block.cut(_rounded(40, 20, 12, 20, 8, 12, 4))
    return block.cut(Part.makeBox(20, 20, 6, Vector(62, 20, 14))).removeSplitter()


def plate() -> Any:
    """A round-cornered plate with a round and an elliptic opening, away from the origin."""
    sheet = _rounded(100, -20, 60, 40, 0, 6, 8).cut(Part.makeCylinder(8, 6, Vector(115, 0, 0)))
    ellipse = Part.Ellipse(Vector(140, 0, 0), 12, 8).toShape()
    return sheet.cut(Part.Face(Part.Wire([ellipse])).extrude(Vector(0, 0, 6)))


def _rounded(x: float, y: float, width: float, height: float, low: float, high: float, radius: float) -> Any:
    solid = Part.makeBox(width, height, high - low, Vector(x, y, low))
    upright = [edge for edge in solid.Edges if abs(edge.tangentAt(edge.FirstParameter).z) > 0.9]
    return solid.makeFillet(radius, upright)


def job_of(shape: Any, diameter: float = 5.0, margin: float = 0.0) -> Any:
    """A job on a shape with one end mill; `margin` is the stock all round, mm."""
    doc = FreeCAD.ActiveDocument
    body = doc.addObject("Part::Feature", "Body")
    body.Shape = shape
    doc.recompute()
    job = host.Job.Create("Job", [body], None)
    job.PostProcessor = "linuxcnc"
    stock = job.Stock
    for name in ("ExtXneg", "ExtXpos", "ExtYneg", "ExtYpos", "ExtZneg", "ExtZpos"):
        setattr(stock, name, margin)
    controller = job.Tools.Group[0]
    controller.Tool.Diameter = diameter
    controller.HorizFeed, controller.VertFeed, controller.SpindleSpeed = "900 mm/min", "300 mm/min", 9000
    doc.recompute()
    return job


def floor_at(job: Any, z: float, nth: int = 0) -> tuple[Any, str]:
    """The model of a job and the name of a face that lies at that height."""
    model = job.Model.Group[0]
    names = [f"Face{n}" for n, face in enumerate(model.Shape.Faces, 1) if abs(face.BoundBox.ZMin - z) + abs(face.BoundBox.ZMax - z) < 1e-6]
    return model, names[nth]
