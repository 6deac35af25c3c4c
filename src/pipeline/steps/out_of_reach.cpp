#include "pipeline/steps/out_of_reach.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text/format.h"
#include "geometry/boolean.h"
#include "geometry/rectangle.h"
#include "resolve/left_over.h"

namespace clearcut::pipeline {
namespace {

constexpr double kShare = 0.02;   // of the feature's area
constexpr double kCorners = 1.0;  // mm2
/// Of the feature's area: where no more is reached, it is not what was asked for, however small it is.
constexpr double kMost = 0.5;
constexpr double kSameArea = 1e-9;
constexpr double kSaid = 0.005;  ///< mm2. Areas that differ by less read the same.
constexpr int kHalvings = 10;    // of the range of diameters that is searched
/// mm. Smaller cutters are not proposed.
constexpr double kSmallest = 0.1;
/// mm within a piece's edge: where it is looked for.
constexpr double kInside = 1e-3;

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

/// mm, in whole hundredths; the largest diameter below `below` for which `suffices` holds, 0 when none does.
template <class Suffices>
double largest_diameter(double below, Suffices suffices) {
  double low = kSmallest, high = below;
  if (high <= low || !suffices(low)) return 0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (suffices(middle) ? low : high) = middle;
  }
  return std::floor(low * 100) / 100;
}

double largest_that_reaches(const Feature& feature, double below, const Tolerances& tol) {
  const double may_stay = allowed_to_stay(area(feature.target));
  return largest_diameter(below,
                          [&](double diameter) { return left_by(feature, diameter, tol) <= may_stay; });
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

/// A point within each piece.
std::vector<Vec2> points_in(const Regions& pieces) {
  std::vector<Vec2> points;
  for (const Region& piece : pieces) {
    const Edge& side = piece.outer().front();
    points.push_back(side.at(0.5) + left_of(side.tangent_at(0.5)) * kInside);
  }
  return points;
}

/// The smallest of the loops about a point; null where there is none.
const Loop* innermost_about(Vec2 point, const std::vector<std::pair<Box, const Loop*>>& loops) {
  const Loop* best = nullptr;
  for (const auto& [box, loop] : loops) {
    if (!box.contains(point) || !contains(*loop, point)) continue;
    if (!best || std::abs(signed_area(*loop)) < std::abs(signed_area(*best))) best = loop;
  }
  return best;
}

/// How many groups of pieces a cutter can part: those that stand within one island of what it sweeps hang together.
std::size_t parted_by(const Feature& feature, const std::vector<Vec2>& pieces, double diameter,
                      const Tolerances& tol) {
  const Regions swept = resolve::swept(feature.allowed, diameter / 2, 0, 0, tol);
  std::vector<std::pair<Box, const Loop*>> islands;
  for (const Region& region : swept)
    for (const Loop& island : region.islands()) islands.emplace_back(box(island), &island);
  std::set<const Loop*> standing;
  for (const Vec2 piece : pieces) standing.insert(innermost_about(piece, islands));
  return standing.size();
}

double largest_that_parts(const Feature& feature, const std::vector<Vec2>& pieces, double below,
                          const Tolerances& tol) {
  return largest_diameter(
      below, [&](double diameter) { return parted_by(feature, pieces, diameter, tol) == pieces.size(); });
}

/// That pieces to be isolated stay joined, if they do: a short circuit, however small the area is.
std::optional<Condition> not_parted(const Feature& feature, const FeatureFindings& found,
                                    const Tolerances& tol) {
  const std::vector<Vec2> pieces =
      points_in(subtract({rectangular_region(box(feature.target))}, feature.allowed, tol));
  const std::size_t parted = parted_by(feature, pieces, found.tool_diameter, tol);
  if (parted == pieces.size()) return std::nullopt;
  const double fits = largest_that_parts(feature, pieces, found.tool_diameter, tol);
  return Condition{"not-parted",
                   feature.name + ": the " + std::to_string(pieces.size()) +
                       " pieces that stay are parted into " + std::to_string(parted) +
                       ", because gaps are narrower than T" + std::to_string(found.tool_number) + " (" +
                       trimmed(found.tool_diameter, 3) + " mm); " +
                       (fits > 0 ? "a cutter of " + trimmed(fits, 2) + " mm parts them all"
                                 : "no cutter of 0.1 mm or more parts them all"),
                   0, ""};
}

const Feature& feature_of(const Part& part, const FeatureFindings& found) {
  return part
      .features[static_cast<std::size_t>(part.workplan[static_cast<std::size_t>(found.workingstep)].feature)];
}

/// The layers of a profile above its tabs, of those between them; null of all others.
const Feature* above_tabs(const Feature& feature, const Part& part) {
  if (!feature.profile || feature.profile->tabs.empty()) return nullptr;
  for (const Feature& other : part.features)
    if (other.profile && other.profile->tabs.empty() && other.profile->line == feature.profile->line &&
        other.profile->side == feature.profile->side)
      return &other;
  return nullptr;
}

/// Whether as much is out of reach in the layers above the tabs: what stays in corners does so in all layers and is said once.
bool is_said_above_tabs(const FeatureFindings& found, const Part& part, const Findings& findings) {
  const Feature* above = above_tabs(feature_of(part, found), part);
  return above &&
         std::any_of(findings.features.begin(), findings.features.end(), [&](const FeatureFindings& other) {
           return &feature_of(part, other) == above && other.tool_number == found.tool_number &&
                  other.figures.unreachable_mm2 >= found.figures.unreachable_mm2 - kSaid;
         });
}

/// mm2 out of reach of a feature whose floor is to meet its walls in a fillet: the rounded corner of a cutter leaves nothing there that
/// should go.
double left_beside_fillet(const Feature& feature, const FeatureFindings& found, const Tolerances& tol) {
  const Regions swept = resolve::swept(feature.allowed, found.tool_diameter / 2, 0, 0, tol);
  return std::min(found.figures.unreachable_mm2, area(subtract(feature.target, swept, tol)));
}

/// What its reader doubts.
std::vector<Condition> doubts(const Part& part) {
  std::vector<Condition> conditions;
  for (const Diagnostic& one : part.diagnostics.items())
    if (!one.condition.empty()) conditions.push_back({one.condition, one.where + ": " + one.what, 0, ""});
  return conditions;
}

}  // namespace

std::vector<Condition> out_of_reach(const Part& part, const Findings& findings, const Tolerances& tol) {
  std::vector<Condition> conditions;
  for (const FeatureFindings& found : findings.features) {
    const Feature& feature = feature_of(part, found);
    if (feature.kind == FeatureKind::kIsolation) {
      if (auto joined = not_parted(feature, found, tol)) conditions.push_back(std::move(*joined));
    }
    // Tabs are no part of what a share is taken of.
    const Feature* above = above_tabs(feature, part);
    const double whole = area(above ? above->target : feature.target);
    const double left =
        feature.floor_fillet > 0 ? left_beside_fillet(feature, found, tol) : found.figures.unreachable_mm2;
    if (left <= allowed_to_stay(whole) || is_said_above_tabs(found, part, findings)) continue;
    std::string text = feature.name + ": " + trimmed(left, 2) + " of " + trimmed(whole, 2) +
                       " mm2 are out of the reach of T" + std::to_string(found.tool_number) + " (" +
                       trimmed(found.tool_diameter, 3) + " mm)";
    // The area of a profile depends on its cutter, that of drafted walls on the depth; of pieces it matters whether they are parted.
    if (!feature.profile && feature.kind != FeatureKind::kIsolation && feature.wall_slope.radians() == 0) {
      const double fits = largest_that_reaches(feature, found.tool_diameter, tol);
      text += fits > 0 ? "; the largest cutter that reaches all but " + trimmed(allowed_to_stay(whole), 2) +
                             " mm2 has " + trimmed(fits, 2) + " mm"
                       : "; no cutter of 0.1 mm or more reaches it";
    }
    const bool little = left <= std::max(kShare * whole, kCorners) && left <= kMost * whole;
    conditions.push_back({"out-of-reach", text, 0, little ? "at most 2 percent or 1 mm2" : ""});
  }
  return conditions;
}

void add_conditions_of_part(const Part& part, const ResolvedPlan& plan, Findings& findings) {
  findings.conditions.insert(findings.conditions.end(), plan.conditions.begin(), plan.conditions.end());
  for (Condition& one : doubts(part)) findings.conditions.push_back(std::move(one));
  for (Condition& one : out_of_reach(part, findings, plan.tol)) findings.conditions.push_back(std::move(one));
  for (FeatureFindings& found : findings.features) {
    const double whole = area(feature_of(part, found).target);
    if (is_nothing_in_reach(found.figures.unreachable_mm2, whole)) withdraw_fault(found, findings);
  }
  accept_conditions(findings, plan.accept);
}

}  // namespace clearcut::pipeline
