"""What the tests of the module share."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import clearcut

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
L_SHAPE = [[0, 0], [60, 0], [60, 40], [30, 40], [30, 25], [0, 25]]


def pocket(**more):
    return clearcut.part(L_SHAPE, depth=4, name="pocket", **more)


def run_command(*arguments):
    """The command line's own run; the tests that compare with it are skipped, and say so, where CLEARCUT_COMMAND is not set."""
    command = os.environ.get("CLEARCUT_COMMAND")
    if not command:
        raise unittest.SkipTest("CLEARCUT_COMMAND does not name the command")
    return subprocess.run([command, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def folder(test):
    """An empty folder that is gone after the test."""
    made = tempfile.TemporaryDirectory()
    test.addCleanup(made.cleanup)
    return Path(made.name)
