"""The wheel is built by pip, the same bytes twice, and works in a virtual environment of its own."""
import hashlib
import os
import subprocess
import sys
import tarfile
import unittest
from pathlib import Path

from support import ROOT, folder

SMOKE = """
import clearcut
plan = clearcut.plan(clearcut.part([[0, 0], [30, 0], [30, 20], [0, 20]], depth=2), tools="endmill:6")
assert plan.clean, plan.table()
print(clearcut.__file__, clearcut.__version__, plan.verdict)
"""


@unittest.skipUnless(os.environ.get("CLEARCUT_BUILD_DIR"), "CLEARCUT_BUILD_DIR does not name a build folder")
class Wheel(unittest.TestCase):
    def run_well(self, *command, **more):
        run = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=3000, **more)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def test_is_built_twice_alike_and_runs_where_it_is_installed(self):
        here = folder(self)
        self.run_well(sys.executable, "-m", "venv", "--system-site-packages", here / "venv")
        python = here / "venv" / "bin" / "python"
        digests = set()
        for number in ("1", "2"):
            self.run_well(python, "-m", "pip", "wheel", "--no-index", "--no-deps", "-w", here / number, ROOT)
            (wheel,) = (here / number).glob("*.whl")
            digests.add(hashlib.sha256(wheel.read_bytes()).hexdigest())
        self.assertEqual(len(digests), 1)
        major, minor = sys.version_info[:2]
        self.assertRegex(wheel.name, rf"^clearcut-\d+\.\d+\.\d+-cp{major}{minor}-cp{major}{minor}-linux_")
        self.run_well(python, "-m", "pip", "install", "--no-index", wheel)
        clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        said = self.run_well(python, "-c", SMOKE, cwd=here, env=clean)
        self.assertIn(str(here / "venv"), said)
        self.assertIn("CLEAN", said)
        self.run_well(python, "-m", "pip", "uninstall", "-y", "clearcut")
        self.assertFalse(list((here / "venv").rglob("clearcut*")))

    def test_source_archive_says_what_it_is_and_holds_what_a_wheel_is_built_from(self):
        here = folder(self)
        build = "import sys; sys.path.insert(0, 'python/backend'); import clearcut_build as b; print(b.build_sdist(sys.argv[1]))"
        (here / "1").mkdir()
        name = self.run_well(sys.executable, "-c", build, here / "1", cwd=ROOT).strip()
        self.assertRegex(name, r"^clearcut-\d+\.\d+\.\d+\.tar\.gz$")
        # pip asks the archive's own backend for name and version; nothing is compiled or installed.
        said = self.run_well(sys.executable, "-m", "pip", "install", "--dry-run", "--break-system-packages", "--no-index", "--no-deps",
                             here / "1" / name, cwd=here)
        self.assertIn(f"Would install {name.removesuffix('.tar.gz')}", said)
        # Unpacked, without git, it gives itself again.
        with tarfile.open(here / "1" / name) as archive:
            archive.extractall(here / "unpacked")
        root = here / "unpacked" / name.removesuffix(".tar.gz")
        (here / "3").mkdir()
        self.run_well(sys.executable, "-c", build, here / "3", cwd=root, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
        packed = [hashlib.sha256((here / number / name).read_bytes()).hexdigest() for number in ("1", "3")]
        self.assertEqual(packed[0], packed[1])


if __name__ == "__main__":
    unittest.main()
