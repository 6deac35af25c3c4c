"""Runs the tests of this folder in FreeCAD without a window: freecadcmd run.py. Ends with 1 where one fails."""

import os
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

try:
    found = unittest.defaultTestLoader.discover(str(HERE), pattern=os.environ.get("TESTS", "test_*.py"))
    result = unittest.TextTestRunner(stream=sys.stderr, verbosity=2).run(found)
    status = 0 if result.wasSuccessful() and result.testsRun else 1
except BaseException as error:
    print(error, file=sys.stderr)
    status = 1
# Neither an exception nor sys.exit() reaches the shell through freecadcmd.
sys.stderr.flush()
os._exit(status)
