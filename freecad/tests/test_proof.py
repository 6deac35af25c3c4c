"""Proofs of jobs, whoever made their paths."""

from __future__ import annotations

import sys
import unittest

import FreeCAD
import models
import Path
from clearcut_cam import operation, overlay, proof

try:
    import Path.Op.Engrave as Engrave
    import Path.Op.Helix as Helix
    import Path.Op.PocketShape as PocketShape
    import Path.Op.Profile as TheirProfile
except ImportError:
    import PathScripts.PathEngrave as Engrave
    import PathScripts.PathHelix as Helix
    import PathScripts.PathPocketShape as PocketShape
    import PathScripts.PathProfile as TheirProfile

BLENDING = ["blending"]


def say(found) -> None:
    """What is true of a path of FreeCAD's own is no matter of these tests, but worth reading."""
    print("\n  ".join(["", *proof.report(found).splitlines()[:6]]), file=sys.stderr)


class Proofs(unittest.TestCase):
    def setUp(self) -> None:
        self.document = models.document()

    def tearDown(self) -> None:
        FreeCAD.closeDocument(self.document.Name)

    def prove(self, job, accept=(), **properties):
        obj = proof.create(job)
        obj.Accept = list(accept)
        for name, value in properties.items():
            setattr(obj, name, value)
        self.document.recompute()
        return obj

    def based(self, obj, job, *floors):
        obj.Base = [(models.floor_at(job, z)[0], [models.floor_at(job, z)[1]]) for z in floors]
        return obj

    def test_our_operations_posted_by_freecad(self) -> None:
        job = models.job_of(models.box_with_pockets(), 6)
        self.based(operation.create_pocket(parentJob=job), job, 12, 8, 14)
        self.document.recompute()
        open_question = self.prove(job)
        self.assertEqual((open_question.Verdict, list(open_question.Faults)), ("CONDITIONAL", []))
        self.assertTrue(any(one.startswith("blending") for one in open_question.Conditions))
        self.assertIn("(Exported by FreeCAD)", open_question.Program)
        self.assertEqual(self.prove(job, BLENDING).Verdict, "CLEAN")
        self.assertEqual(len(proof.report(open_question).splitlines()) > 3, True)

    def test_proof_follows_the_paths(self) -> None:
        job = models.job_of(models.box_with_pockets(), 6)
        ours = self.based(operation.create_pocket(parentJob=job), job, 12)
        self.document.recompute()
        found = self.prove(job, BLENDING)
        before = found.Program
        ours.StepDown = 2
        self.document.recompute()
        self.assertNotEqual(found.Program, before)
        self.assertEqual(found.Verdict, "CLEAN")

    def test_pocket_and_profile_in_one_job(self) -> None:
        job = models.job_of(models.plate(), 5, margin=8)
        holes = operation.create_profile(parentJob=job)
        self.based(holes, job, 0)
        holes.Perimeter, holes.Holes, holes.StepDown = False, True, 2
        outside = operation.create_profile(parentJob=job)
        outside.StepDown = 2
        self.document.recompute()
        found = self.prove(job, BLENDING)
        self.assertEqual((found.Verdict, list(found.Faults)), ("CLEAN", []))

    def test_posts_of_other_controls(self) -> None:
        job = models.job_of(models.box_with_pockets(), 6)
        self.based(operation.create_pocket(parentJob=job), job, 12)
        self.document.recompute()
        for post in ("grbl", "mach3_mach4"):
            found = self.prove(job, ["blending", "arc-centres", "dialect"], Post=post)
            self.assertEqual((found.Verdict, list(found.Faults)), ("CLEAN", []), post)

    def test_pocket_made_by_freecad_is_judged(self) -> None:
        job = models.job_of(models.box_with_pockets(), 5)
        theirs = self.based(PocketShape.Create("Pocket", parentJob=job), job, 12)
        theirs.StepOver, theirs.StepDown = 50, 2
        job.GeometryTolerance = 0.001
        self.document.recompute()
        found = self.prove(job, BLENDING)
        self.assertIn(found.Verdict, ("CLEAN", "CONDITIONAL", "FAULTY"))
        self.assertTrue(found.Certificate)
        self.assertLess(found.Gouge.Value, 0.02)
        say(found)

    def test_profile_made_by_freecad_is_judged(self) -> None:
        job = models.job_of(models.plate(), 5, margin=8)
        theirs = TheirProfile.Create("Profile", parentJob=job)
        theirs.StepDown = 2
        self.document.recompute()
        found = self.prove(job, BLENDING)
        self.assertIn(found.Verdict, ("CLEAN", "CONDITIONAL", "FAULTY"))
        self.assertTrue(found.Certificate)
        say(found)

    def test_hole_made_by_freecad_is_judged(self) -> None:
        job = models.job_of(models.plate(), 10, margin=0)
        model = job.Model.Group[0]
        names = [f"Face{n}" for n, face in enumerate(model.Shape.Faces, 1) if face.Surface.TypeId == "Part::GeomCylinder"]
        round_wall = min(names, key=lambda name: abs(model.Shape.getElement(name).CenterOfMass.x - 115))
        theirs = self.document.addObject("Path::FeaturePython", "Helix")
        theirs.Proxy = Helix.ObjectHelix(theirs, "Helix", job)
        theirs.Base = [(model, [round_wall])]
        theirs.StepOver = 50
        self.document.recompute()
        found = self.prove(job, BLENDING)
        self.assertTrue(found.Certificate, list(found.Faults))
        self.assertLess(found.Gouge.Value, 0.02)
        say(found)

    def test_wrong_path_is_faulty(self) -> None:
        job = models.job_of(models.box_with_pockets(), 5)
        theirs = self.based(PocketShape.Create("Pocket", parentJob=job), job, 12)
        self.document.recompute()
        moved = []
        for command in theirs.Path.Commands:
            words = command.Parameters
            if "X" in words:
                words["X"] += 0.3
            moved.append(Path.Command(command.Name, words))
        theirs.Path = Path.Path(moved)
        theirs.purgeTouched()
        found = proof.create(job)
        found.Accept = BLENDING
        found.Proxy.execute(found)
        self.assertEqual(found.Verdict, "FAULTY")
        self.assertAlmostEqual(found.Gouge.Value, 0.3, delta=0.02)
        self.assertTrue(any(one.startswith("gouge") for one in found.Faults))

    def test_rest_of_a_short_path_is_shown(self) -> None:
        job = models.job_of(models.box_with_pockets(), 5)
        ours = self.based(operation.create_pocket(parentJob=job), job, 12)
        self.document.recompute()
        commands = ours.Path.Commands
        ours.Path = Path.Path([*commands[: len(commands) * 3 // 4], Path.Command("G0", {"Z": ours.ClearanceHeight.Value})])
        ours.purgeTouched()
        found = proof.create(job)
        found.Accept = BLENDING
        found.Proxy.execute(found)
        self.assertEqual(found.Verdict, "FAULTY")
        shown = overlay.show(found)
        shown.Proxy.execute(shown)
        self.assertGreater(shown.Uncut.Value, 10)
        self.assertAlmostEqual(shown.Uncut.Value, found.LeftArea.Value, delta=0.1 * found.LeftArea.Value)

    def test_what_cannot_be_judged_is_said(self) -> None:
        job = models.job_of(models.box_with_pockets(), 5)
        self.assertIn("no active operations", self.prove(job).Faults[0])
        Engrave.Create("Engrave", parentJob=job)
        self.document.recompute()
        found = self.prove(job)
        self.assertEqual(found.Verdict, "NOT PROVEN")
        self.assertEqual(len(found.NotJudged), 1)
        self.assertIn("Engrave", found.NotJudged[0])

