"""What the module costs: memory over many calls, time beside the command's, time of columns. Figures are printed."""
import resource
import time
import unittest

import numpy
from support import EXAMPLES, folder, pocket, run_command

import clearcut


def resident_mb():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 1e6


class Leaks(unittest.TestCase):
    def setUp(self):
        self.square = clearcut.part([[0, 0], [20, 0], [20, 20], [0, 20]], depth=1)
        self.region = clearcut.region([[0, 0], [20, 0], [20, 20], [0, 20]])
        self.program = clearcut.plan(self.square, tools="endmill:8", strategy="zigzag", threads=1).program
        self.own = clearcut.Strategy("walls", lambda layer: layer.clearing_area().walls)
        self.calls = (self.plan, self.own_strategy, self.verify, self.columns, self.part, self.booleans, self.clearance,
                      self.refusal, self.papers, self.raising)
        self.last = clearcut.plan(self.square, tools="endmill:8", strategy="zigzag", threads=1)

    def plan(self):
        self.last = clearcut.plan(self.square, tools="endmill:8", strategy="zigzag", threads=1)

    def own_strategy(self):
        clearcut.plan(self.square, tools="endmill:8", strategy="walls", strategies=[self.own], threads=1)

    def verify(self):
        clearcut.verify(self.square, self.program, tools="endmill:8", threads=1)

    def columns(self):
        self.last.moves.columns(engagement=True)

    def part(self):
        clearcut.read_part_text(clearcut.part([[0, 0], [9, 0], [9, 9]], depth=2).to_json(), "again.json")

    def booleans(self):
        clearcut.subtract(clearcut.dilate([self.region], 2), clearcut.inset(self.region, 2))[0].outer

    def clearance(self):
        clearcut.Clearance(self.region).axis()

    def refusal(self):
        with self.assertRaises(clearcut.InputError):
            clearcut.plan(self.square, tools="endmil:8")

    def papers(self):
        self.last.certificate(), self.last.table(), self.last.picture(), self.last.findings, self.last.part

    def raising(self):
        def progress(stage, done, most):
            raise KeyError(stage)

        with self.assertRaises(KeyError):
            clearcut.plan(self.square, tools="endmill:8", strategy="zigzag", threads=1, progress=progress)

    def test_ten_thousand_calls_leave_nothing_behind(self):
        """Of ten kinds, a thousand each: what the first two thousand calls take once is allowed."""
        grown = []
        for number in range(10_000):
            self.calls[number % len(self.calls)]()
            if number % 2000 == 1999:
                grown.append(resident_mb())
        print("\nresident after 2, 4, 6, 8, 10 thousand calls, MB:", *(f"{mb:.1f}" for mb in grown))
        self.assertLess(grown[-1] - grown[0], 4)


class Times(unittest.TestCase):
    def test_a_plan_costs_what_the_commands_costs(self):
        """Processor time of planning the fishhead here and by the command, in turn; the least of each, for the machine has other work."""
        here = folder(self)
        part = EXAMPLES / "fishhead.p21"

        def of_command():
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            run_command("plan", part, "--output", here / "p.ngc", "--quiet", "--threads", "1")
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

        def of_module():
            before = time.process_time()
            clearcut.plan(part, threads=1)
            return time.process_time() - before

        command, module = [], []
        for most in (5, 10, 20):
            while len(command) < most:
                command.append(of_command())
                module.append(of_module())
            overhead = min(module) / min(command) - 1
            if overhead < 0.05:
                break
        print(f"\nfishhead: command {min(command):.3f} s, module {min(module):.3f} s, {100 * overhead:+.1f} %")
        self.assertLess(overhead, 0.05)

    def test_a_million_moves_become_columns_in_a_tenth_of_a_second(self):
        lines = [f"X{3 + (i % 1000) * 0.02:.2f} Y{3 + (i // 1000) * 0.01:.2f}" for i in range(1_000_000)]
        program = "\n".join(["G21 G90 G17 G94", "T1 M6", "S8000 M3", "G0 X3 Y3", "G43 H1 Z5", "G1 F800", *lines, "G0 Z10", "M30", ""])
        moves = clearcut.verify(pocket(), program, tools="endmill:6").moves
        self.assertGreaterEqual(len(moves), 999_000)
        took = []
        for _ in range(3):
            before = time.thread_time()
            columns = [moves.x, moves.y, moves.z, moves.feed, moves.kind, moves.line]
            took.append(time.thread_time() - before)
        print(f"\n{len(moves)} moves to six columns: {min(took):.3f} s")
        self.assertLess(min(took), 0.1)
        self.assertTrue(all(len(column) == len(moves) for column in columns))
        numpy.testing.assert_allclose(columns[0].max(), 3 + 999 * 0.02)


if __name__ == "__main__":
    unittest.main()
