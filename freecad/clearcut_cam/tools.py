"""Tool controllers of FreeCAD as tools of clearcut, with their feeds."""

from __future__ import annotations

from typing import Any

from .features import Unclear
from . import host

# Shapes of FreeCAD's tool bits, and what clearcut calls them.
KINDS = {"endmill": "endmill", "ballend": "ball", "bullnose": "bullnose", "drill": "drill", "reamer": "reamer"}


def tool_of(controller: Any) -> Any:
    """The tool under the controller's number. Raises Unclear for what 2.5-D milling does not use."""
    bit = controller.Tool
    shape = str(getattr(bit, "ShapeName", "") or getattr(bit, "ShapeID", "") or getattr(bit, "ToolType", "")).lower()
    kind = next((ours for theirs, ours in KINDS.items() if shape.startswith(theirs)), None)
    if kind is None:
        raise Unclear(f"{controller.Label}: a tool of the shape '{shape}' is not planned with; use an end mill, bull-nose or ball mill")
    diameter = _mm(bit, "Diameter")
    if diameter <= 0:
        raise Unclear(f"{controller.Label}: its tool has no diameter")
    text = f"{kind}:{diameter:.9g}:T{controller.ToolNumber}"
    corner = _mm(bit, "FlatRadius") or _mm(bit, "CornerRadius") if kind == "bullnose" else 0.0
    text += f":corner={corner:.9g}" if corner else ""
    tool = host.clearcut().Tool(text)
    tool.name = controller.Label
    flutes = int(getattr(bit, "Flutes", 0) or 0)
    tool.teeth = flutes or tool.teeth
    tool.flute_length = _mm(bit, "CuttingEdgeHeight") or None
    return tool


def cutting_of(controller: Any) -> dict[str, float]:
    """Feeds (mm/min) and speed as keywords of a plan. Raises Unclear where the controller has no feed."""
    feed, plunge = _per_minute(controller, "HorizFeed"), _per_minute(controller, "VertFeed")
    if feed <= 0 or plunge <= 0:
        raise Unclear(f"{controller.Label} has no {'horizontal' if feed <= 0 else 'vertical'} feed; set it in the tool controller")
    settings = {"feed": feed, "plunge_feed": plunge}
    return settings | ({"spindle": float(controller.SpindleSpeed)} if controller.SpindleSpeed > 0 else {})


def _mm(owner: Any, name: str) -> float:
    return float(getattr(getattr(owner, name, 0.0), "Value", getattr(owner, name, 0.0)) or 0.0)


def _per_minute(owner: Any, name: str) -> float:
    """FreeCAD keeps speeds in mm/s; a millionth is its noise."""
    return round(_mm(owner, name) * 60, 6)
