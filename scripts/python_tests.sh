#!/usr/bin/env bash
# The Python module's tests: python_tests.sh COMMAND BUILD_FOLDER [TEST...]. Debian's interpreter, whose packages they use.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
CLEARCUT_COMMAND=$(realpath "$1")
CLEARCUT_BUILD_DIR=$(realpath "$2")
shift 2
export CLEARCUT_COMMAND CLEARCUT_BUILD_DIR PYTHONPATH=$CLEARCUT_BUILD_DIR/python PYTHONDONTWRITEBYTECODE=1
cd "$root/python/tests"
if [ $# -gt 0 ]; then exec /usr/bin/python3 -m unittest "$@"; fi
exec /usr/bin/python3 -m unittest discover -v
