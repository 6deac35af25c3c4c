"""The certificate in properties of FreeCAD's objects."""

from __future__ import annotations

from typing import Any

from . import overlay

GROUP = "Certificate"
# Name, type, what it says. All are read-only.
PROPERTIES = (
    ("Verdict", "App::PropertyString", "CLEAN, CONDITIONAL, FAULTY, or NOT PLANNED"),
    ("LeftThickness", "App::PropertyLength", "Nothing that the cutter reaches and leaves is thicker"),
    ("LeftArea", "App::PropertyArea", "Area of what the cutter reaches and leaves, an upper bound"),
    ("Gouge", "App::PropertyLength", "Depth of the deepest cut into the part"),
    ("RapidsInMaterial", "App::PropertyInteger", "Rapids through material"),
    ("Engagement", "App::PropertyAngle", "Largest angle of the cutter in the material"),
    ("Unreachable", "App::PropertyArea", "Corners that the cutter does not reach"),
    ("FeedLength", "App::PropertyLength", "Way at the feed"),
    ("MachiningSeconds", "App::PropertyFloat", "Time with acceleration and cornering, s"),
    ("Faults", "App::PropertyStringList", "What is wrong, worst first, with the place"),
    ("Conditions", "App::PropertyStringList", "What must hold at the machine"),
    ("Notes", "App::PropertyStringList", "What was noticed, mended or taken for granted"),
    ("Certificate", "App::PropertyString", "The whole certificate, JSON"),
    ("Left", "Part::PropertyPartShape", "What the cutter reaches and leaves"),
    ("OutOfReach", "Part::PropertyPartShape", "What the cutter does not reach"),
)  # fmt: skip


def add_properties(obj: Any) -> None:
    for name, kind, text in PROPERTIES:
        if not hasattr(obj, name):
            obj.addProperty(kind, name, GROUP, text)
    lock(obj)


def lock(obj: Any) -> None:
    """Read-only; what is long is hidden. Editor modes are not kept in files."""
    for name, kind, _ in PROPERTIES:
        obj.setEditorMode(name, 2 if kind.startswith("Part::") or name == "Certificate" else 1)


def clear(obj: Any, verdict: str, reasons: list[str]) -> None:
    """Nothing is proven: the figures of another path must not stay."""
    for name, kind, _ in PROPERTIES:
        if kind == "App::PropertyStringList":
            setattr(obj, name, [])
        elif kind == "App::PropertyString":
            setattr(obj, name, "")
        else:
            setattr(obj, name, overlay.compound([]) if kind.startswith("Part::") else 0)
    obj.Verdict, obj.Faults = verdict, reasons


def show(obj: Any, checked: Any, name: str, left: tuple[list[Any], list[Any]]) -> None:
    figures = checked.findings.all
    obj.Verdict = checked.verdict
    obj.LeftThickness, obj.LeftArea, obj.Gouge = (_finite(value) for value in (figures.uncut_thickness_mm, figures.uncut_mm2, figures.gouge_mm))
    obj.RapidsInMaterial, obj.Engagement = int(figures.rapid_in_material), _finite(figures.engagement.max_deg)
    obj.Unreachable, obj.FeedLength, obj.MachiningSeconds = figures.unreachable_mm2, figures.feed_mm, figures.time_s
    obj.Faults = [_fault(fault) for fault in checked.faults]
    obj.Conditions = [f"{one.name}: {one.text}" + (f" [{one.met_by}]" if one.met_by else "") for one in checked.findings.conditions]
    # What is a default of plans says nothing of a path that is there.
    obj.Notes = [str(one) for one in checked.diagnostics if one.where != "default"]
    obj.Certificate = checked.certificate_text(name)
    obj.Left, obj.OutOfReach = overlay.compound(left[0]), overlay.compound(left[1])


def _fault(fault: Any) -> str:
    return f"{fault.kind}: {fault.text} ({fault.feature}, at {fault.at.x:.3f}, {fault.at.y:.3f}, {fault.at.z:.3f})"


def _finite(value: float) -> float:
    return value if value == value and abs(value) < 1e9 else -1.0
