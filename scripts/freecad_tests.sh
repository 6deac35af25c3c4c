#!/usr/bin/env bash
# The FreeCAD add-on's tests, in FreeCAD without a window: freecad_tests.sh BUILD_FOLDER (with the Python module). The add-on lies where
# a user has it, in the folder Mod of FreeCAD's own; TESTS='test_proof.py' names some of them.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
module=$(realpath "$1")/python
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/Mod"
ln -s "$root/freecad" "$scratch/Mod/Clearcut"
cd "$scratch"
export FREECAD_USER_HOME=$scratch PYTHONPATH=$module PYTHONDONTWRITEBYTECODE=1
# FreeCAD's own chatter goes to a file; the tests speak on standard error.
freecadcmd "$root/freecad/tests/run.py" > "$scratch/log" || { tail -n 20 "$scratch/log"; exit 1; }
