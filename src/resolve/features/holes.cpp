#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "features/round_hole.h"
#include "features/standing.h"
#include "features/tool_choice.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "options/read_options.h"
#include "resolve/features/hole_tools.h"
#include "resolve/features/shaping.h"
#include "resolve/values/cutting_values.h"

namespace clearcut::resolve {
namespace {

/// mm. Heights and centres nearer than this are one.
constexpr double kSame = 0.01;
/// Share of a hole's width: a spot wholly removed by the hole.
constexpr double kSpotShare = 0.9;
/// Length of a tap's lead before the full thread, in pitches (form C: 2 to 3).
constexpr double kTapLead = 2.5;
/// Pitches of room under a tap.
constexpr double kUnderTap = 0.5;
/// Depth below the thread, in pitches, at which a thread mill begins: one, plus a quarter for its lead-in.
constexpr double kUnderThread = 1.25;

class HoleShaper {
 public:
  HoleShaper(Part& part, const PlanOptions& options, StepSources& sources)
      : part_(part), options_(options), sources_(sources) {
    spot_ = tool_where(part.tools, [](const Tool& tool) { return tool.kind == ToolKind::kSpotDrill; });
  }

  void run() {
    const std::vector<Workingstep> asked = std::move(part_.workplan);
    part_.workplan.clear();
    for (Workingstep step : asked) {
      shape(step);
      part_.workplan.push_back(std::move(step));
    }
    if (part_.order_free) put_holes_first();
  }

 private:
  /// Tools without an edge in their middle come after their required hole: counterbores, and cones with a flat tip.
  void put_holes_first() {
    for (std::size_t i = 0; i < part_.workplan.size(); ++i) {
      if (!needs_hole(part_.workplan[i])) continue;
      const std::size_t hole = hole_after(i);
      if (hole == part_.workplan.size()) continue;
      const double top = feature_of(part_.workplan[i]).top_z;
      std::vector<Workingstep> first, then;
      for (std::size_t k = i; k <= hole; ++k) {
        const bool goes_first = k == hole || (is_on_axis_of(k, i) && is_spot(feature_of(part_.workplan[k])));
        if (goes_first) begin_at(feature_of(part_.workplan[k]), top);
        (goes_first ? first : then).push_back(part_.workplan[k]);
      }
      first.insert(first.end(), then.begin(), then.end());
      std::copy(first.begin(), first.end(), part_.workplan.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  bool needs_hole(const Workingstep& step) const {
    const Tool& tool = part_.tools[static_cast<std::size_t>(step.operation.tool)];
    return tool.kind == ToolKind::kCounterbore ||
           (tool.kind == ToolKind::kChamferMill && tool.tip_diameter > 0 &&
            part_.features[static_cast<std::size_t>(step.feature)].kind == FeatureKind::kRoundHole);
  }

  std::optional<Vec2> axis_of(std::size_t step) const {
    const Feature& feature = part_.features[static_cast<std::size_t>(part_.workplan[step].feature)];
    if (feature.hole) return feature.hole->center;
    const auto round = features::round_hole_of(feature, options_.tol);
    return round ? std::optional(round->center) : std::nullopt;
  }

  bool is_on_axis_of(std::size_t a, std::size_t b) const {
    const std::optional<Vec2> one = axis_of(a), other = axis_of(b);
    return one && other && distance(*one, *other) < kSame;
  }

  static bool is_spot(const Feature& feature) {
    return feature.hole && feature.hole->kind == HoleKind::kSpotted;
  }

  /// The first later step for a narrower and deeper hole on the same axis; the number of steps if there is none.
  std::size_t hole_after(std::size_t step) const {
    const Feature& seat = part_.features[static_cast<std::size_t>(part_.workplan[step].feature)];
    for (std::size_t k = step + 1; k < part_.workplan.size(); ++k) {
      const Workingstep& later = part_.workplan[k];
      const Feature& feature = part_.features[static_cast<std::size_t>(later.feature)];
      const Tool& tool = part_.tools[static_cast<std::size_t>(later.operation.tool)];
      const bool opens = tool.kind == ToolKind::kDrill || clears_floors(tool);
      if (opens && feature.kind == FeatureKind::kRoundHole && feature.floor_z < seat.floor_z &&
          is_on_axis_of(k, step))
        return k;
    }
    return part_.workplan.size();
  }

  /// A hole made before the material above it is removed begins at the top of that material; a spot, too, with
  /// unchanged depth.
  static void begin_at(Feature& feature, double top) {
    const double higher = top - feature.top_z;
    if (higher <= 0) return;
    feature.top_z = top;
    if (!is_spot(feature)) return;
    feature.floor_z += higher;
    feature.hole->full_z += higher;
  }

  Feature& feature_of(const Workingstep& step) {
    return part_.features[static_cast<std::size_t>(step.feature)];
  }

  void shape(Workingstep& step) {
    if (!feature_of(step).hole) return shape_plain(step);
    const HoleKind kind = feature_of(step).hole->kind;
    if (kind == HoleKind::kTapped) {
      shape_tapped(step);
    } else if (kind == HoleKind::kThreadMilled) {
      feature_of(step).hole->external ? shape_external_thread(step) : shape_thread(step);
    } else if (features::is_cone(feature_of(step))) {
      shape_cone(step);
    } else {
      shape_cylinder(step);
    }
  }

  /// A hole without further data, if made by a drill.
  void shape_plain(Workingstep& step) {
    Feature& feature = feature_of(step);
    const auto round = features::round_hole_of(feature, options_.tol);
    if (!part_.order_free || feature.kind != FeatureKind::kRoundHole || !round) return;
    const Tool& tool = part_.tools[static_cast<std::size_t>(step.operation.tool)];
    if (tool.kind != ToolKind::kDrill || feature.through || !features::makes_hole(tool, *round, options_.tol))
      return;
    const bool reaches = part_.stock && feature.floor_z < part_.stock->z_bottom + kSame &&
                         !lies_below(part_, feature, feature.floor_z);
    if (!reaches && !tool.tip_angle && spot_ < 0) return;
    if (!reaches && !tool.tip_angle) return add_spot(step, feature.floor_z);
    if (!reaches && comes_out_below(part_, feature, feature.floor_z - point_length(tool)))
      return mill_instead(step);
    feature.hole = HoleForm{HoleKind::kDrilled, round->center, 2 * round->radius, feature.floor_z,
                            std::nullopt,       false,         std::nullopt};
    feature.through = reaches;
    shape_cylinder(step);
  }

  /// Mills a hole whose drill would come out below the material, where a mill fits; else the hole stays with its drill, and is left.
  void mill_instead(Workingstep& step) {
    const Feature& feature = feature_of(step);
    std::vector<char> drills;
    for (const Tool& tool : part_.tools) drills.push_back(makes_holes(tool) ? 1 : 0);
    if (std::all_of(drills.begin(), drills.end(), [](char drill) { return drill; })) return;
    const int other = features::tool_for(feature, part_.tools, drills, options_.tol);
    const Tool& mill = part_.tools[static_cast<std::size_t>(other)];
    const double fits = features::largest_fitting_diameter(feature, options_.tol) + options_.tol.fit;
    if (clears_floors(mill) && mill.diameter <= fits &&
        features::has_room_to_enter(feature, mill, options_.tol))
      take_tool(step, other);
  }

  /// Sets the depth to that of the finished width, plus `beyond` for the tool's end.
  void set_depth(Feature& feature, double beyond) {
    HoleForm& hole = *feature.hole;
    if (feature.through && part_.stock) hole.full_z = part_.stock->z_bottom - kBreakthrough;
    feature.floor_z = hole.full_z - beyond;
  }

  void shape_cylinder(Workingstep& step) {
    HoleForm& hole = *feature_of(step).hole;
    const int own = tool_of_kind(part_.tools, hole);
    if (own >= 0) change_tool(step.operation, own, part_, options_);
    const Tool& tool = part_.tools[static_cast<std::size_t>(step.operation.tool)];
    if (hole.kind == HoleKind::kReamed && own < 0)
      refuse(feature_of(step), "a reamer of its width", "reamer", hole.diameter);
    // A blind hole ends at the drill's tip if the length of its point is not stated.
    const bool to_tip = hole.kind == HoleKind::kDrilled && !feature_of(step).through && !tool.tip_angle;
    if (to_tip) hole.full_z = feature_of(step).floor_z + point_length(tool);
    set_depth(feature_of(step), point_length(tool));
    if (hole.peck) step.operation.stepdown = *hole.peck;
    if (tool.kind == ToolKind::kReamer || tool.kind == ToolKind::kBoringBar) {
      add_pilot(step, pilot_before(hole, tool), hole.full_z);
    } else if (tool.kind == ToolKind::kDrill) {
      add_spot(step, hole.full_z);
    }
  }

  void shape_tapped(Workingstep& step) {
    const Thread thread = *feature_of(step).hole->thread;
    const int tap = tap_for(part_.tools, thread);
    if (tap < 0)
      throw InputError(
          feature_of(step).name,
          fmt::format("it is to be tapped {0}; give the tap, for example --tool tap:{0}", thread.name));
    take_tool(step, tap);
    step.operation.cutting.spindle_clockwise = !thread.left_hand;
    set_depth(feature_of(step), kTapLead * thread.pitch);
    const Feature& feature = feature_of(step);
    const double room = feature.through ? 0 : kUnderTap * thread.pitch;
    add_pilot(step, pilot_before(thread), feature.floor_z - room);
  }

  void shape_thread(Workingstep& step) {
    const Thread thread = *feature_of(step).hole->thread;
    const int mill = thread_mill_for(part_.tools, thread);
    if (mill < 0)
      throw InputError(
          feature_of(step).name,
          fmt::format("its thread {} is to be milled; give a thread mill under {} mm, for example "
                      "--tool threadmill:{}",
                      thread.name, trimmed(minor_diameter(thread), 2),
                      trimmed(std::max(0.5, std::floor(minor_diameter(thread) * 0.7)), 1)));
    take_tool(step, mill);
    Feature& feature = feature_of(step);
    set_depth(feature, kUnderThread * thread.pitch);
    if (feature.through && part_.stock) feature.hole->full_z = part_.stock->z_bottom;
    add_pilot(step, pilot_before(thread), feature.floor_z);
  }

  /// The mill's room beside the boss must be cleared before, down to a pitch and a quarter below the thread.
  void shape_external_thread(Workingstep& step) {
    const Thread thread = *feature_of(step).hole->thread;
    const int mill = thread_mill_for(part_.tools, thread, true);
    if (mill < 0)
      throw InputError(feature_of(step).name,
                       fmt::format("its thread {} is to be milled; give a thread mill, for "
                                   "example --tool threadmill:10",
                                   thread.name));
    take_tool(step, mill);
    Feature& feature = feature_of(step);
    refuse_faced_boss(feature);
    set_depth(feature, kUnderThread * thread.pitch);
    const double beside = part_.tools[static_cast<std::size_t>(mill)].diameter + approach_beside(thread);
    if (!is_cleared_about(feature, root_diameter(thread) / 2 + beside))
      throw InputError(
          feature.name,
          fmt::format("its mill needs {} mm all round the root of the thread, cleared down to z {}; add a "
                      "pocket about the boss, deepen it, or take a narrower thread mill",
                      trimmed(beside, 2), trimmed(feature.floor_z, 3)));
  }

  /// Refuses an external thread whose boss would be faced off: facing removes all material above the face.
  static void refuse_faced_boss(const Feature& thread) {
    if (thread.top_z > thread.hole->full_z + kSame) return;
    throw InputError(thread.name,
                     "its whole boss is faced off; make that a pocket up to the edge of the stock");
  }

  /// Whether pockets, or no stock, are around a thread's boss down to the depth of the thread's mill.
  bool is_cleared_about(const Feature& thread, double radius) const {
    constexpr double kSliver = 1e-3;  // mm2
    const Vec2 center = thread.hole->center;
    Regions missing{
        Region::from_valid_loops(disc_about(center, radius).outer(), {thread.target.front().outer()})};
    for (const Feature& other : part_.features) {
      if (missing.empty() || other.hole || other.profile || other.chamfer ||
          other.floor_z > thread.floor_z + kSame)
        continue;
      missing = subtract(missing, other.allowed, options_.tol);
    }
    if (part_.stock && !missing.empty())
      missing = intersect(missing, {rectangular_region(part_.stock->plan)}, options_.tol);
    return area(missing) < kSliver;
  }

  /// The cone ends at the rim of the hole inside it, or at its tip.
  void shape_cone(Workingstep& step) {
    Feature& feature = feature_of(step);
    HoleForm& hole = *feature.hole;
    const int cutter = cone_for(part_.tools, hole, feature.wall_slope);
    if (cutter < 0)
      throw InputError(feature.name,
                       fmt::format("it needs a cone at least {0} mm wide; give one, for example --tool "
                                   "spotdrill:90deg:{0}",
                                   trimmed(hole.diameter, 3)));
    take_tool(step, cutter);
    const Tool& tool = part_.tools[static_cast<std::size_t>(cutter)];
    const double slope = flank_slope(tool);
    hole.full_z = feature.top_z;
    const double inner = std::max(tool.tip_diameter / 2, widest_hole_in(feature));
    if (inner >= hole.diameter / 2 - kSame)
      throw InputError(feature.name,
                       fmt::format("its hole is {} mm wide: a cone of {} mm leaves nothing of it",
                                   trimmed(2 * inner, 3), trimmed(hole.diameter, 3)));
    feature.floor_z = feature.top_z - (hole.diameter / 2 - inner) / slope;
    // Within a hole the cone leaves no wall of its own.
    feature.wall_slope = lies_in_a_hole(feature) ? Radians{} : Radians::of(base::atan(slope));
  }

  /// mm; radius of the widest hole on the same centre deeper than a cone around it; 0 without one.
  double widest_hole_in(const Feature& cone) {
    double widest = 0;
    for (const Feature& other : part_.features) {
      const auto round = features::round_hole_of(other, options_.tol);
      if (&other == &cone || !round || features::is_cone(other)) continue;
      if (distance(round->center, cone.hole->center) < kSame && 2 * round->radius < cone.hole->diameter)
        widest = std::max(widest, round->radius);
    }
    return widest;
  }

  bool lies_in_a_hole(const Feature& cone) const {
    return std::any_of(part_.features.begin(), part_.features.end(), [&](const Feature& other) {
      const auto round = features::round_hole_of(other, options_.tol);
      return round && &other != &cone && !features::is_cone(other) &&
             distance(round->center, cone.hole->center) < kSame &&
             round->radius > cone.hole->diameter / 2 - kSame;
    });
  }

  void take_tool(Workingstep& step, int tool) { change_tool(step.operation, tool, part_, options_); }

  [[noreturn]] static void refuse(const Feature& feature, const char* what, const char* kind,
                                  double diameter) {
    throw InputError(feature.name, fmt::format("it needs {}; give one, for example --tool {}:{}", what, kind,
                                               trimmed(diameter, 3)));
  }

  bool has_pilot(const Feature& feature, const Pilot& pilot, double down_to) const {
    return std::any_of(part_.features.begin(), part_.features.end(), [&](const Feature& other) {
      const auto round = features::round_hole_of(other, options_.tol);
      return round && !is_formed(other) && distance(round->center, feature.hole->center) < kSame &&
             2 * round->radius > pilot.least - kSame && 2 * round->radius < pilot.most + kSame &&
             (other.floor_z <= down_to + kSame || other.through);
    });
  }

  /// The hole before `step`, whole down to `full_z`.
  void add_pilot(const Workingstep& step, const Pilot& pilot, double full_z) {
    if (has_pilot(feature_of(step), pilot, full_z)) return;
    int drill = drill_for(part_.tools, pilot);
    const bool comes_out =
        drill >= 0 && comes_out_below(part_, feature_of(step),
                                      full_z - point_length(part_.tools[static_cast<std::size_t>(drill)]));
    const int mill = drill < 0 || comes_out ? mill_for(part_.tools, pilot) : -1;
    if (mill >= 0) drill = -1;
    if (drill < 0 && mill < 0)
      throw InputError(
          feature_of(step).name,
          fmt::format("before it comes a hole of {} to {} mm; give a drill for it, for example --tool "
                      "drill:{}, or an end mill that bores it",
                      trimmed(pilot.least, 3), trimmed(pilot.most, 3), trimmed(pilot.best, 2)));
    const int tool = std::max(drill, mill);
    const Tool& cutter = part_.tools[static_cast<std::size_t>(tool)];
    const double width = drill >= 0 ? cutter.diameter : pilot.best;
    Feature hole = cylinder(step, drill >= 0 ? "_drill" : "_bore", width, full_z - point_length(cutter));
    hole.hole = HoleForm{
        HoleKind::kDrilled,         feature_of(step).hole->center, width, full_z, std::nullopt, false,
        feature_of(step).hole->peck};
    hole.hole->chip_break = feature_of(step).hole->chip_break;
    const std::optional<double> peck = hole.hole->peck;
    Workingstep before = step_on(std::move(hole), step, tool);
    if (drill >= 0 && peck) before.operation.stepdown = peck;
    if (drill >= 0) add_spot(before, full_z);
    part_.workplan.push_back(std::move(before));
  }

  /// mm; how far beside `p` the features over it are open just below height z.
  double room_below(double z, Vec2 p) const {
    double room = 0;
    for (const Feature& feature : part_.features) {
      if (feature.top_z < z - kSame || feature.floor_z > z - 2 * kSame) continue;
      for (const Region& region : feature.allowed)
        if (region.contains(p)) room = std::max(room, region.boundary_distance(p));
    }
    return room;
  }

  /// mm below `top`, the floor of counterbores and pockets, that a cone goes down at `p` without touching their walls.
  double deepest_between_walls(const Tool& tool, Vec2 p, double top) const {
    double depth = std::numeric_limits<double>::infinity();
    for (const Feature& feature : part_.features) {
      const double over = feature.top_z - top;
      if (over <= kSame) continue;
      const double room = room_below(feature.top_z, p);
      if (room > 0 && room < tool.radius())
        depth = std::min(depth, (room - tool.tip_diameter / 2) / flank_slope(tool) - over);
    }
    return depth;
  }

  void add_spot(const Workingstep& step, double full_z) {
    if (spot_ < 0) return;
    const Tool& tool = part_.tools[static_cast<std::size_t>(spot_)];
    double width = std::min(kSpotShare * *feature_of(step).hole_diameter, tool.diameter);
    const double top = feature_of(step).top_z;
    const Vec2 center = features::round_hole_of(feature_of(step), options_.tol)->center;
    const double depth = std::min((width / 2 - tool.tip_diameter / 2) / flank_slope(tool),
                                  deepest_between_walls(tool, center, top));
    if (depth <= 0 || top - depth < full_z) return;
    const bool spotted = std::any_of(part_.features.begin(), part_.features.end(), [&](const Feature& other) {
      return other.hole && other.hole->kind == HoleKind::kSpotted &&
             distance(other.hole->center, center) < kSame;
    });
    if (spotted) return;
    width = tool.tip_diameter + 2 * depth * flank_slope(tool);
    Feature spot = cylinder(step, "_spot", width, top - depth);
    spot.hole = HoleForm{HoleKind::kSpotted, center, width, top, std::nullopt, false, std::nullopt};
    part_.workplan.push_back(step_on(std::move(spot), step, spot_));
  }

  Feature cylinder(const Workingstep& step, const char* suffix, double width, double floor) {
    const Feature& of = feature_of(step);
    Feature feature;
    feature.name = of.name + suffix;
    feature.source = of.source;
    feature.kind = FeatureKind::kRoundHole;
    feature.top_z = of.top_z;
    feature.floor_z = floor;
    feature.through = of.through;
    feature.hole_diameter = width;
    const auto round = features::round_hole_of(of, options_.tol);
    feature.target = feature.allowed = {disc_about(of.hole ? of.hole->center : round->center, width / 2)};
    return feature;
  }

  Workingstep step_on(Feature feature, const Workingstep& like, int tool) {
    Workingstep step;
    step.name = feature.name;
    step.source = like.source;
    step.feature = static_cast<int>(part_.features.size());
    step.operation.name = feature.name;
    step.operation.kind = OperationKind::kDrilling;
    step.operation.tool = like.operation.tool;
    step.operation.is_tool_chosen = true;
    change_tool(step.operation, tool, part_, options_);
    sources_[step_key(step)].set("tool", {Origin::kDerived, "what comes before " + like.name});
    part_.features.push_back(std::move(feature));
    return step;
  }

  Part& part_;
  const PlanOptions& options_;
  StepSources& sources_;
  int spot_ = -1;
};

}  // namespace

void shape_holes(Part& part, const PlanOptions& options, StepSources& sources) {
  HoleShaper(part, options, sources).run();
}

}  // namespace clearcut::resolve
