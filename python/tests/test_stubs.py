"""The stubs name what there is, and mypy takes them."""
import inspect
import os
import subprocess
import sys
import unittest
from pathlib import Path

import clearcut
from clearcut import _core

PACKAGE = Path(clearcut.__file__).parent


class Stubs(unittest.TestCase):
    def setUp(self):
        text = (PACKAGE / "_core.pyi").read_text()
        self.classes = {"": set()}
        scope = ""
        for line in text.splitlines():
            words = line.replace("(", " ").replace(":", " ").split()
            if line.startswith("class "):
                scope = words[1]
                self.classes[scope] = set()
            elif line and not line.startswith((" ", ")", "@", '"')):
                scope = ""
            if line.lstrip().startswith("def "):
                self.classes[scope].add(words[1])
            elif scope and line.startswith("    ") and ":" in line and not line.startswith("     ") and words[0].isidentifier():
                self.classes[scope].add(words[0])

    def test_every_name_is_in_them(self):
        for name, value in vars(_core).items():
            if name.startswith("__"):
                continue
            if not inspect.isclass(value):
                self.assertIn(name, self.classes[""])
                continue
            self.assertIn(name, self.classes)
            inherited = self.classes["_Checked"] if name in ("Plan", "Check") else set()
            if issubclass(value, Exception):
                continue
            members = {member for member in vars(value) if not member.startswith("__")}
            self.assertEqual(members - self.classes[name] - inherited, set(), name)

    def test_every_option_is_a_keyword(self):
        options = {name for name in vars(_core.PlanOptions) if not name.startswith("__")} - {"replaced", "check"}
        self.assertEqual(options, self.classes["Settings"])

    def test_every_name_has_a_text(self):
        for name in clearcut.__all__:
            if name != "__version__":
                self.assertTrue(getattr(clearcut, name).__doc__, name)

    def test_mypy_takes_them_and_the_examples(self):
        root = Path(__file__).resolve().parents[2]
        run = subprocess.run(
            [os.environ.get("CLEARCUT_MYPY_PYTHON", sys.executable), "-m", "mypy", "--cache-dir", os.devnull, "--ignore-missing-imports",
             "--config-file", str(root / "pyproject.toml"), str(root / "python" / "clearcut"), str(root / "examples" / "python")],
            capture_output=True, text=True, timeout=300)
        if "No module named mypy" in run.stderr:
            self.skipTest("mypy is absent")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)


if __name__ == "__main__":
    unittest.main()
