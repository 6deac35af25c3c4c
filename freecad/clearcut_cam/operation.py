"""Path operations that clearcut plans and proves: "Clearcut pocket" and "Clearcut profile".

The path is an ordinary one: FreeCAD's posts, dressups and simulator take it as any other. It is checked as it lies in the
operation, command by command, not as it was planned.
"""

from __future__ import annotations

from typing import Any

import FreeCAD
import Part

from . import certificate, host, moves, overlay, tools
from .features import Wanted, part_of, picked_faces, pockets, profiles

AS_IT_IS = "as it is best"
# A path of FreeCAD says nothing of how far a control may leave it; the proof is of the path itself.
TAKEN_FOR_GRANTED = ("blending",)


class _Operation(host.Op.ObjectOp):
    """What pockets and profiles share: cutting, the plan and its proof."""

    def opFeatures(self, obj: Any) -> int:
        op = host.Op
        return op.FeatureTool | op.FeatureDepths | op.FeatureHeights | op.FeatureStepDown | op.FeatureBaseFaces | op.FeatureCoolant

    def initOperation(self, obj: Any) -> None:
        self._add_properties(obj)

    def opOnDocumentRestored(self, obj: Any) -> None:
        self._add_properties(obj)

    def _add_properties(self, obj: Any) -> None:
        """Those that are missing: files of earlier versions get the new ones."""
        for name, kind, text, value in (*SHARED, *self.own_properties()):
            if hasattr(obj, name):
                continue
            obj.addProperty(kind, name, "Clearcut", text)
            setattr(obj, name, value)
            if isinstance(value, list):
                setattr(obj, name, value[0])
        certificate.add_properties(obj)

    def own_properties(self) -> tuple[Any, ...]:
        raise NotImplementedError

    def opExecute(self, obj: Any) -> None:
        try:
            self._plan(obj)
        except Exception as error:
            host.fail(f"{obj.Label}: {error}")
            certificate.clear(obj, "NOT PLANNED", [str(error)])
            if not host.is_said(error):
                raise

    def _plan(self, obj: Any) -> None:
        clearcut = host.clearcut()
        tool = tools.tool_of(obj.ToolController)
        settings = {**tools.cutting_of(obj.ToolController), **self.settings(obj)}
        part = part_of(obj.Label, wanted_features(obj), self.stock.Shape.BoundBox, obj.ClearanceHeight.Value)
        plan = clearcut.plan(part, tools=tool, **settings)
        commands = moves.commands_of(plan.moves)
        self.commandlist.extend(commands)
        checked = check(obj, part, commands, tool)
        certificate.show(obj, checked, obj.Label, overlay.left(part, checked, [tool], obj.StockToLeave.Value))
        obj.Notes = [str(one) for one in plan.diagnostics] + obj.Notes
        obj.Planned = ", ".join(dict.fromkeys(selection.kept for selection in plan.selections))
        say = FreeCAD.Console.PrintMessage if checked.clean else host.warn
        say(f"Clearcut: {obj.Label}: {checked.verdict}\n" if checked.clean else f"{obj.Label}: {checked.verdict}: {checked.findings.reasons()}")

    def settings(self, obj: Any) -> dict[str, Any]:
        """The properties as keywords of a plan; what is not asked is left to clearcut."""
        found: dict[str, Any] = {"stepdown": obj.StepDown.Value} if obj.StepDown.Value > 0 else {}
        if obj.StockToLeave.Value:
            found["allowance"] = obj.StockToLeave.Value
        for name, keyword in (("Direction", "direction"), ("Entry", "entry")):
            if getattr(obj, name) != AS_IT_IS:
                found[keyword] = getattr(obj, name)
        return found | ({"entry_angle": obj.EntryAngle.Value} if obj.EntryAngle.Value > 0 else {})


class Pocket(_Operation):
    """Clears the faces picked, with islands and open sides, from the start depth down."""

    def own_properties(self) -> tuple[Any, ...]:
        return POCKET()

    def settings(self, obj: Any) -> dict[str, Any]:
        found = super().settings(obj) | {"strategy": obj.Strategy}
        if obj.StepOver:
            found["stepover"] = obj.StepOver / 100
        if obj.StockToLeaveFloor.Value:
            found["allowance_floor"] = obj.StockToLeaveFloor.Value
        return found | ({"engagement": obj.EngagementLimit.Value} if obj.EngagementLimit.Value > 0 else {})


class Profile(_Operation):
    """Follows outlines of faces, or of the whole model, on one side."""

    def own_properties(self) -> tuple[Any, ...]:
        return PROFILE

    def opUpdateDepths(self, obj: Any) -> None:
        """Without faces the whole model is followed, down to its lowest place."""
        if not obj.Base:
            obj.OpFinalDepth = min(model.Shape.BoundBox.ZMin for model in self.model)

    def settings(self, obj: Any) -> dict[str, Any]:
        found = super().settings(obj)
        if obj.Tabs:
            found |= {"tabs": obj.Tabs, "tab_width": obj.TabWidth.Value}
            found |= {"tab_height": obj.TabHeight.Value} if obj.TabHeight.Value > 0 else {}
        return found


def wanted_features(obj: Any) -> list[dict[str, Any]]:
    """What an operation of ours is to mill. Raises Unclear."""
    job = host.find_job(obj)
    top, floor = obj.StartDepth.Value, obj.FinalDepth.Value
    wanted = Wanted(obj.Label, picked_faces(obj.Base), top, floor, abs(floor - obj.OpFinalDepth.Value) < 1e-6)
    model = model_of(job)
    if isinstance(obj.Proxy, Pocket):
        return pockets(wanted, model, job.Stock.Shape.BoundBox)
    diameter = tools.tool_of(obj.ToolController).diameter
    return profiles(wanted, model, diameter, outside=obj.Side == "Outside", perimeter=obj.Perimeter, holes=obj.Holes)


def model_of(job: Any) -> Any:
    shapes = [model.Shape for model in job.Model.Group]
    return shapes[0] if len(shapes) == 1 else Part.Compound(shapes)


def check(obj: Any, part: Any, commands: list[Any], tool: Any) -> Any:
    """The path as it lies there, as a program of its own, with the feed and speed of its tool controller."""
    text = moves.text_of(commands, tool, obj.ToolController.SpindleSpeed or 1000)
    asked = {"tools": tool, "accept": TAKEN_FOR_GRANTED, "allowance": obj.StockToLeave.Value, **tools.cutting_of(obj.ToolController)}
    if hasattr(obj, "StockToLeaveFloor"):
        asked["allowance_floor"] = obj.StockToLeaveFloor.Value
    if getattr(obj, "Tabs", 0):
        asked |= {"tabs": obj.Tabs, "tab_width": obj.TabWidth.Value}
        asked |= {"tab_height": obj.TabHeight.Value} if obj.TabHeight.Value > 0 else {}
    return host.clearcut().verify(part, text, name=obj.Label, dialect="linuxcnc", **asked)


LENGTH, CHOICE = "App::PropertyLength", "App::PropertyEnumeration"
SHARED: tuple[Any, ...] = (
    ("Direction", CHOICE, "Which way the cutter goes along the walls", [AS_IT_IS, "climb", "conventional"]),
    ("Entry", CHOICE, "How it goes down", [AS_IT_IS, "helix", "ramp", "zigzag", "plunge"]),
    ("EntryAngle", "App::PropertyAngle", "Steepest angle of a helix or ramp; 0: clearcut's own", 0.0),
    ("StockToLeave", LENGTH, "Left on walls for another operation", 0.0),
    ("Planned", "App::PropertyString", "The strategies that were kept", ""),
)  # fmt: skip


def POCKET() -> tuple[Any, ...]:
    return (
        ("Strategy", CHOICE, "How the floor is covered; auto plans several and keeps the quickest clean one", host.clearcut().strategy_names()),
        ("StepOver", "App::PropertyPercent", "Distance of passes, share of the diameter; 0: the strategy's own", 0),
        ("EngagementLimit", "App::PropertyAngle", "Largest angle of the cutter in the material, for adaptive clearing; 0: none", 0.0),
        ("StockToLeaveFloor", LENGTH, "Left on floors for another operation", 0.0),
    )


PROFILE: tuple[Any, ...] = (
    ("Side", CHOICE, "Side of the perimeter on which the cutter goes; in holes it is the other", ["Outside", "Inside"]),
    ("Perimeter", "App::PropertyBool", "Follow the outer outlines", True),
    ("Holes", "App::PropertyBool", "Follow the outlines of holes", False),
    ("Tabs", "App::PropertyInteger", "Bridges that hold each cut-out", 0),
    ("TabWidth", LENGTH, "Width of a bridge", 4.0),
    ("TabHeight", LENGTH, "Height of a bridge; 0: clearcut's own", 0.0),
)  # fmt: skip


def pocket_setup() -> list[str]:
    """Properties that a job's set-up sheet may give other defaults."""
    return ["Strategy", "StepOver", "Direction", "Entry", "StockToLeave", "StockToLeaveFloor"]


def profile_setup() -> list[str]:
    return ["Side", "Perimeter", "Holes", "Direction", "Entry", "StockToLeave", "Tabs", "TabWidth", "TabHeight"]


def create_pocket(name: str = "ClearcutPocket", obj: Any = None, parentJob: Any = None) -> Any:
    return _create(Pocket, name, obj, parentJob, "Clearcut pocket")


def create_profile(name: str = "ClearcutProfile", obj: Any = None, parentJob: Any = None) -> Any:
    return _create(Profile, name, obj, parentJob, "Clearcut profile")


def _create(kind: Any, name: str, obj: Any, job: Any, label: str) -> Any:
    """As FreeCAD's own operations are made; `obj` is there already when a set-up sheet asks what there is."""
    if obj is None:
        obj = FreeCAD.ActiveDocument.addObject("Path::FeaturePython", name)
        obj.Label = label
    obj.Proxy = kind(obj, name, job)
    return obj
