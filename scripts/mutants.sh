#!/bin/sh
# Changes constants of the published methods by 1 %, one at a time, and expects their tests to fail. Works on the sources in
# place and puts them back; takes a build for each. Usage: scripts/mutants.sh [BUILD_FOLDER]
set -u
cd "$(dirname "$0")/.." || exit 1
build=${1:-build/release}
survived=0
stem=''
restore() { [ -n "$stem" ] && [ -f "$stem.kept" ] && mv "$stem.kept" "$stem" && touch "$stem"; }
trap 'restore; exit 1' INT TERM

# mutant FILE FROM TO TEST_PROGRAM FILTER: FROM and TO are literal texts of one line.
mutant() {
  stem=$1
  if ! grep -qF -- "$2" "$stem"; then echo "NOT FOUND  $1: $2"; survived=$((survived + 1)); return; fi
  cp -p "$stem" "$stem.kept"
  awk -v from="$2" -v to="$3" '{ at = index($0, from)
    print (at ? substr($0, 1, at - 1) to substr($0, at + length(from)) : $0) }' "$stem.kept" > "$stem"
  if ! ninja -C "$build" "$4" > /dev/null; then verdict='NO BUILD   '; survived=$((survived + 1))
  elif "$build/$4" --gtest_brief=1 --gtest_filter="$5" > /dev/null 2>&1; then verdict='SURVIVED   '; survived=$((survived + 1))
  else verdict='killed     '; fi
  echo "$verdict$1: $2 -> $3"
  restore
}

formulas=src/plan/contour/formulas.cpp
mutant $formulas '(std::sin(alpha / 2) + 1) / 2' '(std::sin(alpha / 2) + 1) / 2.02' plan_test 'Formulas.*'
mutant $formulas '(std::sin(alpha / 2) + 1) / 2' '(std::sin(alpha / 1.98) + 1) / 2' plan_test 'Formulas.*'
mutant $formulas '(2 * radius) + 0.5' '(2 * radius) + 0.505' plan_test 'Formulas.*'
mutant $formulas '(radius - w)' '(radius - 1.01 * w)' plan_test 'Formulas.*'
mutant $formulas '(radius - 2 * radius * overlap)' '(radius - 2.02 * radius * overlap)' plan_test 'Formulas.*'
mutant $formulas 'return step / std::sin(alpha / 2)' 'return 1.01 * step / std::sin(alpha / 2)' plan_test 'Formulas.*:*Triangle*'
mutant src/plan/contour/side_offsets.cpp 'std::cos(angle / 2)' 'std::cos(angle / 1.98)' plan_test 'SideOffsets.*'
mutant src/pipeline/selection/compare.cpp 'kTau = 0.177' 'kTau = 0.17877' pipeline_test 'PublishedConstants.*'
mutant src/pipeline/tour/engagement_model.cpp 'std::expm1(5 *' 'std::expm1(5.05 *' pipeline_test 'PublishedConstants.*'
mutant src/pipeline/tour/engagement_model.cpp 'kLeast = 0.02' 'kLeast = 0.0202' pipeline_test 'PublishedConstants.*:Engagement.*'

[ "$survived" -eq 0 ] && echo 'every change of 1 % shows'
exit "$survived"
