"""The operations, on models made here, without a window."""

from __future__ import annotations

import unittest

import clearcut
import FreeCAD
import models
import Path
from clearcut_cam import certificate, moves, operation, overlay, tools
from clearcut_cam.features import part_of


class Operations(unittest.TestCase):
    def setUp(self) -> None:
        self.document = models.document()

    def tearDown(self) -> None:
        FreeCAD.closeDocument(self.document.Name)

    def pocket(self, job, *floors, **properties):
        obj = operation.create_pocket(parentJob=job)
        obj.Base = [(models.floor_at(job, z)[0], [models.floor_at(job, z)[1]]) for z in floors]
        for name, value in properties.items():
            setattr(obj, name, value)
        self.document.recompute()
        return obj

    def planned_again(self, obj, job):
        """The moves that the module gives for the same question."""
        part = part_of(obj.Label, operation.wanted_features(obj), job.Stock.Shape.BoundBox, obj.ClearanceHeight.Value)
        tool = tools.tool_of(obj.ToolController)
        return clearcut.plan(part, tools=tool, **tools.cutting_of(obj.ToolController), **obj.Proxy.settings(obj)).moves

    def assert_same_moves(self, obj, expected) -> None:
        """Every command is a move of the module, after the way to where they begin and before the last way up."""
        ends = moves.points_of([command for command in obj.Path.Commands if not command.Name.startswith("(")])
        self.assertEqual(len(ends), len(expected) + 3)
        for end, x, y, z in zip(ends[2:-1], expected.x, expected.y, expected.z):
            for a, b in zip(end, (x, y, z)):
                self.assertAlmostEqual(a, b, places=9)

    def test_pocket_with_island_is_clean(self) -> None:
        job = models.job_of(models.box_with_pockets())
        obj = self.pocket(job, 12)
        self.assertEqual((obj.Verdict, list(obj.Faults)), ("CLEAN", []))
        self.assertLess(obj.LeftThickness.Value, 0.02)
        self.assertLess(obj.Gouge.Value, 0.005)
        self.assertGreater(obj.MachiningSeconds, 10)
        self.assertAlmostEqual(min(z for _, _, z in moves.points_of(obj.Path.Commands)), 12)
        self.assert_same_moves(obj, self.planned_again(obj, job))

    def test_pockets_in_each_other_and_open_to_a_side_are_clean(self) -> None:
        job = models.job_of(models.box_with_pockets(), 6)
        obj = self.pocket(job, 12, 8, 14, Strategy="contour", Direction="climb")
        self.assertEqual((obj.Verdict, list(obj.Faults)), ("CLEAN", []))
        kinds = {feature["kind"] for feature in operation.wanted_features(obj)}
        self.assertEqual(kinds, {"closed_pocket", "open_pocket"})
        self.assert_same_moves(obj, self.planned_again(obj, job))

    def test_open_pocket_in_a_larger_stock_is_clean(self) -> None:
        job = models.job_of(models.box_with_pockets(), 6, margin=2)
        self.assertEqual(self.pocket(job, 14).Verdict, "CLEAN")

    def test_profile_of_faces_and_of_the_model_is_clean(self) -> None:
        job = models.job_of(models.plate(), 5, margin=8)
        for base, holes in (([], False), ([models.floor_at(job, 0)], True)):
            obj = operation.create_profile(parentJob=job)
            obj.Base = [(owner, [name]) for owner, name in base]
            obj.Holes, obj.StepDown = holes, 2
            self.document.recompute()
            self.assertEqual((obj.Verdict, list(obj.Faults)), ("CLEAN", []), holes)
            self.assertEqual(len(operation.wanted_features(obj)), 3 if holes else 1)
            self.assertAlmostEqual(obj.FinalDepth.Value, 0)
            self.assert_same_moves(obj, self.planned_again(obj, job))

    def test_tabs_are_left_and_proven(self) -> None:
        job = models.job_of(models.plate(), 5, margin=8)
        obj = operation.create_profile(parentJob=job)
        obj.Tabs, obj.StepDown = 4, 2
        self.document.recompute()
        self.assertEqual((obj.Verdict, list(obj.Faults)), ("CLEAN", []))

    def test_profile_through_the_model_is_refused(self) -> None:
        job = models.job_of(models.box_with_pockets())
        obj = operation.create_profile(parentJob=job)
        obj.Base = [(models.floor_at(job, 12)[0], [models.floor_at(job, 12)[1]])]
        self.document.recompute()
        self.assertEqual(obj.Verdict, "NOT PLANNED")
        self.assertIn("of the model", obj.Faults[0])

    def test_stock_to_leave(self) -> None:
        job = models.job_of(models.box_with_pockets())
        obj = self.pocket(job, 12, StockToLeave=0.4, StockToLeaveFloor=0.25)
        self.assertEqual((obj.Verdict, list(obj.Faults)), ("CLEAN", []))
        self.assertAlmostEqual(min(z for _, _, z in moves.points_of(obj.Path.Commands)), 12.25)

    def test_what_cannot_be_planned_is_said_and_leaves_no_path(self) -> None:
        job = models.job_of(models.box_with_pockets(), 40)
        obj = self.pocket(job, 12)
        self.assertEqual(obj.Verdict, "NOT PLANNED")
        self.assertTrue(obj.Faults[0])
        self.assertFalse([command for command in obj.Path.Commands if command.Name in ("G1", "G2", "G3")])
        job.Tools.Group[0].Tool.Diameter = 5
        job.Tools.Group[0].HorizFeed = 0
        self.document.recompute()
        self.assertIn("feed", obj.Faults[0])
        job.Tools.Group[0].HorizFeed = "900 mm/min"
        self.document.recompute()
        self.assertEqual(obj.Verdict, "CLEAN")

    def test_feeds_are_those_of_the_tool_controller(self) -> None:
        job = models.job_of(models.box_with_pockets())
        controller = job.Tools.Group[0]
        controller.HorizFeed, controller.VertFeed = "2400 mm/min", "1000 mm/min"
        obj = self.pocket(job, 12)
        feeds = {round(command.Parameters["F"] * 60, 6) for command in obj.Path.Commands if "F" in command.Parameters}
        self.assertIn(2400, feeds)
        self.assertIn(1000, feeds)
        self.assertEqual((obj.Verdict, list(obj.Faults)), ("CLEAN", []))

    def test_wall_is_no_floor(self) -> None:
        job = models.job_of(models.box_with_pockets())
        obj = operation.create_pocket(parentJob=job)
        model = job.Model.Group[0]
        upright = next(n for n, face in enumerate(model.Shape.Faces, 1) if face.BoundBox.ZLength > 5)
        obj.Base = [(model, [f"Face{upright}"])]
        self.document.recompute()
        self.assertIn("not horizontal", obj.Faults[0])

    def test_a_path_that_was_changed_is_faulty_and_its_rest_is_shown(self) -> None:
        job = models.job_of(models.box_with_pockets())
        obj = self.pocket(job, 12)
        part = part_of(obj.Label, operation.wanted_features(obj), job.Stock.Shape.BoundBox, obj.ClearanceHeight.Value)
        commands = [command for command in obj.Path.Commands if not command.Name.startswith("(")]
        at = max(n for n, command in enumerate(commands) if command.Name == "G1" and command.Parameters.get("F", 0) > 10)
        lifted = [*commands[: at // 2], Path.Command("G0", {"Z": obj.ClearanceHeight.Value})]
        tool = tools.tool_of(obj.ToolController)
        checked = operation.check(obj, part, lifted, tool)
        self.assertEqual(checked.verdict, "FAULTY")
        certificate.show(obj, checked, obj.Label, overlay.left(part, checked, [tool]))
        shown = overlay.show(obj)
        shown.Proxy.execute(shown)
        self.assertGreater(shown.Uncut.Value, 50)
        self.assertLessEqual(shown.Uncut.Value, checked.findings.all.uncut_mm2 * 1.01 + 1)
        self.assertGreaterEqual(shown.Uncut.Value, checked.findings.all.uncut_mm2 * 0.9)

    def test_corners_out_of_reach_are_shown(self) -> None:
        job = models.job_of(models.box_with_pockets(), 6)
        obj = self.pocket(job, 14)
        shown = overlay.show(obj)
        self.document.recompute()
        self.assertAlmostEqual(shown.OutOfReach.Value, obj.Unreachable.Value, delta=0.1)
        self.assertEqual(shown.Uncut.Value, 0)

    def test_document_is_kept(self) -> None:
        import tempfile

        job = models.job_of(models.box_with_pockets())
        obj = self.pocket(job, 12)
        name, path, verdict = obj.Name, obj.Path.toGCode(), obj.Verdict
        with tempfile.TemporaryDirectory() as folder:
            self.document.saveAs(f"{folder}/job.FCStd")
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(f"{folder}/job.FCStd")
        again = self.document.getObject(name)
        self.assertEqual((again.Path.toGCode(), again.Verdict), (path, verdict))
        again.touch()
        self.document.recompute()
        self.assertEqual((again.Path.toGCode(), again.Verdict), (path, verdict))
