#include "pipeline/steps/out_of_reach.h"

#include <algorithm>
#include <cmath>

#include "base/text/format.h"
#include "geometry/boolean.h"
#include "resolve/left_over.h"

namespace clearcut::pipeline {
namespace {

constexpr double kShare = 0.02;   // of the feature's area
constexpr double kCorners = 1.0;  // mm2
constexpr double kSameArea = 1e-9;
constexpr int kHalvings = 10;  // of the range of diameters that is searched
/// mm. Smaller cutters are not proposed.
constexpr double kSmallest = 0.1;

double allowed_to_stay(double area) {
  return std::min(kShare * area, kCorners);
}

/// mm2. What a cutter reaches of a pocket closed all round lies in it: areas are enough, which outlines of thousands of
/// edges need no boolean for.
double left_by(const Feature& feature, double diameter, const Tolerances& tol) {
  const Regions reached = resolve::swept(feature.allowed, diameter / 2, 0, 0, tol);
  const double target = area(feature.target);
  if (reached.empty()) return target;
  const bool closed = area(feature.allowed) - target <= kSameArea * target;
  return closed ? target - area(reached) : area(subtract(feature.target, reached, tol));
}

/// mm, in whole hundredths; 0 when none does.
double largest_that_reaches(const Feature& feature, double below, const Tolerances& tol) {
  const double may_stay = allowed_to_stay(area(feature.target));
  double low = kSmallest, high = below;
  if (high <= low || left_by(feature, low, tol) > may_stay) return 0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (left_by(feature, middle, tol) <= may_stay ? low : high) = middle;
  }
  return std::floor(low * 100) / 100;
}

/// That no cutter fits into a feature is a condition, which somebody may accept, and no fault of the program.
void withdraw_fault(FeatureFindings& found, Findings& findings) {
  const auto is_its = [&](const Fault& fault) {
    return fault.kind == FaultKind::kNothingCut && fault.feature == found.name;
  };
  if (std::erase_if(findings.faults, is_its) == 0) return;
  found.figures.clean = true;
  findings.all.clean = findings.faults.empty();
}

const Feature& feature_of(const Part& part, const FeatureFindings& found) {
  return part
      .features[static_cast<std::size_t>(part.workplan[static_cast<std::size_t>(found.workingstep)].feature)];
}

}  // namespace

std::vector<Condition> out_of_reach(const Part& part, const Findings& findings, const Tolerances& tol) {
  std::vector<Condition> conditions;
  for (const FeatureFindings& found : findings.features) {
    const Feature& feature = feature_of(part, found);
    const double whole = area(feature.target), left = found.figures.unreachable_mm2;
    if (left <= allowed_to_stay(whole)) continue;
    std::string text = feature.name + ": " + trimmed(left, 2) + " of " + trimmed(whole, 2) +
                       " mm2 are out of the reach of T" + std::to_string(found.tool_number) + " (" +
                       trimmed(found.tool_diameter, 3) + " mm)";
    // The area of a profile depends on its cutter, that of drafted walls on the depth.
    if (!feature.profile && feature.wall_slope.radians() == 0) {
      const double fits = largest_that_reaches(feature, found.tool_diameter, tol);
      text += fits > 0 ? "; the largest cutter that reaches all but " + trimmed(allowed_to_stay(whole), 2) +
                             " mm2 has " + trimmed(fits, 2) + " mm"
                       : "; no cutter of 0.1 mm or more reaches it";
    }
    const bool little = left <= std::max(kShare * whole, kCorners) && !is_nothing_in_reach(left, whole);
    conditions.push_back({"out-of-reach", text, 0, little ? "at most 2 percent or 1 mm2" : ""});
  }
  return conditions;
}

void add_conditions_of_part(const Part& part, const ResolvedPlan& plan, Findings& findings) {
  findings.conditions.insert(findings.conditions.end(), plan.conditions.begin(), plan.conditions.end());
  for (Condition& one : out_of_reach(part, findings, plan.tol)) findings.conditions.push_back(std::move(one));
  for (FeatureFindings& found : findings.features) {
    const double whole = area(feature_of(part, found).target);
    if (is_nothing_in_reach(found.figures.unreachable_mm2, whole)) withdraw_fault(found, findings);
  }
  accept_conditions(findings, plan.accept);
}

}  // namespace clearcut::pipeline
