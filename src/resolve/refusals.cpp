#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "features/round_hole.h"
#include "features/standing.h"
#include "features/tool_choice.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "model/results/findings.h"
#include "model/results/nothing_to_machine.h"
#include "resolve/features/clamps.h"
#include "resolve/features/hole_tools.h"
#include "resolve/resolve.h"
#include "resolve/unreached.h"

namespace clearcut::resolve {
namespace {

/// mm. Heights nearer than this are one.
constexpr double kLevel = 0.01;
/// mm. Features nearer than this have no wall between them.
constexpr double kBeside = 0.01;
/// Relative difference of areas that are one.
constexpr double kSameArea = 1e-6;
/// Assumed reach of flutes of unknown length, in diameters.
constexpr double kReachOfMill = 10;
constexpr double kReachOfDrill = 20;
/// mm. A longer path takes months, and its program more memory than there is: the part is mostly read in a wrong
/// unit.
constexpr double kLongestPath = 1e8;

void refuse_low_rapids(const Part& part) {
  if (!part.clearance_z || *part.clearance_z > part.top_z()) return;
  throw InputError(
      "clearance",
      fmt::format("rapid travel at z {} would run through the material, whose top is at z {}; give a "
                  "height above it, for example {}",
                  trimmed(*part.clearance_z, 3), trimmed(part.top_z(), 3), trimmed(part.top_z() + 5, 3)));
}

/// The feature's name, and its place in the input: "h (#30)".
std::string name_and_place(const Feature& feature) {
  const bool apart = !feature.source.empty() && feature.source != feature.name;
  return feature.name + (apart ? " (" + feature.source + ")" : "");
}

void refuse_above_stock(const Feature& feature, const Stock& stock) {
  const bool faces = feature.kind == FeatureKind::kPlanarFace;
  if (feature.floor_z < stock.z_top + (faces ? kLevel : -kSamePlaceMm)) return;
  const bool is_cut = feature.top_z > feature.floor_z + kSamePlaceMm;
  throw InputError(
      name_and_place(feature),
      fmt::format("it lies above the material: {}, where the material is z {} to {}; correct its "
                  "height or the stock",
                  is_cut ? fmt::format("z {} to {}", trimmed(feature.floor_z, 3), trimmed(feature.top_z, 3))
                         : fmt::format("its floor is at z {}", trimmed(feature.floor_z, 3)),
                  trimmed(stock.z_bottom, 3), trimmed(stock.z_top, 3)));
}

void refuse_spent_hole(const Feature& feature) {
  const bool is_shaped_later = feature.kind != FeatureKind::kRoundHole || features::is_cone(feature);
  if (is_shaped_later || feature.top_z > feature.floor_z + kSamePlaceMm) return;
  throw InputError(name_and_place(feature),
                   fmt::format("what is cut before it leaves no material above its floor at z "
                               "{}; correct its depth or leave it out",
                               trimmed(feature.floor_z, 3)));
}

void refuse_above_stock(const Part& part, const Workingstep& step) {
  if (part.stock) refuse_above_stock(feature_of(part, step), *part.stock);
  refuse_spent_hole(feature_of(part, step));
}

void refuse_below_stock(const Part& part, const Feature& feature) {
  const double floor = asked_floor(feature);
  if (!lies_below(part, feature, floor)) return;
  throw InputError(
      name_and_place(feature),
      fmt::format("its floor at z {} lies {} mm below the material, which ends at z {}; give less "
                  "depth or thicker stock",
                  trimmed(floor, 3), trimmed(part.stock->z_bottom - floor, 3),
                  trimmed(part.stock->z_bottom, 3)));
}

void refuse_beside_stock(const Part& part, const Feature& feature) {
  if (!part.stock || feature.target.empty() || part.stock->plan.overlaps(box(feature.target))) return;
  const Box& stock = part.stock->plan;
  const Box own = box(feature.target);
  throw InputError(name_and_place(feature),
                   fmt::format("it lies beside the material: x {} to {}, y {} to {}, where the material "
                               "is x {} to {}, y {} to {}; correct its place or the stock",
                               trimmed(own.min.x, 3), trimmed(own.max.x, 3), trimmed(own.min.y, 3),
                               trimmed(own.max.y, 3), trimmed(stock.min.x, 3), trimmed(stock.max.x, 3),
                               trimmed(stock.min.y, 3), trimmed(stock.max.y, 3)));
}

void refuse_wrong_kind(const Part& part, const Workingstep& step) {
  const Feature& feature = feature_of(part, step);
  const Tool& tool = tool_of(part, step);
  if (clears_floors(tool) || makes_holes(tool) || is_carved(feature, tool) || is_formed(feature) ||
      feature.kind == FeatureKind::kTSlot)
    return;
  if (tool.kind == ToolKind::kTSlot)
    throw InputError(
        feature.name,
        fmt::format(
            "T{} ({} {} mm) cuts undercuts alone, along lines that say so (a layer named like TSLOT_D12, "
            "--op tslot_d12:SELECTION); give an end mill, for example --tool endmill:6",
            tool.number, name_of(tool.kind), trimmed(tool.diameter, 4)));
  throw InputError(feature.name,
                   fmt::format("T{} ({} {} mm) clears no floors; give an end mill for it, for example --tool "
                               "endmill:6",
                               tool.number, name_of(tool.kind), trimmed(tool.diameter, 4)));
}

/// The length that flutes must have: mm from the floor up to the top of the material beside the tool when the step, of the
/// workplan of the part, begins. Over a wider hole or pocket that was cut before it, nothing stands beside the tool.
double height_beside_tool(const Part& part, const Workingstep& step, const Tolerances& tol) {
  const Feature& feature = feature_of(part, step);
  // A mill that may leave its target comes beside material that the target does not tell of.
  const bool is_closed =
      makes_holes(tool_of(part, step)) || area(feature.allowed) <= area(feature.target) * (1 + kSameArea);
  const auto before = static_cast<std::size_t>(&step - part.workplan.data());
  const double top = is_closed
                         ? features::top_beside_tool(part, before, feature.target, tool_of(part, step), tol)
                         : part.top_z();
  return top - feature.floor_z;
}

/// mm; greatest length of flutes that a step with the step's tool needs.
double longest_with_tool_of(const Part& part, const Workingstep& step, const Tolerances& tol) {
  double longest = 0;
  for (const Workingstep& other : part.workplan) {
    if (other.operation.tool == step.operation.tool)
      longest = std::max(longest, height_beside_tool(part, other, tol));
  }
  return longest;
}

/// Why the feature lies deeper than the flutes of the step's tool reach; nothing if it does not.
std::optional<std::string> beyond_flutes(const Part& part, const Workingstep& step, const Tolerances& tol) {
  const Feature& feature = feature_of(part, step);
  const Tool& tool = tool_of(part, step);
  // Rows of teeth cut a thread in several passes; their shank is narrower.
  if (tool.kind == ToolKind::kThreadMill || tool.kind == ToolKind::kTSlot) return std::nullopt;
  if (reaches_floor(part, feature, tool)) return std::nullopt;
  if (tool.flute_length) {
    const double height = height_beside_tool(part, step, tol);
    if (height <= *tool.flute_length + kLevel) return std::nullopt;
    return fmt::format(
        "its floor lies {} mm below the top of the material around it and the flutes "
        "of T{} are {} mm long; use a longer tool or less depth",
        trimmed(height, 3), tool.number, trimmed(*tool.flute_length, 3));
  }
  const double depth = feature.top_z - feature.floor_z;
  return fmt::format(
      "it is {} mm deep, {} diameters of T{}; if the flutes reach that far say so "
      "(--tool {}:{}:length={}, flute_length in files), else use less depth",
      trimmed(depth, 3), trimmed(depth / tool.diameter, 0), tool.number, name_of(tool.kind),
      trimmed(tool.diameter, 4), trimmed(longest_with_tool_of(part, step, tol), 3));
}

/// z of the tool's tip in a hole: a drill whose angle is stated goes deeper than a plain hole by its point.
double tip_in_hole(const Feature& feature, const Tool& tool) {
  const bool is_plain = feature.kind == FeatureKind::kRoundHole && !feature.hole;
  return is_plain && tool.kind == ToolKind::kDrill && tool.tip_angle ? feature.floor_z - point_length(tool)
                                                                     : feature.floor_z;
}

/// Why the end of the step's tool, which goes deeper than the hole, has no room in the material; nothing if it has.
std::optional<std::string> below_material(const Part& part, const Workingstep& step) {
  const Feature& feature = feature_of(part, step);
  const Tool& tool = tool_of(part, step);
  const double tip = tip_in_hole(feature, tool);
  if (!comes_out_below(part, feature, tip) || lies_below(part, feature, asked_floor(feature)))
    return std::nullopt;
  return fmt::format(
      "the end of T{} ({} {} mm) goes down to z {}, {} mm below the material, which ends at z {}; give less "
      "depth, "
      "thicker stock, or an end mill that fits",
      tool.number, name_of(tool.kind), trimmed(tool.diameter, 3), trimmed(tip, 3),
      trimmed(part.stock->z_bottom - tip, 3), trimmed(part.stock->z_bottom, 3));
}

/// Why the step's tool does not make its feature; nothing if it does.
std::optional<std::string> why_not_made(const Part& part, const Workingstep& step, const Tolerances& tol) {
  if (auto why = beyond_flutes(part, step, tol)) return why;
  return below_material(part, step);
}

void refuse_unmade(const Part& part, const Workingstep& step, const Tolerances& tol) {
  if (const auto why = why_not_made(part, step, tol)) throw InputError(feature_of(part, step).name, *why);
}

double widest_radius(const Part& part) {
  double widest = 0;
  for (const Tool& tool : part.tools) widest = std::max(widest, tool.radius());
  return widest;
}

/// mm of path needed to clear a feature's floor with passes half a diameter apart; 0 if no floor is cleared.
double path_of(const Part& part, const Workingstep& step) {
  const Feature& feature = feature_of(part, step);
  const Tool& tool = tool_of(part, step);
  if (!clears_floors(tool) || feature.profile || is_carved(feature, tool) || is_formed(feature)) return 0;
  const double down = step.operation.stepdown.value_or(tool.radius());
  return area(feature.target) * std::max(1.0, (feature.top_z - feature.floor_z) / down) / tool.radius();
}

void refuse_endless(const Part& part) {
  double path = 0, narrowest = widest_radius(part);
  for (const Workingstep& step : part.workplan) {
    path += path_of(part, step);
    narrowest = std::min(narrowest, tool_of(part, step).radius());
  }
  if (path <= kLongestPath) return;
  throw InputError(part.source_file,
                   fmt::format("it takes about {:.0f} km of path with a cutter of {} mm, months of cutting; "
                               "correct --scale or --unit, or use a wider cutter or a larger --stepdown",
                               path / 1e6, trimmed(2 * narrowest, 4)));
}

/// Whether a feature covers the point, or is so near that a cutter over the point touches it.
bool is_in_a_feature(const Part& part, Vec2 point, double near) {
  return std::any_of(part.features.begin(), part.features.end(), [&](const Feature& feature) {
    return std::any_of(feature.target.begin(), feature.target.end(), [&](const Region& region) {
      return region.contains(point) || region.boundary_distance(point) <= near;
    });
  });
}

std::string place(Vec2 point) {
  return trimmed(point.x, 3) + "," + trimmed(point.y, 3);
}

void refuse_places_outside(const Part& part, const PlanOptions& options) {
  if (options.start && !is_in_a_feature(part, *options.start, widest_radius(part)))
    throw InputError("--start",
                     place(*options.start) + " lies in no feature; `clearcut info` says where they are");
  for (const PredrilledHole& hole : part.predrilled) {
    if (is_in_a_feature(part, hole.center, 0)) continue;
    throw InputError("predrilled", "the hole at " + place(hole.center) +
                                       " lies in no feature; `clearcut info` says where they are");
  }
}

/// Whether another feature as deep opens the walls of this one.
bool is_opened(const Part& part, const Feature& feature, const Tolerances& tol) {
  return std::any_of(part.features.begin(), part.features.end(), [&](const Feature& other) {
    if (&other == &feature || other.floor_z > feature.floor_z) return false;
    if (!box(other.target).grown(kLevel).overlaps(box(feature.target))) return false;
    return !intersect(dilate(other.target, kLevel, tol), feature.target, tol).empty();
  });
}

/// What is left on the floor of a feature by the step that leaves least; features made by the shape of their tool leave nothing.
double least_left_on_floor(const Part& part, int feature) {
  double least = HUGE_VAL;
  for (const Workingstep& step : part.workplan)
    if (step.feature == feature) least = std::min(least, step.operation.allowance_floor);
  return least;
}

/// Features no deeper than the stock to leave on their floors.
void refuse_allowance_as_deep(const Part& part, const Tolerances& tol) {
  for (const Workingstep& step : part.workplan) {
    const Feature& feature = feature_of(part, step);
    const double depth = feature.top_z - feature.floor_z, left = least_left_on_floor(part, step.feature);
    if (left <= 0 || depth <= tol.uncut || depth - left > tol.uncut || feature.hole || feature.through ||
        makes_holes(tool_of(part, step)))
      continue;
    throw InputError(
        name_and_place(feature),
        fmt::format("it is {} mm deep and {} mm are to be left on its floor (--allowance-floor), so that "
                    "nothing would be cut; leave less, or leave the feature out",
                    trimmed(depth, 3), trimmed(left, 3)));
  }
}

/// Refuses a cutter that may not plunge where no other entry fits. Cutters that do not fit at all are reported by the plan.
void refuse_plunges(const Part& part, const PlanOptions& options) {
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const Workingstep& step = part.workplan[i];
    const Feature& feature = feature_of(part, step);
    const Tool& tool = tool_of(part, step);
    if (step.stated_path || step.operation.rest || features::has_room_to_enter(feature, tool, options.tol) ||
        is_opened(part, feature, options.tol))
      continue;
    const double widest = features::largest_fitting_diameter(feature, options.tol);
    if (tool.diameter > widest + options.tol.fit) continue;
    const auto holes = features::holes_before(part, static_cast<int>(i), options.tol);
    const bool is_begun = std::any_of(holes.begin(), holes.end(), [&](const PredrilledHole& hole) {
      return hole.diameter >= tool.diameter && contains(feature.target, hole.center);
    });
    if (is_begun) continue;
    throw InputError(
        name_and_place(feature),
        fmt::format(
            "T{} ({} {} mm) may not plunge and has no room for a ramp or a circle there, where the widest "
            "cutter that fits has {} mm; give a narrower mill, one that may plunge, or a drill of that "
            "size",
            tool.number, name_of(tool.kind), trimmed(tool.diameter, 4), trimmed(widest, 3)));
  }
}

/// Reasons other than the length of the tool.
void refuse_place_or_kind(const Part& part, const Workingstep& step) {
  refuse_beside_stock(part, feature_of(part, step));
  refuse_wrong_kind(part, step);
  refuse_under_clamps(part, step);
}

void refuse_step(const Part& part, const Workingstep& step, const Tolerances& tol) {
  refuse_place_or_kind(part, step);
  refuse_below_stock(part, feature_of(part, step));
  refuse_unmade(part, step, tol);
}

/// A workingstep on one of its features.
std::string work_key(const Part& part, const Workingstep& step) {
  return step.source + " " + feature_of(part, step).name;
}

}  // namespace

bool is_of_program(const Workingstep& step) {
  return !step.source.empty() && step.source.front() == '#';
}

void drop_unused_features(Part& part) {
  std::vector<int> renumbered(part.features.size(), -1);
  for (const Workingstep& step : part.workplan) renumbered[static_cast<std::size_t>(step.feature)] = 0;
  std::vector<Feature> used;
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    if (renumbered[i] < 0) continue;
    renumbered[i] = static_cast<int>(used.size());
    used.push_back(std::move(part.features[i]));
  }
  part.features = std::move(used);
  for (Workingstep& step : part.workplan) step.feature = renumbered[static_cast<std::size_t>(step.feature)];
}

void refuse_above_stock(const Part& part) {
  for (const Workingstep& step : part.workplan) refuse_above_stock(part, step);
}

namespace {

/// Why steps are impossible, by work_key().
using Impossible = std::map<std::string, std::string>;

/// The part without these steps, each said not to be machined; nothing if that are none. Throws NothingToMachine if that are all.
std::optional<Part> without(const Part& asked, const Impossible& impossible, const Tolerances& tol) {
  if (impossible.empty()) return std::nullopt;
  Part rest = asked;
  rest.workplan.clear();
  for (const Workingstep& step : asked.workplan) {
    const auto why = impossible.find(work_key(asked, step));
    if (why == impossible.end()) {
      rest.workplan.push_back(step);
      continue;
    }
    say_not_machined(rest.diagnostics, asked.source_file, feature_of(asked, step).name,
                     "workingstep " + step.source + " '" + step.name + "' is left out: " + why->second);
  }
  if (rest.workplan.empty())
    throw NothingToMachine("", impossible.at(work_key(asked, asked.workplan.front())), rest.diagnostics);
  if (rest.workplan.size() == asked.workplan.size()) return std::nullopt;
  drop_unused_features(rest);
  const std::vector<double> tops = features::stacked_tops(rest, tol);
  for (std::size_t i = 0; i < tops.size(); ++i) rest.features[i].top_z = tops[i];
  return rest;
}

/// The steps of the part's own program for which `refuse` throws.
template <typename Refuse>
Impossible refused_steps(const Part& part, const Refuse& refuse) {
  Impossible impossible;
  for (const Workingstep& step : part.workplan) {
    if (!is_of_program(step)) continue;
    try {
      refuse(step);
    } catch (const InputError& error) {
      impossible.emplace(work_key(part, step), error.what());
    }
  }
  return impossible;
}

}  // namespace

std::optional<Part> without_steps_above_stock(const Part& asked, const Tolerances& tol) {
  return without(
      asked, refused_steps(asked, [&](const Workingstep& step) { refuse_above_stock(asked, step); }), tol);
}

std::optional<Part> without_impossible_steps(const Part& asked, const Part& prepared, const Tolerances& tol) {
  return without(asked,
                 refused_steps(prepared, [&](const Workingstep& step) { refuse_step(prepared, step, tol); }),
                 tol);
}

void tell_of_shallow(Part& part, const Tolerances& tol) {
  std::string first;
  int count = 0;
  for (const Workingstep& step : part.workplan) {
    const Feature& feature = feature_of(part, step);
    const double depth = feature.top_z - feature.floor_z;
    if (depth <= 0 || depth > tol.uncut || feature.chamfer || feature.hole) continue;
    if (count++ == 0) first = name_and_place(feature) + ": it is " + trimmed(depth, 4) + " mm deep";
  }
  if (count == 0) return;
  part.diagnostics.warn(part.source_file,
                        first + (count > 1 ? fmt::format(" (and {} more as shallow)", count - 1) : "") +
                            fmt::format(", no more than the {} mm that may stay uncut: the check cannot tell "
                                        "whether it is cut at all; is the unit right?",
                                        trimmed(tol.uncut, 4)));
}

namespace {

/// The axis of a hole; nothing for other features.
std::optional<Vec2> axis_of(const Feature& feature, const Tolerances& tol) {
  if (feature.hole) return feature.hole->center;
  if (feature.kind != FeatureKind::kRoundHole) return std::nullopt;
  const auto round = features::round_hole_of(feature, tol);
  return round ? std::optional(round->center) : std::nullopt;
}

/// Whether both are steps of one hole, such as its spot, its drill and its tap.
bool are_of_one_hole(const Feature& a, const Feature& b, const Tolerances& tol) {
  const std::optional<Vec2> one = axis_of(a, tol), other = axis_of(b, tol);
  return one && other && distance(*one, *other) < kLevel;
}

/// Whether planning other features rests on material that is gone with this one: they begin at its floor, or lie beside it
/// without a wall between.
bool is_rested_on(const Part& part, const Feature& feature, const Tolerances& tol) {
  const Regions around = dilate(feature.target, kBeside, tol);
  return std::any_of(part.workplan.begin(), part.workplan.end(), [&](const Workingstep& step) {
    const Feature& other = feature_of(part, step);
    if (&other == &feature || other.floor_z >= feature.top_z - kLevel || are_of_one_hole(other, feature, tol))
      return false;
    return box(other.target).overlaps(box(around)) && !intersect(other.target, around, tol).empty();
  });
}

/// Whether the feature may be left out alone, or with the other steps of its hole: a pocket or a hole.
bool may_be_left_out(const Part& part, const Workingstep& step, const Tolerances& tol) {
  const Feature& feature = feature_of(part, step);
  const bool is_external = feature.hole && feature.hole->external;
  return !is_of_program(step) && !feature.profile && !is_external && !feature.chamfer &&
         !is_carved(feature, tool_of(part, step)) && !is_rested_on(part, feature, tol);
}

struct Reach {
  std::vector<std::string> beyond;  ///< for each workingstep why its tool does not make it; "" where it does
  std::set<int> made;               ///< features that some step reaches
};

Reach reach_of(const Part& part, const Tolerances& tol) {
  Reach reach;
  for (const Workingstep& step : part.workplan) {
    reach.beyond.push_back(why_not_made(part, step, tol).value_or(""));
    if (reach.beyond.back().empty()) reach.made.insert(step.feature);
  }
  return reach;
}

/// Of a hole of which one step is not made no step is.
void leave_out_whole_holes(const Part& part, const Tolerances& tol, Reach& reach) {
  const std::vector<std::string> own = reach.beyond;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Feature& unmade = feature_of(part, part.workplan[i]);
    if (own[i].empty() || reach.made.contains(part.workplan[i].feature) || !axis_of(unmade, tol)) continue;
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (!own[k].empty() || !are_of_one_hole(feature_of(part, part.workplan[k]), unmade, tol)) continue;
      reach.beyond[k] = "it is left out with " + unmade.name;
      reach.made.erase(part.workplan[k].feature);
    }
  }
}

}  // namespace

std::vector<std::string> unreached_steps(const Part& part, const Tolerances& tol) {
  Reach reach = reach_of(part, tol);
  leave_out_whole_holes(part, tol, reach);
  for (std::size_t i = 0; i < reach.beyond.size(); ++i) {
    const Workingstep& step = part.workplan[i];
    if (!reach.beyond[i].empty() &&
        (reach.made.empty() || reach.made.contains(step.feature) || !may_be_left_out(part, step, tol)))
      reach.beyond[i].clear();
  }
  return std::move(reach.beyond);
}

bool reaches_floor(const Part& part, const Feature& feature, const Tool& tool) {
  if (tool.flute_length) return part.top_z() - feature.floor_z <= *tool.flute_length + kLevel;
  const bool drills = makes_holes(tool) || tool.kind == ToolKind::kTap;
  const double reach = (drills ? kReachOfDrill : kReachOfMill) * tool.diameter;
  return feature.top_z - feature.floor_z <= reach + kLevel;
}

void drop_unreached_rests(Part& part, const std::set<std::string>& rests, const Tolerances& tol) {
  const Reach reach = reach_of(part, tol);
  std::vector<Workingstep> kept;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const Workingstep& step = part.workplan[i];
    if (reach.beyond[i].empty() || !rests.contains(step.name) || !reach.made.contains(step.feature)) {
      kept.push_back(step);
      continue;
    }
    part.diagnostics.doubt(feature_of(part, step).name, "out-of-reach",
                           "T" + std::to_string(tool_of(part, step).number) +
                               " does not mill what the wider tools leave: " + reach.beyond[i]);
  }
  part.workplan = std::move(kept);
}

void refuse_what_cannot_be(const Part& part, const PlanOptions& options) {
  refuse_low_rapids(part);
  const std::vector<std::string> unreached = unreached_steps(part, options.tol);
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    refuse_place_or_kind(part, part.workplan[i]);
    if (!unreached[i].empty()) continue;
    refuse_below_stock(part, feature_of(part, part.workplan[i]));
    refuse_unmade(part, part.workplan[i], options.tol);
  }
  refuse_plunges(part, options);
  refuse_allowance_as_deep(part, options.tol);
  refuse_endless(part);
  refuse_places_outside(part, options);
}

}  // namespace clearcut::resolve
