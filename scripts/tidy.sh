#!/usr/bin/env bash
# tidy.sh [--recent COUNT | FILE...]: clang-tidy over the sources of src/ and apps/ (or the COUNT that were changed last, or those
# named) on all cores; any finding fails. Each source is parsed alone, so one that lacks an include is found here, although the
# build parses common headers once.
set -euo pipefail
cd "$(dirname "$0")/.."
# A folder of its own that is configured and never built: sources one by one, without g++'s precompiled headers.
cmake --preset release -B build/tidy -DCLEARCUT_PRECOMPILED_HEADERS=OFF -DCLEARCUT_TESTS=OFF > /dev/null
files=("$@")
[ ${#files[@]} -gt 0 ] && [ "$1" != --recent ] || mapfile -t files < <(git ls-files 'src/*.cpp' 'apps/*.cpp' ':!*_test.cpp')
if [ "${1:-}" = --recent ]; then
  # By the commit that touched them last; a file that was moved away since is none of those that are there.
  mapfile -t files < <(git log --name-only --format= -- 'src/*.cpp' 'apps/*.cpp' ':!*_test.cpp' | awk '!seen[$0]++' |
                       grep -Fx -f <(printf '%s\n' "${files[@]}") | head -n "$2")
fi
# The compiler's own warnings are off: g++ gives them, and clang does not know all its flags.
printf '%s\0' "${files[@]}" |
  xargs -0 -n 4 -P "$(nproc)" clang-tidy -p build/tidy --quiet --extra-arg=-w --extra-arg=-Wno-unknown-warning-option \
    2> >(grep -v -E 'warnings? (and|generated|treated)|Suppressed|^Use -header-filter' >&2)
