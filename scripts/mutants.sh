#!/bin/sh
# Changes constants of the published methods by 1 %, one at a time, and expects their tests to fail. Works on the sources in
# place and puts them back; takes a build for each. Usage: scripts/mutants.sh [BUILD_FOLDER [FIRST [LAST]]], FIRST and LAST:
# numbers of the changes to begin and to end with.
set -u
cd "$(dirname "$0")/.." || exit 1
build=${1:-build/release}
begin=${2:-1}
end=${3:-1000}
number=0
survived=0
stem=''
restore() { [ -n "$stem" ] && [ -f "$stem.kept" ] && mv "$stem.kept" "$stem" && touch "$stem"; }
trap 'restore; exit 1' INT TERM

# mutant FILE FROM TO TEST_PROGRAM FILTER: FROM and TO are literal texts of one line.
mutant() {
  number=$((number + 1))
  [ "$number" -ge "$begin" ] && [ "$number" -le "$end" ] || return 0
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
mutant $formulas '(base::sin(alpha / 2) + 1) / 2' '(base::sin(alpha / 2) + 1) / 2.02' plan_test 'Formulas.*'
mutant $formulas '(base::sin(alpha / 2) + 1) / 2' '(base::sin(alpha / 1.98) + 1) / 2' plan_test 'Formulas.*'
mutant $formulas '(2 * radius) + 0.5' '(2 * radius) + 0.505' plan_test 'Formulas.*'
mutant $formulas '(radius - w)' '(radius - 1.01 * w)' plan_test 'Formulas.*'
mutant $formulas '(radius - 2 * radius * overlap)' '(radius - 2.02 * radius * overlap)' plan_test 'Formulas.*'
mutant $formulas 'return step / base::sin(alpha / 2)' 'return 1.01 * step / base::sin(alpha / 2)' plan_test 'Formulas.*:*Triangle*'
mutant src/plan/contour/side_offsets.cpp 'base::cos(angle / 2)' 'base::cos(angle / 1.98)' plan_test 'SideOffsets.*'
mutant src/model/results/published_time.h 'kPublishedStop = 0.177' 'kPublishedStop = 0.17877' kinematics_test 'PublishedTime.*'
mutant src/model/results/published_time.h 'cutting_s + 2 *' 'cutting_s + 2.02 *' kinematics_test 'PublishedTime.*'
mutant src/model/results/published_time.h '(1 + discontinuities)' '(1.01 + discontinuities)' kinematics_test 'PublishedTime.*'
mutant src/pipeline/tour/engagement_model.cpp 'base::expm1(5 *' 'base::expm1(5.05 *' pipeline_test 'PublishedConstants.*'
mutant src/pipeline/tour/engagement_model.cpp 'kLeast = 0.02' 'kLeast = 0.0202' pipeline_test 'PublishedConstants.*:Engagement.*'
constants='PublishedConstants.*'
mutant src/plan/contour/contour.h 'double w = 1.0' 'double w = 1.01' pipeline_test "$constants"
mutant src/plan/contour/step_rule.cpp '1.5 * radius * share' '1.515 * radius * share' plan_test 'StepRule.*'
mutant src/order/objective.h 'tau_s = 0.177' 'tau_s = 0.17877' pipeline_test "$constants"
mutant src/order/objective.cpp '.constant = 2 * tau_' '.constant = 2.02 * tau_' pipeline_test "$constants"
mutant src/pipeline/tour/engagement_model.cpp 'accuracy * std::sqrt(2.0)' 'accuracy * std::sqrt(2.04)' pipeline_test "$constants"
mutant src/pipeline/tool_sets.cpp '1000 * cutting_speed' '1010 * cutting_speed' pipeline_test "$constants"
mutant src/order/genetic/genetic.h 'most_shared = 0.2;' 'most_shared = 0.202;' pipeline_test "$constants"
mutant src/order/genetic/genetic.h 'population = 25;' 'population = 26;' pipeline_test "$constants"
mutant src/order/genetic/genetic.h 'neighbours = 24;' 'neighbours = 25;' pipeline_test "$constants"
mutant src/plan/grid/interpolate.cpp 'kPointsPerSquare = 3;' 'kPointsPerSquare = 3.03;' pipeline_test "$constants"
mutant src/plan/grid/interpolate.cpp 'kPaperStep = 0.001;' 'kPaperStep = 0.00101;' pipeline_test "$constants"
mutant src/plan/tour/tour.cpp '(options.pitch_in_mm ? 1 : 2 * radius())' '(options.pitch_in_mm ? 1 : 2.02 * radius())' pipeline_test "$constants"
mutant src/plan/common/layers.cpp 'scallop / base::sin(draft)' 'scallop / (1.01 * base::sin(draft))' pipeline_test "$constants"
mutant src/geometry/edge.cpp '4 * base::asin(' '4.04 * base::asin(' pipeline_test "$constants"
mutant studies/genetic/genetic_study.cpp 'kZ = 3;' 'kZ = 3.03;' studies_test 'GeneticStudy.*'
mutant src/order/genetic/genetic.h 'patience = 1000;' 'patience = 1010;' pipeline_test "$constants"
mutant src/plan/tour/tour.cpp 'box(work_.layer.target).grown(work_.radius())' 'box(work_.layer.target).grown(1.01 * work_.radius())' plan_test 'PlanTour.ThePublished*'
mutant studies/reproduce/reproduce_published.cpp 'kStudent = 4.303;' 'kStudent = 4.346;' studies_test 'PublishedFishhead.*'
mutant $formulas "base::sin(alpha / 2) / (2 * radius)" "base::sin(alpha / 1.98) / (2 * radius)" plan_test 'Formulas.*'
mutant $formulas '/ (2 * radius) + 0.5' '/ (2.02 * radius) + 0.5' plan_test 'Formulas.*'
mutant $formulas 'overlap) / base::sin(alpha / 2)' 'overlap) / base::sin(alpha / 1.98)' plan_test 'Formulas.*'
mutant $formulas 'return step / base::sin(alpha / 2)' 'return step / base::sin(alpha / 1.98)' plan_test 'Formulas.*:*Triangle*'
mutant src/plan/contour/side_offsets.cpp 'base::sin(angle / 2)' 'base::sin(angle / 1.98)' plan_test 'SideOffsets.*'
mutant src/plan/contour/step_rule.cpp 'step = 2 * radius * share' 'step = 2.02 * radius * share' plan_test 'StepRule.*'
mutant src/kinematics/kinematics.cpp 'time.cutting_s += 60 *' 'time.cutting_s += 60.6 *' kinematics_test 'PublishedTime.*'
mutant src/model/results/published_time.h 'published_seconds(60 * length_mm' 'published_seconds(60.6 * length_mm' kinematics_test 'PublishedTime.*'
mutant src/order/objective.cpp 'seconds_per_mm_(60 /' 'seconds_per_mm_(60.6 /' pipeline_test "$constants"
mutant src/order/objective.cpp '? 2 * tau_ : 0' '? 2.02 * tau_ : 0' pipeline_test "$constants"
mutant src/features/derived_outlines.cpp 'below_top * base::tan(' '1.01 * below_top * base::tan(' pipeline_test "$constants"
mutant src/order/moves.h 'kTurnThresholdDegrees = 0.1;' 'kTurnThresholdDegrees = 0.101;' order_test 'TurnAngle.*'

[ "$survived" -eq 0 ] && echo 'every change of 1 % shows'
exit "$survived"
