"""Plans, checks and what they give, held against the command."""
import json
import pickle
import re
import signal
import threading
import time
import unittest

import numpy
from support import EXAMPLES, L_SHAPE, folder, pocket, run_command

import clearcut


class Plans(unittest.TestCase):
    def test_gives_a_certified_program(self):
        plan = clearcut.plan(pocket(), tools="endmill:6", strategy="contour")
        self.assertTrue(plan.clean)
        self.assertEqual(plan.verdict, "CLEAN")
        self.assertIn("CERTIFICATE: CLEAN", plan.program)
        self.assertEqual([selection.kept for selection in plan.selections], ["contour"])
        self.assertEqual(plan.faults, [])
        self.assertIn("pocket", plan.table())
        self.assertIn("<svg", plan.picture())
        self.assertIn("<html", plan.page())

    def test_boards_are_read_from_either_side(self):
        copper = EXAMPLES / "board-F_Cu.gbr"
        seen = [clearcut.read_part(str(copper), depth=0.1, mirror=mirror) for mirror in (False, True)]
        left, right = (min(ring[:, 0].min() for region in part.features[0].target for ring in region.polygon(0.1))
                       for part in seen)
        self.assertGreater(left, 8)
        self.assertLess(right, -30)

    def test_options_can_be_kept_and_changed(self):
        options = clearcut.PlanOptions(tools=["endmill:6"], stepdown="0.04in", feed="40ipm", entry="ramp")
        self.assertAlmostEqual(options.stepdown, 1.016)
        self.assertAlmostEqual(options.feed, 1016)
        self.assertEqual(options.entry, "ramp")
        changed = options.replaced(stepdown=None, entry_angle=2)
        self.assertIsNone(changed.stepdown)
        self.assertAlmostEqual(changed.entry_angle, 2)
        self.assertAlmostEqual(options.stepdown, 1.016)

    def test_tools_of_a_library_bring_their_cutting_data(self):
        tools = clearcut.read_tools(str(EXAMPLES / "tools.toml"))
        options = clearcut.PlanOptions(tools=tools)
        self.assertEqual([tool.number for tool in options.tools], [tool.tool.number for tool in tools])

    def test_every_option_of_the_command_is_a_keyword(self):
        help_text = run_command("plan", "--help", "all").stdout
        options = set(re.findall(r"^\s+(?:-\w, )?--([a-z-]+)", help_text, re.MULTILINE))
        self.assertGreater(len(options), 90)
        keywords = {name.replace("_", "-") for name in dir(clearcut.PlanOptions)}
        reading = {"layer": "layers", "op": "ops", "text": "letters"}
        readers = {word for name in clearcut.read_part.__doc__.split("\n")[0].replace("(", ",").split(",")
                   for word in [name.split(":")[0].strip(" *").replace("_", "-")]}
        elsewhere = {
            "tool",  # tools=
            "no-arcs", "no-tool-change", "no-length-offset",  # arcs=, tool_change=, length_offset=
            "machine-kind",  # machine=Machine(kind)
            "clearance",  # Part.clearance_z
            "setup", "earlier-setup",  # read_job(), plan_setups()
            "stock-from",  # after= for programs; solids as stock are the command's alone
            "output", "certificate", "svg", "report", "setup-sheet", "result", "witness", "animation",  # Plan.write() and others; a witness and a moving picture are the command's alone
            "explain",  # explain()
            "quiet", "help",
        }
        missing = {one for one in options - keywords - elsewhere if reading.get(one, one) not in readers}
        self.assertEqual(missing, set())

    def test_unknown_options_are_named(self):
        with self.assertRaisesRegex(TypeError, "'stepdwon' is no option of a plan; did you mean 'stepdown'"):
            clearcut.plan(pocket(), stepdwon=2)
        with self.assertRaisesRegex(TypeError, "did you mean 'depth'"):
            clearcut.read_part(str(EXAMPLES / "plate.dxf"), dept=5)

    def test_percentages_are_fractions(self):
        programs = {clearcut.plan(pocket(), tools="endmill:6", strategy="zigzag", stepover=text).program
                    for text in ("50%", "0.5")}
        self.assertEqual(len(programs), 1)

    def test_a_comparison_has_numbers(self):
        table = clearcut.compare(pocket(), tools="endmill:6")
        numbers = table.numbers()
        self.assertEqual({len(column) for column in numbers.values()}, {len(numbers["strategy"])})
        times = [time for time, clean in zip(numbers["time_s"], numbers["clean"]) if clean]
        self.assertEqual(numbers["time_s"][numbers["strategy"].index(table.fastest_clean)], min(times))
        self.assertIn("<table>", table._repr_html_())

    def test_a_plan_is_pickled_and_shown(self):
        plan = clearcut.plan(pocket(), tools="endmill:6", strategy="contour")
        kept = pickle.loads(pickle.dumps(plan))
        self.assertEqual(kept.program, plan.program)
        self.assertEqual(kept.certificate(), plan.certificate())
        self.assertEqual((kept.verdict, kept.clean, kept.table()), (plan.verdict, plan.clean, plan.table()))
        self.assertTrue((kept.columns()["x"] == plan.moves.x).all())
        self.assertEqual(pickle.loads(pickle.dumps(kept)).program, plan.program)
        place = folder(self)
        kept.write(place / "a.ngc")
        self.assertEqual((place / "a.ngc").read_text(), plan.program)
        for one in (plan, kept):
            self.assertTrue(one._repr_svg_().lstrip().startswith("<"))
            self.assertIn("CLEAN", one._repr_html_())

    def test_passes_of_polygons_are_clean_at_reflex_corners(self):
        def rings(layer):
            area = layer.clearing_area()
            passes = area.walls
            for number, component in enumerate(area.components):
                region, parent = component.legal, component.outer_wall
                for wall in clearcut.dilate([region], 0) or [region]:
                    for ring in wall.polygon():  # the walls once more, as polygons
                        parent = passes.add(ring, parent=parent, component=number)
                while True:
                    inner = clearcut.inset(region, 0.5 * layer.tool_radius)
                    if not inner:
                        break
                    region = inner[0]
                    parent = passes.add(region.polygon()[0], parent=parent, component=number)
            return passes

        shape = clearcut.part([[0, 0], [60, 0], [60, 40], [30, 40], [30, 25], [0, 25]], depth=4, name="pocket")
        own = clearcut.Strategy("polygons", rings, "walls as polygons")
        plan = clearcut.plan(shape, tools="endmill:6", strategy="polygons", strategies=[own])
        self.assertLess(plan.findings.all.gouge_mm, 0.001)
        self.assertLess(clearcut.Region.polygon_chord, 0.001)

    def test_a_part_is_used_again(self):
        part = pocket()
        first = clearcut.plan(part, tools="endmill:6", strategy="zigzag")
        second = clearcut.plan(part, tools="endmill:6", strategy="zigzag", threads=1)
        self.assertEqual(first.program, second.program)

    def test_wishes_that_cannot_be_met_are_refused(self):
        for wish, text in (({"style": "nonsense"}, "use one of machinist, fastest"), ({"grid": "mine"}, "use one of ours, published"),
                           ({"passage": "long"}, "use one of shortest, bisector"), ({"work_offset": "G60"}, "use one of G54"),
                           ({"solver": "best"}, "use one of modern, published"),
                           ({"generations": 20}, "add --solver published")):
            with self.subTest(**wish), self.assertRaisesRegex(clearcut.InputError, text):
                clearcut.plan(pocket(), tools="endmill:6", **wish)
        with self.assertRaisesRegex(clearcut.InputError, "use one of router, industrial-router, mill"):
            clearcut.Machine("lathe")

    def test_a_kind_of_machine_limits_the_spindle(self):
        router = clearcut.Machine("router")
        self.assertIn("S8000", clearcut.plan(pocket(), tools="endmill:6", machine=router).program)
        with self.assertRaisesRegex(clearcut.InputError, "turns no slower than 8000"):
            clearcut.plan(pocket(), tools="endmill:6", spindle=2000, machine=router)

    def test_explains_without_planning(self):
        self.assertIn("stepdown", clearcut.explain(pocket(), tools="endmill:6", stepdown=1))

    def test_compares(self):
        table = clearcut.compare(pocket(), tools="endmill:10")
        self.assertIn("strategy", table.columns[0])
        self.assertTrue(any(row and row[0].startswith("zigzag") for row in table.rows))
        self.assertIn("zigzag", str(table))


class LikeTheCommand(unittest.TestCase):
    """Same bytes for the same question."""

    def assert_same(self, part, words, **asked):
        here = folder(self)
        program, certificate = here / "p.ngc", here / "p.json"
        run = run_command("plan", part, "--output", program, "--certificate", certificate, "--quiet", *words)
        self.assertLess(run.returncode, 2, run.stderr)
        reading = asked.pop("reading", None)
        plan = clearcut.plan(clearcut.read_part(part, **reading) if reading else part, **asked)
        self.assertEqual(plan.program, program.read_text())
        theirs, ours = json.loads(certificate.read_text()), plan.certificate(str(program))
        for one in (theirs, ours):
            del one["seal"], one["question"]["command"], one["question"]["arguments"]
        self.assertEqual(ours, theirs)

    def test_stepnc(self):
        self.assert_same(EXAMPLES / "fishhead.p21", [])

    def test_drawing(self):
        self.assert_same(EXAMPLES / "bracket.dxf", ["--depth", "5", "--tool", "endmill:6", "--stepdown", "2"],
                         reading={"depth": 5}, tools="endmill:6", stepdown=2)

    def test_outline_with_many_options(self):
        words = ["--tool", "endmill:8:T2", "--strategy", "adaptive", "--engagement", "80", "--feed", "900", "--post", "grbl",
                 "--allowance", "0.2", "--direction", "conventional", "--seed", "3"]
        self.assert_same(EXAMPLES / "bracket.json", words, tools="endmill:8:T2", strategy="adaptive", engagement=80,
                         feed=900, post="grbl", allowance=0.2, direction="conventional", seed=3)

    def test_how_the_program_is_written(self):
        words = ["--tool", "endmill:6", "--strategy", "contour", "--style", "machinist", "--work-offset", "G56", "--block-numbers",
                 "--post", "fanuc", "--program-number", "77", "--coolant", "mist"]
        self.assert_same(EXAMPLES / "bracket.json", words, tools="endmill:6", strategy="contour", style="machinist", work_offset="g56",
                         block_numbers=True, post="fanuc", program_number=77, coolant="mist")
        self.assert_same(EXAMPLES / "bracket.json", ["--tool", "endmill:6", "--post", "haas", "--work-offset", "G154 P7", "--end-position", "0,50"], tools="endmill:6",
                         post="haas", work_offset="g154p7", end_position="0,50")

    def test_published_methods(self):
        words = ["--tool", "endmill:10", "--strategy", "tour", "--grid", "published", "--solver", "published", "--generations", "20",
                 "--crossover", "ox", "--mutation-rate", "0.5"]
        self.assert_same(EXAMPLES / "bracket.json", words, tools="endmill:10", strategy="tour", grid="published", solver="published",
                         generations=20, crossover="ox", mutation_rate=0.5)
        self.assert_same(EXAMPLES / "bracket.json", ["--tool", "endmill:6", "--strategy", "contour", "--passage", "bisector"],
                         tools="endmill:6", strategy="contour", passage="bisector")

    def test_zero_elsewhere(self):
        for origin in ("corner", "centre", "10,5,-1"):
            self.assert_same(EXAMPLES / "bracket.dxf", ["--depth", "5", "--tool", "endmill:6", "--strategy", "zigzag", "--origin", origin],
                             reading={"depth": 5, "origin": origin}, tools="endmill:6", strategy="zigzag")

    def test_set_ups(self):
        here = folder(self)
        for name, size, depth in (("wide", 60, 3), ("narrow", 40, 8)):
            low, high = 40 - size / 2, 40 + size / 2
            outer = [[low, low, 0], [high, low, 0], [high, high, 0], [low, high, 0]]
            (here / f"{name}.json").write_text(json.dumps({"name": name, "units": "mm", "top": 0, "depth": depth, "outer": outer}))
        job = here / "job.toml"
        job.write_text("""[stock]
x = [0, 80]
y = [0, 80]
z = [-12, 0]
[plan]
strategy = "zigzag"
[[tool]]
kind = "endmill"
diameter = 8
[[setup]]
name = "first"
file = "wide.json"
[[setup]]
name = "second"
file = "narrow.json"
work_offset = "G55"
""")
        run = run_command("plan", job, "-o", here / "p.nc", "--post", "haas", "--program-number", "40", "--quiet")
        self.assertLess(run.returncode, 2, run.stderr)
        plans = clearcut.plan_setups(job, post="haas", program_number=40)
        self.assertEqual([plan.program for plan in plans], [(here / f"p-{n}.nc").read_text() for n in (1, 2)])
        self.assertIn("O00041", plans[1].program)
        # The second begins in what the first has left: a plan of its own without that would cut all of it.
        part, options = clearcut.read_job(job, setup=2, earlier=plans[:1])
        check = clearcut.verify(part, plans[1].program, options, post="haas", dialect="haas")
        self.assertTrue(check.clean, check.faults)
        for wrong, text in ((lambda: clearcut.plan(job), "use plan_setups"), (lambda: clearcut.read_job(job, setup=3), "has 2"),
                            (lambda: clearcut.read_job(job, setup=2), "give the plans of those in order"),
                            (lambda: clearcut.plan_setups(EXAMPLES / "bracket.toml"), "has no")):
            with self.assertRaisesRegex(clearcut.InputError, text):
                wrong()

    def test_job(self):
        self.assert_same(EXAMPLES / "bracket.toml", [])

    def test_job_with_a_machine_file(self):
        machine = EXAMPLES / "mill.toml"
        self.assert_same(EXAMPLES / "bracket.toml", ["--machine", machine, "--acceleration", "300"], machine=machine, acceleration=300)

    def test_verify(self):
        here = folder(self)
        program = here / "p.ngc"
        plan = clearcut.plan(EXAMPLES / "bracket.json", tools="endmill:6", strategy="zigzag")
        plan.write(program)
        spoiled = plan.program.replace("G0 Z", "G0 Z-", 1)
        for text in (plan.program, spoiled):
            program.write_text(text)
            run = run_command("verify", program, "--part", EXAMPLES / "bracket.json", "--tool", "endmill:6", "--json", "-")
            theirs = json.loads(run.stdout)
            ours = clearcut.verify_file(EXAMPLES / "bracket.json", program, tools="endmill:6").certificate()
            for one in (theirs, ours):
                del one["seal"], one["question"]["command"], one["question"]["arguments"]
            self.assertEqual(ours, theirs)

    def test_verify_alone(self):
        program = folder(self) / "p.ngc"
        clearcut.plan(EXAMPLES / "bracket.json", tools="endmill:6", strategy="zigzag").write(program)
        check = clearcut.verify_alone(program, stock="-20:120,-20:100,-30:0", tools="endmill:6", dialect="linuxcnc")
        self.assertEqual(check.verdict, "CLEAN AS FAR AS CAN BE SAID WITHOUT A PART")
        self.assertFalse(check.clean)
        theirs = json.loads(run_command("verify", program, "--stock", "-20:120,-20:100,-30:0", "--tool", "endmill:6", "--dialect", "linuxcnc",
                                        "--json", "-").stdout)
        ours = check.certificate()
        for one in (theirs, ours):
            del one["seal"], one["question"]["command"], one["question"]["arguments"]
        self.assertEqual(ours, theirs)
        self.assertIn("not asked", check.page())

    def test_nothing_is_written_over_what_was_read(self):
        job = folder(self) / "part.toml"
        job.write_text(f'[part]\nfile = "{EXAMPLES / "bracket.json"}"\n')
        before = job.read_bytes()
        plan = clearcut.plan(job, tools="endmill:6", strategy="zigzag")
        self.assertEqual(plan.inputs, [str(job), str(EXAMPLES / "bracket.json")])
        with self.assertRaises(clearcut.InputError):
            plan.write(job)
        self.assertEqual(job.read_bytes(), before)

    def test_errors(self):
        here = folder(self)
        cases = [
            (["plan", EXAMPLES / "bracket.json", "-o", here / "x"], lambda: clearcut.plan(EXAMPLES / "bracket.json")),
            (["plan", here / "none.dxf", "-o", here / "x"], lambda: clearcut.plan(here / "none.dxf")),
            (["plan", EXAMPLES / "bracket.json", "--tool", "endmil:6", "-o", here / "x"],
             lambda: clearcut.plan(EXAMPLES / "bracket.json", tools="endmil:6")),
            (["plan", EXAMPLES / "bracket.json", "--tool", "endmill:6", "--strategy", "best", "-o", here / "x"],
             lambda: clearcut.plan(EXAMPLES / "bracket.json", tools="endmill:6", strategy="best")),
            (["plan", EXAMPLES / "bracket.json", "--tool", "endmill:6", "--stepdown", "-1", "-o", here / "x"],
             lambda: clearcut.plan(EXAMPLES / "bracket.json", tools="endmill:6", stepdown=-1)),
        ]
        for words, call in cases:
            run = run_command(*words)
            with self.assertRaises(clearcut.InputError) as raised:
                call()
            self.assertEqual(run.returncode, 2)
            self.assertEqual(run.stderr.strip().splitlines()[-1], f"clearcut: {raised.exception}")


class Columns(unittest.TestCase):
    def setUp(self):
        self.plan = clearcut.plan(pocket(), tools="endmill:6", strategy="contour")

    def test_are_those_of_the_findings(self):
        moves, figures = self.plan.moves, self.plan.findings.all
        cuts = moves.kind != clearcut.Moves.kinds.index("rapid")
        self.assertAlmostEqual(moves.length[cuts].sum(), figures.feed_mm, 6)
        self.assertAlmostEqual(moves.length[~cuts].sum(), figures.rapid_mm, 6)
        self.assertAlmostEqual(moves.time.sum(), figures.time_s, 6)
        self.assertAlmostEqual(moves.engagement.max(), figures.engagement.max_deg, 6)
        self.assertAlmostEqual(moves.air_mm.sum(), figures.air_cut_mm, 6)
        self.assertTrue((moves.line > 0).all())
        self.assertTrue((moves.feed[cuts] > 0).all())

    def test_join_end_to_start(self):
        moves = self.plan.moves
        numpy.testing.assert_array_equal(moves.x[:-1], moves.from_x[1:])
        numpy.testing.assert_array_equal(moves.z[:-1], moves.from_z[1:])
        arcs = moves.turn != 0
        numpy.testing.assert_array_equal(arcs, ~numpy.isnan(moves.center_x))

    def test_outlive_their_plan(self):
        moves = clearcut.plan(pocket(), tools="endmill:6", strategy="zigzag").moves
        self.assertEqual(len(moves.columns(engagement=True)["engagement"]), len(moves))


class Ending(unittest.TestCase):
    """Progress, cancelling, Ctrl-C."""

    def long_plan(self, **more):
        """Minutes of work: a plate with many islands, and a small cutter."""
        islands = [[[x, y, 1], [x + 6, y, 1]] for x in range(10, 290, 14) for y in range(10, 190, 14)]
        part = clearcut.part(([[0, 0], [300, 0], [300, 200], [0, 200]], islands), depth=10)
        return clearcut.plan(part, tools="endmill:3", stepdown=0.5, **more)

    def test_progress_is_told(self):
        told = []
        clearcut.plan(pocket(), tools="endmill:6", progress=lambda *at: told.append(at))
        self.assertEqual(told[0][:2], ("planning", 0))
        self.assertEqual(told[-1][0], "certifying")

    def test_what_progress_raises_ends_the_plan(self):
        def progress(stage, done, most):
            raise KeyError(stage)

        with self.assertRaises(KeyError):
            clearcut.plan(pocket(), tools="endmill:6", progress=progress)

    def test_cancel(self):
        event = threading.Event()
        threading.Timer(0.5, event.set).start()
        with self.assertRaises(clearcut.Cancelled):
            self.long_plan(cancel=event)

    def assert_interrupted(self, work):
        sent = []

        def interrupt():
            sent.append(time.monotonic())
            signal.raise_signal(signal.SIGINT)

        # Programs that a shell started in the background ignore the signal.
        handler = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, handler)
        timer = threading.Timer(1.5, interrupt)
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                work()
        finally:
            timer.cancel()
        took = time.monotonic() - sent[0]
        self.assertLess(took, 0.2)

    def test_ctrl_c_ends_a_plan_within_a_fifth_of_a_second(self):
        for strategy in ("adaptive", "contour", "auto"):
            with self.subTest(strategy=strategy):
                self.assert_interrupted(lambda: self.long_plan(strategy=strategy))

    def test_ctrl_c_ends_a_tour(self):
        points = numpy.random.default_rng(1).random((20_000, 2))
        self.assert_interrupted(lambda: clearcut.tour(points, time=60))

    def test_other_threads_run_meanwhile(self):
        counted = []
        done = threading.Event()

        def count():
            while not done.is_set():
                counted.append(1)
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        clearcut.plan(pocket(), tools="endmill:6")
        done.set()
        thread.join()
        self.assertGreater(len(counted), 10)


class Own(unittest.TestCase):
    """Strategies written in Python."""

    @staticmethod
    def rings(layer):
        area = layer.clearing_area()
        passes = area.walls

        def add(region, parent, component):
            for ring in clearcut.inset(region, 0.5 * layer.tool_radius):
                outer = passes.add(ring.outer, parent=parent, component=component)
                for island in ring.islands:
                    passes.add(island, parent=parent, component=component)
                add(ring, outer, component)

        for number, component in enumerate(area.components):
            add(component.legal, component.outer_wall, number)
        return passes

    def test_is_planned_linked_and_certified(self):
        own = clearcut.Strategy("rings", self.rings, "contours at half the radius")
        plan = clearcut.plan(pocket(), tools="endmill:6", strategy="rings", strategies=[own])
        self.assertTrue(plan.clean)
        self.assertEqual(plan.selections[0].kept, "rings")
        self.assertEqual(plan.certificate()["features"][0]["strategy"], "rings")

    def test_is_tried_by_auto(self):
        own = clearcut.Strategy("rings", self.rings, in_auto=True)
        plan = clearcut.plan(pocket(), tools="endmill:6", strategies=[own])
        self.assertIn("rings", [one.strategy for one in plan.selections[0].candidates])

    def test_what_it_raises_ends_the_plan(self):
        def broken(layer):
            raise ZeroDivisionError("in my strategy")

        with self.assertRaisesRegex(ZeroDivisionError, "in my strategy"):
            clearcut.plan(pocket(), tools="endmill:6", strategy="own", strategies=[clearcut.Strategy("own", broken)])

    def test_its_refusal_leaves_auto_to_the_others(self):
        def refusing(layer):
            raise clearcut.InputError("not for pockets")

        own = clearcut.Strategy("own", refusing, in_auto=True)
        self.assertTrue(clearcut.plan(pocket(), tools="endmill:6", strategies=[own]).clean)

    def test_a_wrong_pass_is_no_clean_program(self):
        def outside(layer):
            passes = layer.clearing_area().walls
            passes.add([[-20, 0], [-10, 0]], closed=False)
            return passes

        plan = clearcut.plan(pocket(), tools="endmill:6", strategy="own", strategies=[clearcut.Strategy("own", outside)])
        self.assertEqual(plan.verdict, "FAULTY")

    def test_copies_are_of_one_program(self):
        plan = clearcut.plan(pocket(), tools="endmill:6", copies="2x1", gap=10)
        self.assertEqual((plan.copies["parts"], plan.copies["clean_parts"]), (2, 2))
        check = clearcut.verify(pocket(), plan.program, tools="endmill:6", dialect="linuxcnc", copies="2x1", gap=10)
        self.assertEqual(check.copies["clean_parts"], 2)
        self.assertIsNone(clearcut.plan(pocket(), tools="endmill:6").copies)
        with self.assertRaisesRegex(clearcut.InputError, "--gap: lies between copies"):
            clearcut.plan(pocket(), tools="endmill:6", gap=10)

    def test_parts_of_several_kinds_lie_on_one_sheet(self):
        plate, flat = str(EXAMPLES / "inlay_hole.dxf"), str(EXAMPLES / "inlay_plug.dxf")
        sheet = {"tools": ["vbit:90deg:12", "endmill:3"], "nest": "300x200", "gap": 5, "count": 2, "nest_with": [flat + ":1"]}
        plan = clearcut.plan(plate, **sheet)
        self.assertEqual([(kind["name"], kind["parts"]) for kind in plan.copies["kinds"]], [("inlay_hole.dxf", 2), ("inlay_plug.dxf", 1)])
        self.assertEqual(len(plan.copies["places"]), 3)
        self.assertIn(flat, plan.inputs)
        check = clearcut.verify(plate, plan.program, dialect="linuxcnc", **sheet)
        self.assertEqual(check.copies["clean_parts"], plan.copies["clean_parts"])

    def test_names_are_not_taken_twice(self):
        with self.assertRaisesRegex(clearcut.InputError, "'contour' is taken"):
            clearcut.plan(pocket(), strategies=[clearcut.Strategy("contour", self.rings)])

    def test_a_witness_that_is_none_is_refused(self):
        outline = '{"outer": [[0, 0], [9, 0], [9, 9], [0, 9]], "depth": 1}'
        with self.assertRaisesRegex(clearcut.InputError, "no witness of version 3"):
            clearcut.check_witness("G21\n", outline, b"CCW1 and more")


if __name__ == "__main__":
    unittest.main()
