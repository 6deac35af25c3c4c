"""Every example runs as it is printed."""
import os
import subprocess
import sys
import unittest
from pathlib import Path

from support import EXAMPLES, folder

import clearcut

FOLDER = EXAMPLES / "python"


class Examples(unittest.TestCase):
    def run_example(self, name, *words, needs=()):
        for package in needs:
            try:
                __import__(package)
            except ImportError:
                self.skipTest(f"{package} is absent")
        here = folder(self)
        run = subprocess.run([sys.executable, FOLDER / f"{name}.py", *map(str, words)], cwd=here, capture_output=True, text=True,
                             timeout=600, env={**os.environ, "MPLCONFIGDIR": str(here)})
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return here, run.stdout

    def assert_picture(self, file):
        """Keeps the picture where CLEARCUT_PICTURES names a folder: somebody looks at it."""
        content = file.read_bytes()
        self.assertTrue(content.startswith(b"\x89PNG"))
        self.assertGreater(len(content), 5000)
        if os.environ.get("CLEARCUT_PICTURES"):
            (Path(os.environ["CLEARCUT_PICTURES"]) / file.name).write_bytes(content)

    def test_first_pocket(self):
        here, said = self.run_example("first_pocket")
        self.assertIn("CLEAN", said)
        self.assertEqual(sorted(file.name for file in here.glob("first.*")), ["first.html", "first.json", "first.ngc", "first.svg"])
        code = [line for line in (FOLDER / "first_pocket.py").read_text().splitlines() if line.strip()]
        self.assertLessEqual(len(code), 10)

    def test_compare_strategies(self):
        here, said = self.run_example("compare_strategies", needs=["matplotlib"])
        self.assert_picture(here / "strategies.png")
        self.assertIn("contour", said)

    def test_engagement_histogram(self):
        here, _ = self.run_example("engagement_histogram", needs=["matplotlib"])
        self.assert_picture(here / "engagement.png")

    def test_verify_folder(self):
        programs = folder(self)
        plan = clearcut.plan(EXAMPLES / "bracket.json", tools="endmill:6", strategy="contour")
        (programs / "good.ngc").write_text(plan.program)
        (programs / "deep.ngc").write_text(plan.program.replace("Z-", "Z-1"))
        (programs / "odd.ngc").write_text("what is this\n")
        here, said = self.run_example("verify_folder", EXAMPLES / "bracket.json", "endmill:6", programs, needs=["pandas"])
        for word in ("CLEAN", "FAULTY", "UNREADABLE"):
            self.assertIn(word, said)
        self.assertEqual(len((here / "programs.csv").read_text().splitlines()), 4)

    def test_own_strategy(self):
        _, said = self.run_example("own_strategy")
        self.assertEqual(said.count("CLEAN"), 2)
        self.assertLessEqual(len((FOLDER / "own_strategy.py").read_text().splitlines()), 40)

    def test_published_figure(self):
        here, said = self.run_example("published_figure", 2, 50, needs=["matplotlib"])
        self.assert_picture(here / "crossover.png")
        self.assertIn("pmx", said)


if __name__ == "__main__":
    unittest.main()
