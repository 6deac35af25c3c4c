#!/usr/bin/env bash
# checked.sh: the debug build under the address and undefined-behaviour sanitizers. Runs every module's own tests, then plans the
# examples with it and compares the programs with those of the release build, byte for byte.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset checked > /dev/null
cmake --build --preset checked --target unit_tests clearcut
ctest --preset checked -E '^system'
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for example in examples/bracket.json examples/bracket.toml examples/fishhead.p21; do
  for strategy in contour adaptive; do
    for build in release checked; do
      status=0
      build/$build/apps/cli/clearcut plan "$example" --tool endmill:6 --strategy $strategy --quiet -o "$folder/$build.ngc" || status=$?
      [ $status -le 1 ] || { echo "$example, $strategy: the $build build ended with $status" >&2; exit 1; }
    done
    cmp "$folder/release.ngc" "$folder/checked.ngc"
  done
done
echo "the checked build writes the release build's programs"
