#!/usr/bin/env bash
# fuzz.sh [SECONDS] [TARGET...]: runs every fuzz target (or those named) for SECONDS (600) each, from the corpus in
# tests/corpus and what earlier runs kept in build/fuzz/corpus. Stops at the first finding; its input stays in build/fuzz.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-600}
[ $# -gt 0 ] && shift
cmake --preset fuzz > /dev/null
cmake --build --preset fuzz
targets=("$@")
[ ${#targets[@]} -gt 0 ] || mapfile -t targets < <(basename -s _fuzz.cpp fuzz/*_fuzz.cpp)
for target in "${targets[@]}"; do
  kept=build/fuzz/corpus/$target
  mkdir -p "$kept"
  mapfile -t seeds < <(find "tests/corpus/$target" -type d)
  dictionary=()
  [ -e "fuzz/$target.dict" ] && dictionary=("-dict=fuzz/$target.dict")
  echo "$target: $seconds s"
  build/fuzz/fuzz/"${target}_fuzz" -max_total_time="$seconds" -timeout=120 -rss_limit_mb=3000 -verbosity=0 \
    -print_final_stats=1 -artifact_prefix=build/fuzz/ "${dictionary[@]}" "$kept" "${seeds[@]}"
done
