#include "pipeline/steps/out_of_reach.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <set>
#include <string>

#include "base/text.h"
#include "base/tolerances.h"
#include "features/round_hole.h"
#include "features/tool_choice.h"
#include "geometry/contours/boolean.h"
#include "geometry/opened_area.h"
#include "geometry/region.h"
#include "geometry/voronoi/clearance.h"
#include "model/cutter_profile.h"
#include "model/move.h"
#include "resolve/left_over.h"
#include "resolve/tabs.h"
#include "resolve/unreached.h"

namespace clearcut::pipeline {
namespace {

constexpr double kShare = 0.02;   // share of the feature's area
constexpr double kCorners = 1.0;  // mm2
/// Share of the feature's area: if no more is reached, the result is not as requested, however small the feature is.
constexpr double kMost = 0.5;
constexpr double kSameArea = 1e-9;
constexpr double kSaid = 0.005;  ///< mm2. Areas differing by less are printed equal.
constexpr int kHalvings = 10;    // of the searched range of diameters
/// mm. Smaller cutters are not proposed.
constexpr double kSmallest = 0.1;
/// mm; distance inside a piece's edge of the point by which the piece is identified.
constexpr double kInside = 1e-3;

double allowed_to_stay(double area) {
  return std::min(kShare * area, kCorners);
}

/// The rest of one feature for cutters of several diameters, from one diagram of its area.
class LeftByDiameter {
 public:
  LeftByDiameter(const Feature& feature, const Tolerances& tol)
      : feature_(feature), tol_(tol), target_(area(feature.target)) {
    for (const Region& region : feature.allowed) allowed_.emplace_back(region, tol);
    closed_ = area(feature.allowed) - target_ <= kSameArea * target_;
  }

  /// mm2. The area reached in a pocket closed all round is inside the pocket: comparing areas suffices, without
  /// booleans of outlines with thousands of edges.
  double left(double diameter) const {
    const double r = diameter / 2;
    bool corners_only = true;
    const Regions centers = legal(r, &corners_only);
    if (centers.empty()) return target_;
    if (closed_ && corners_only) return target_ - area_within(centers, r);
    const Regions reached = dilate(centers, r, tol_);
    return closed_ ? target_ - area(reached) : area(subtract(feature_.target, reached, tol_));
  }

  /// Whether certainly more than `most` mm2 is left, without computing the swept area.
  bool surely_leaves_more_than(double most, double diameter) const {
    if (!closed_) return left(diameter) > most;
    const double r = diameter / 2;
    return target_ - area_within(legal(r), r) > most + kSameArea * target_;
  }

 private:
  /// `corners_only` becomes false unless the cutter misses nothing but corners.
  Regions legal(double radius, bool* corners_only = nullptr) const {
    Regions all;
    for (std::size_t i = 0; i < allowed_.size(); ++i) {
      Regions inside = allowed_[i].inset(radius);
      if (corners_only && !is_opened_at_corners_only(feature_.allowed[i], inside)) *corners_only = false;
      for (Region& region : inside) all.push_back(std::move(region));
    }
    return all;
  }

  const Feature& feature_;
  const Tolerances& tol_;
  double target_ = 0;
  bool closed_ = false;
  std::vector<Clearance> allowed_;
};

/// mm, in whole hundredths; the largest diameter below `below` for which `suffices` is true, 0 if none.
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

/// mm, in whole hundredths; the largest diameter up to `at_most` for which `suffices` is true, 0 if none. The search
/// starts near `at_most`, with doubling steps.
template <class Suffices>
double largest_hundredth(double at_most, Suffices suffices) {
  const auto hundredths = [](double diameter) { return static_cast<int>(std::lround(diameter * 100)); };
  const auto holds = [&](int n) { return suffices(n / 100.0); };
  const int smallest = hundredths(kSmallest);
  int fails = hundredths(at_most) + 1, holding = fails - 1, step = 1;
  while (holding >= smallest && !holds(holding)) {
    fails = holding;
    holding = holding == smallest ? smallest - 1 : std::max(smallest, holding - step);
    step *= 2;
  }
  if (holding < smallest) return 0;
  while (fails - holding > 1) {
    const int middle = (fails + holding) / 2;
    (holds(middle) ? holding : fails) = middle;
  }
  return holding / 100.0;
}

double largest_that_reaches(const Feature& feature, double below, const Tolerances& tol) {
  const double may_stay = allowed_to_stay(area(feature.target));
  const LeftByDiameter leaves(feature, tol);
  // A bound gives the diameter; if this diameter really leaves no more, the search can end, since no larger one does.
  const double at_most =
      largest_diameter(below, [&](double d) { return !leaves.surely_leaves_more_than(may_stay, d); });
  if (at_most == 0) return 0;
  return largest_hundredth(at_most, [&](double d) { return leaves.left(d) <= may_stay; });
}

/// Takes the faults of these kinds of the feature back; returns whether there were any.
bool withdraw(std::initializer_list<FaultKind> kinds, FeatureFindings& found, Findings& findings) {
  const auto is_its = [&](const Fault& fault) {
    return fault.feature == found.name && std::find(kinds.begin(), kinds.end(), fault.kind) != kinds.end();
  };
  if (std::erase_if(findings.faults, is_its) == 0) return false;
  found.figures.clean = std::none_of(findings.faults.begin(), findings.faults.end(),
                                     [&](const Fault& fault) { return fault.feature == found.name; });
  findings.all.clean = findings.faults.empty();
  return true;
}

/// A feature into which no cutter fits is a condition that the user may accept, and no fault of the program. Returns whether
/// there was one.
bool withdraw_fault(FeatureFindings& found, Findings& findings) {
  return withdraw({FaultKind::kNothingCut}, found, findings);
}

/// mm. Floors of what lies above a feature are cut this near to its top.
constexpr double kAtTop = 0.01;

/// Whether a feed move goes below the feature's top over its area.
bool cuts_in(const Toolpath& toolpath, const Feature& feature) {
  const auto cuts = [&](const Move& move) {
    if (is_rapid(move.kind) || std::min(move.z_from, move.z_to) > feature.top_z - kAtTop) return false;
    return contains(feature.target, move.path.from) || contains(feature.target, move.path.to) ||
           contains(feature.target, move.path.at(0.5));
  };
  return std::any_of(toolpath.sections.begin(), toolpath.sections.end(), [&](const Section& section) {
    return std::any_of(section.moves.begin(), section.moves.end(), cuts);
  });
}

/// Features beyond the flutes of their tools that the program leaves out are conditions, and no faults.
void add_unreached(const Part& part, const Toolpath& toolpath, const Tolerances& tol, Findings& findings) {
  const std::vector<std::string> unreached = resolve::unreached_steps(part, tol);
  for (FeatureFindings& found : findings.features) {
    const std::string& why = unreached[static_cast<std::size_t>(found.workingstep)];
    if (why.empty()) continue;
    const Feature& feature = feature_of(part, part.workplan[static_cast<std::size_t>(found.workingstep)]);
    if (!cuts_in(toolpath, feature) && withdraw({FaultKind::kNothingCut, FaultKind::kUncut}, found, findings))
      findings.conditions.push_back({"out-of-reach", found.name + ": " + why, 0, ""});
  }
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

/// The smallest of the loops around a point; null if there is none.
const Loop* innermost_about(Vec2 point, const std::vector<std::pair<Box, const Loop*>>& loops) {
  const Loop* best = nullptr;
  for (const auto& [box, loop] : loops) {
    if (!box.contains(point) || !contains(*loop, point)) continue;
    if (!best || std::abs(signed_area(*loop)) < std::abs(signed_area(*best))) best = loop;
  }
  return best;
}

/// Number of groups of pieces that a cutter can separate: pieces within one island of its swept area stay joined.
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

/// The condition for pieces to be isolated that stay joined: a short circuit, however small the area is.
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

/// Whether an equal area is out of reach in the layers above the tabs: material in corners remains in all layers and
/// is reported once.
bool is_said_above_tabs(const FeatureFindings& found, const Part& part, const Findings& findings) {
  const Feature* above = above_tabs(feature_of(part, found), part);
  return above &&
         std::any_of(findings.features.begin(), findings.features.end(), [&](const FeatureFindings& other) {
           return &feature_of(part, other) == above && other.tool_number == found.tool_number &&
                  other.figures.unreachable_mm2 >= found.figures.unreachable_mm2 - kSaid;
         });
}

/// Whether the corner of the tool's end is rounder than the fillet that is asked for between floor and walls.
bool rounds_more(const Tool& tool, const Feature& feature) {
  return feature.floor_fillet > 0 && flat_end(tool) > 0 && !features::makes_fillet(tool, feature) &&
         tool.radius() - flat_end(tool) > feature.floor_fillet;
}

/// Description of a tool end that leaves material along walls or on the floor within reach of an equally wide flat
/// end mill; "" for a flat end.
std::string end_that_leaves(const Part& part, const Feature& feature, const FeatureFindings& found,
                            const Tolerances& tol) {
  const Tool& tool = tool_of(part, part.workplan[static_cast<std::size_t>(found.workingstep)]);
  const double flat = flat_end(tool);
  if (!features::keeps_fillet(tool, feature))
    return ", which keeps off the fillet of " + trimmed(feature.floor_fillet, 3) +
           " mm between floor and walls; a cutter with this corner radius makes it";
  if (flat >= tool.radius()) return "";
  if (rounds_more(tool, feature))
    return ", which rounds off " + trimmed(tool.radius() - flat, 3) + " mm where a fillet of " +
           trimmed(feature.floor_fillet, 3) + " mm is asked for; a cutter with this corner radius makes it";
  const std::string end = flat > 0 ? "rounds off " + trimmed(tool.radius() - flat, 3) + " mm"
                          : outer_profile(tool).round > 0 ? "ends in a ball"
                                                          : "ends in a point";
  const double left = LeftByDiameter(feature, tol).left(tool.diameter);
  return ", which " + end + "; a flat end mill as wide leaves " +
         (left <= allowed_to_stay(area(feature.target)) ? "none" : trimmed(left, 2) + " mm2");
}

/// The tool of a step on the feature whose end has the radius of the fillet between floor and walls; null if there is none.
const Tool* fillet_tool(const Part& part, const Feature& feature) {
  for (const Workingstep& step : part.workplan) {
    const Tool& tool = tool_of(part, step);
    if (&feature_of(part, step) == &feature && features::makes_fillet(tool, feature)) return &tool;
  }
  return nullptr;
}

/// mm2 out of reach in a feature with a fillet between floor and walls: material left by a rounded corner of its radius belongs to
/// the fillet. Sharper ends keep off it, and rounder ones leave more.
double left_beside_fillet(const Part& part, const Feature& feature, const FeatureFindings& found,
                          const Tolerances& tol) {
  const double unreachable = found.figures.unreachable_mm2;
  const Tool* tool = fillet_tool(part, feature);
  const Tool& own = tool_of(part, part.workplan[static_cast<std::size_t>(found.workingstep)]);
  const bool is_rounder = !tool && rounds_more(own, feature);
  if (!tool && !is_rounder) return unreachable;
  // A ball makes the fillet, but leaves cusps on the floor beside it. In a hole as wide as the ball there is no such floor.
  // Under a rounder corner, too, what lies within the fillet is to stay.
  if (is_rounder || flat_end(*tool) <= 0) {
    const double fillet = area(feature.target) - area(inset(feature.target, feature.floor_fillet, tol));
    return std::max(0.0, unreachable - fillet);
  }
  const Regions swept = resolve::swept(feature.allowed, found.tool_diameter / 2 - tol.fit, 0, tol.fit, tol);
  return std::min(unreachable, area(subtract(feature.target, swept, tol)));
}

/// Doubts of the part's reader.
std::vector<Condition> doubts(const Part& part) {
  std::vector<Condition> conditions;
  for (const Diagnostic& one : part.diagnostics.items())
    if (!one.condition.empty()) conditions.push_back({one.condition, one.where + ": " + one.what, 0, ""});
  return conditions;
}

/// The widest available mill narrower than those used on the feature, which keeps a fillet that is asked for; null if there is none.
const Tool* narrower_mill(const Part& part, const FeatureFindings& found) {
  const int feature = part.workplan[static_cast<std::size_t>(found.workingstep)].feature;
  double least = found.tool_diameter;
  for (const Workingstep& step : part.workplan)
    if (step.feature == feature) least = std::min(least, tool_of(part, step).diameter);
  const Tool* widest = nullptr;
  for (const Tool& tool : part.tools) {
    const bool is_narrower =
        mills_upright(tool) && tool.diameter < least - kSaid &&
        features::keeps_fillet(tool, part.features[static_cast<std::size_t>(feature)]) &&
        resolve::reaches_floor(part, part.features[static_cast<std::size_t>(feature)], tool);
    if (is_narrower && (!widest || tool.diameter > widest->diameter)) widest = &tool;
  }
  return widest;
}

/// Whether the feature cuts the part itself out of the stated stock and leaves nothing to hold it.
bool frees_unheld(const Feature& feature, const Part& part) {
  if (!feature.profile || !feature.profile->closed || !feature.profile->tabs.empty() || !part.stock)
    return false;
  return feature.floor_z <= part.stock->z_bottom + kSamePlaceMm && resolve::frees_part(feature, part);
}

/// One condition for all profiles freeing a part.
std::optional<Condition> loose_part(const Part& part) {
  std::string first;
  int count = 0;
  for (const Feature& feature : part.features) {
    if (frees_unheld(feature, part) && count++ == 0) first = feature.name;
  }
  if (count == 0) return std::nullopt;
  const std::string others = count > 1 ? " (and " + std::to_string(count - 1) + " more)" : "";
  return Condition{
      "loose-part",
      first + others +
          " goes through the stock all round, and what it surrounds comes loose: something else holds "
          "it, or leave tabs (--tabs 3) or a skin (--skin 0.3)",
      0, ""};
}

/// mm. A chamfer nearer than this to a wall is the chamfer of this wall.
constexpr double kOnWall = 0.05;

bool is_beside_wall_of(const Feature& feature, Vec2 point) {
  const auto is_near = [&](const Loop& loop) {
    return std::any_of(loop.begin(), loop.end(),
                       [&](const Edge& edge) { return distance(edge, point) < kOnWall; });
  };
  return std::any_of(feature.target.begin(), feature.target.end(), [&](const Region& region) {
    return is_near(region.outer()) || std::any_of(region.islands().begin(), region.islands().end(), is_near);
  });
}

/// Chamfers on walls of `unmade` features have nothing to break: conditions, and no faults.
void add_chamfers_of_unmade(const Part& part, const std::vector<const Feature*>& unmade, Findings& findings) {
  for (FeatureFindings& found : findings.features) {
    const Feature& feature = feature_of(part, found);
    if (!feature.chamfer) continue;
    const Vec2 point = feature.chamfer->line.front().from;
    const auto wall = std::find_if(unmade.begin(), unmade.end(),
                                   [&](const Feature* other) { return is_beside_wall_of(*other, point); });
    if (wall != unmade.end() && withdraw_fault(found, findings))
      findings.conditions.push_back(
          {"out-of-reach", found.name + ": it has no edge to break, as nothing reaches into " + (*wall)->name,
           0, ""});
  }
}

/// Round holes without a suitable tool, of one size.
struct UnmadeHoles {
  std::string first, why;
  int count = 0;
};

std::string no_tool_of_size(const features::RoundHole& hole, const Tool& tool) {
  const double diameter = 2 * hole.radius;
  const std::string width = trimmed(diameter, 3);
  return "no tool at hand makes a hole of " + width + " mm; T" + std::to_string(tool.number) + " (" +
         name_of(tool.kind) + " " + trimmed(tool.diameter, 3) + " mm) is " +
         (tool.diameter < diameter ? "narrower" : "wider") +
         "; give a drill of its size (--tool drill:" + width + ") or an end mill that fits";
}

/// Why the feature is a round hole that its tool, which has vertical moves only, does not make; nothing for other features.
std::optional<std::string> why_unmade(const Part& part, const FeatureFindings& found, const Tolerances& tol) {
  const Workingstep& step = part.workplan[static_cast<std::size_t>(found.workingstep)];
  const Tool& tool = tool_of(part, step);
  const Feature& feature = feature_of(part, found);
  if (!makes_holes(tool) || !step.operation.is_tool_chosen ||
      !is_nothing_in_reach(found.figures.unreachable_mm2, area(feature.target)))
    return std::nullopt;
  const auto hole = features::round_hole_of(feature, tol);
  if (!hole) return std::nullopt;
  if (!features::makes_hole(tool, *hole, tol)) return no_tool_of_size(*hole, tool);
  if (!features::is_shallower_than_point(feature, tool, tol)) return std::nullopt;
  return point_longer_than_hole(feature, tool);
}

void add_hole(std::vector<UnmadeHoles>& unmade, const Feature& hole, const std::string& why) {
  const auto same =
      std::find_if(unmade.begin(), unmade.end(), [&](const UnmadeHoles& other) { return other.why == why; });
  if (same == unmade.end())
    unmade.push_back({hole.name, why, 1});
  else
    ++same->count;
}

Condition condition_of(const UnmadeHoles& unmade) {
  const std::string others = unmade.count > 1 ? " (and " + std::to_string(unmade.count - 1) + " more)" : "";
  return {"out-of-reach", unmade.first + others + ": " + unmade.why, 0, ""};
}

}  // namespace

std::string point_longer_than_hole(const Feature& feature, const Tool& tool) {
  const std::string width = trimmed(tool.diameter, 3);
  return "T" + std::to_string(tool.number) + " (drill " + width + " mm) ends in a point of " +
         trimmed(point_length(tool), 3) + " mm, and the hole is " +
         trimmed(feature.top_z - feature.floor_z, 3) +
         " mm deep; state its angle, by which it then goes deeper (--tool drill:" + width +
         ":118deg), or give an end mill that fits";
}

std::vector<Condition> out_of_reach(const Part& part, const Findings& findings, const Tolerances& tol) {
  std::vector<Condition> conditions;
  std::vector<UnmadeHoles> unmade;
  for (const FeatureFindings& found : findings.features) {
    const Feature& feature = feature_of(part, found);
    if (const auto why = why_unmade(part, found, tol)) {
      add_hole(unmade, feature, *why);
      continue;
    }
    if (feature.kind == FeatureKind::kIsolation) {
      if (auto joined = not_parted(feature, found, tol)) conditions.push_back(std::move(*joined));
    }
    // Tabs do not count in the area of which the share is computed.
    const Feature* above = above_tabs(feature, part);
    const double whole = area(above ? above->target : feature.target);
    const double left = feature.floor_fillet > 0 ? left_beside_fillet(part, feature, found, tol)
                                                 : found.figures.unreachable_mm2;
    if (left <= allowed_to_stay(whole) || is_said_above_tabs(found, part, findings)) continue;
    std::string text = feature.name + ": " + trimmed(left, 2) + " of " + trimmed(whole, 2) +
                       " mm2 are out of the reach of T" + std::to_string(found.tool_number) + " (" +
                       trimmed(found.tool_diameter, 3) + " mm)";
    // The area of a profile depends on its cutter, that of drafted walls on the depth; for isolated pieces only their
    // separation matters.
    if (!feature.profile && feature.kind != FeatureKind::kIsolation && feature.wall_slope.radians() == 0) {
      const std::string end = end_that_leaves(part, feature, found, tol);
      const double fits = largest_that_reaches(feature, found.tool_diameter, tol);
      text += !end.empty() ? end
              : fits > 0 ? "; the largest cutter that reaches all but " + trimmed(allowed_to_stay(whole), 2) +
                               " mm2 has " + trimmed(fits, 2) + " mm"
                         : "; no cutter of 0.1 mm or more reaches it";
    }
    if (const Tool* narrower = feature.profile ? nullptr : narrower_mill(part, found))
      text += "; with --rest T" + std::to_string(narrower->number) + " (" + trimmed(narrower->diameter, 3) +
              " mm) mills what T" + std::to_string(found.tool_number) + " leaves";
    const bool little = left <= std::max(kShare * whole, kCorners) && left <= kMost * whole;
    conditions.push_back({"out-of-reach", text, 0, little ? "at most 2 percent or 1 mm2" : ""});
  }
  std::transform(unmade.begin(), unmade.end(), std::back_inserter(conditions), condition_of);
  return conditions;
}

void add_conditions_of_part(const Part& part, const Toolpath& toolpath, const ResolvedPlan& plan,
                            Findings& findings) {
  findings.conditions.insert(findings.conditions.end(), plan.conditions.begin(), plan.conditions.end());
  for (Condition& one : doubts(part)) findings.conditions.push_back(std::move(one));
  if (auto loose = loose_part(part)) findings.conditions.push_back(*std::move(loose));
  for (Condition& one : out_of_reach(part, findings, plan.tol)) findings.conditions.push_back(std::move(one));
  add_unreached(part, toolpath, plan.tol, findings);
  std::vector<const Feature*> unmade;
  for (FeatureFindings& found : findings.features) {
    const Feature& feature = feature_of(part, found);
    if (!is_nothing_in_reach(found.figures.unreachable_mm2, area(feature.target))) continue;
    unmade.push_back(&feature);
    withdraw_fault(found, findings);
  }
  add_chamfers_of_unmade(part, unmade, findings);
  accept_conditions(findings, plan.accept);
}

}  // namespace clearcut::pipeline
