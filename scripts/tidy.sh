#!/usr/bin/env bash
# tidy.sh [FILE...]: clang-tidy over the sources of src/ and apps/ (or those named) on all cores; any finding fails.
# Needs a configured build in build/release, in which every source is compiled alone (CLEARCUT_PRECOMPILED_HEADERS=OFF).
set -euo pipefail
cd "$(dirname "$0")/.."
files=("$@")
[ ${#files[@]} -gt 0 ] || mapfile -t files < <(git ls-files 'src/*.cpp' 'apps/*.cpp' ':!*_test.cpp')
grep -q '"[^"]*/apps/cli/main.cpp"' build/release/compile_commands.json ||
  { echo "tidy.sh: sources are compiled together; configure with: cmake --preset release -DCLEARCUT_PRECOMPILED_HEADERS=OFF" >&2; exit 1; }
# The compiler's own warnings are off: g++ gives them, and clang does not know all its flags.
printf '%s\0' "${files[@]}" |
  xargs -0 -n 4 -P "$(nproc)" clang-tidy -p build/release --quiet --extra-arg=-w --extra-arg=-Wno-unknown-warning-option \
    2> >(grep -v -E 'warnings? (and|generated|treated)|Suppressed|^Use -header-filter' >&2)
