#!/usr/bin/env bash
# threads.sh: the embedding example under the thread sanitizer, against the installed library: it plans a pocket, cancels a plan,
# and plans on four threads at once. Loops run on threads of the standard library (cmake/tsan): the sanitizer does not see into
# TBB, whose library is not built with it.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset tsan > /dev/null
cmake --build --preset tsan --target clearcut_library
ctest --preset tsan -R '^install\.embed$' --no-tests=error
