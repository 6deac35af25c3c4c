#!/usr/bin/env bash
# checked.sh: a debug build (little optimisation, assertions) under the address and undefined-behaviour sanitizers. Runs every
# module's own tests and the server's (noise, twenty clients; they fail where it leaks), then plans every shape of the tests and
# compares the programs with those of the release build, byte for byte. Needs a configured build in build/release. Two checks are
# left out (CMakePresets.json) that double the compiler's time: a null pointer that is followed ends the program anyway, and no pointer
# is cast to a wider type. The preset asan has them.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset checked > /dev/null
cmake --build --preset checked --target unit_tests clearcut-studies serve_test
# Random parts are fewer here, where each takes many times as long: `make test` has planned all of them.
CLEARCUT_RANDOM_PARTS=5 ctest --preset checked -E '^(system|library|install|ranks)'

cmake --build --preset release --target clearcut write_shapes
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
build/release/tests/write_shapes "$folder/shapes"

# programs BUILD STRATEGY: plans every shape, a drawing, a job and a STEP-NC part. A refusal is compared like a program.
programs() {
  local build=$1 strategy=$2 part to status depth
  mkdir -p "$folder/$build"
  for part in "$folder"/shapes/*.json examples/bracket.{json,dxf,toml} examples/fishhead.p21; do
    # A STEP-NC program has depths of its own.
    depth=(--depth 2)
    [[ $part != *.p21 ]] || depth=()
    to=$folder/$build/$(basename "$part")-$strategy
    status=0
    build/"$build"/apps/cli/clearcut plan "$part" --tool endmill:6 "${depth[@]}" --strategy "$strategy" --quiet -o "$to.ngc" \
      2> "$to.message" || status=$?
    [ $status -le 2 ] || { cat "$to.message" >&2; echo "$part, $strategy: the $build build ended with $status" >&2; exit 1; }
  done
}
# The two strategies beside each other: each plans one part at a time.
for build in release checked; do
  programs $build contour &
  contour=$!
  programs $build adaptive
  wait $contour
done
diff -rq "$folder/release" "$folder/checked"
echo "the checked build writes the release build's $(find "$folder/release" -name '*.ngc' | wc -l) programs"
