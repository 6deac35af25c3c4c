#include "features/tool_choice.h"

#include <algorithm>

#include "base/tolerances.h"
#include "features/fitting.h"
#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::features {
namespace {

/// mm2. Area that a mill may leave in corners before a smaller mill is taken.
constexpr double kCorners = 1;

/// Area (mm2) left by a cutter in the corners of a profile.
double left_in_corners(const ProfileCut& cut, double radius, const Tolerances& tol) {
  const Regions inner{Region::from_valid_loops(cut.line, {})};
  if (cut.side == ProfileSide::kOutside) {
    Regions closed;
    for (const Region& region : dilate(inner, radius, tol)) {
      for (Region& one : inset(region, radius, tol)) closed.push_back(std::move(one));
    }
    return area(closed) - area(inner);
  }
  const Regions legal = inset(inner.front(), radius, tol);
  return area(inner) - (legal.empty() ? 0 : area(dilate(legal, radius, tol)));
}

/// The mills with upright sides, from large to small.
std::vector<int> mills_by_size(const std::vector<Tool>& tools) {
  std::vector<int> mills;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    if (mills_upright(tools[i]) && tools[i].kind != ToolKind::kFaceMill) mills.push_back(static_cast<int>(i));
  }
  std::stable_sort(mills.begin(), mills.end(), [&](int a, int b) {
    return tools[static_cast<std::size_t>(a)].diameter > tools[static_cast<std::size_t>(b)].diameter;
  });
  return mills;
}

/// Largest mill reaching all but kCorners of the profile's corners, else the smallest.
int profile_tool(const ProfileCut& cut, const std::vector<Tool>& tools, const Tolerances& tol) {
  const std::vector<int> mills = mills_by_size(tools);
  if (mills.empty()) return 0;
  if (cut.side == ProfileSide::kOn) return mills.back();
  for (const int mill : mills) {
    if (left_in_corners(cut, tools[static_cast<std::size_t>(mill)].radius(), tol) <= kCorners) return mill;
  }
  return mills.back();
}

/// For V-carving the first V-bit, for engraving the first V-bit or ball; -1 if there is none.
int carving_tool(const Feature& feature, const std::vector<Tool>& tools) {
  for (const ToolKind kind : {ToolKind::kVBit, ToolKind::kChamferMill, ToolKind::kBallEndMill}) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
      if (tools[i].kind == kind && is_carved(feature, tools[i])) return static_cast<int>(i);
    }
  }
  return -1;
}

}  // namespace

bool keeps_walls(const Tool& tool, const Feature& feature) {
  if (tool.kind != ToolKind::kTapered) return true;
  return tool.tip_angle.value_or(Radians{}).radians() / 2 <= feature.wall_slope.radians() + kSameAngleRad;
}

int tool_for_tabs(const Feature& feature, int chosen, const std::vector<Tool>& tools) {
  if (!is_carved(feature, tools[static_cast<std::size_t>(chosen)])) return chosen;
  const std::vector<int> mills = mills_by_size(tools);
  return mills.empty() ? chosen : mills.back();
}

namespace {

/// mm, radians. Differences within which an end's radius equals a fillet's, and a cone's angle that of a solid's
/// broken edge.
constexpr double kSameEndRadius = 0.002, kSameConeLean = 0.002;

/// mm; radius of the fillet left by the tool's end between a floor and a wall.
double end_radius_of(const Tool& tool) {
  if (tool.kind == ToolKind::kBallEndMill) return tool.radius();
  return mills_upright(tool) ? tool.corner_radius : 0;
}

/// The largest mill with the end radius of the fillet between the feature's floor and walls; -1 if there is none.
int fillet_tool(const Feature& feature, const std::vector<Tool>& tools, double fits) {
  int best = -1;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    if (std::abs(end_radius_of(tools[i]) - feature.floor_fillet) > kSameEndRadius || tools[i].diameter > fits)
      continue;
    if (best < 0 || tools[i].diameter > tools[static_cast<std::size_t>(best)].diameter)
      best = static_cast<int>(i);
  }
  return best;
}

/// Whether the cone has the angle requested for the edge; true for any cone if no angle is requested.
bool leans_as_asked(const Tool& cone, const Feature& edge) {
  if (edge.wall_slope.radians() == 0) return true;
  return std::abs(cone.tip_angle->radians() / 2 - edge.wall_slope.radians()) < kSameConeLean;
}

/// The first chamfer mill or V-bit with the edge's angle and sufficient length, else the first of all.
int cone_of_edge(const Feature& edge, const std::vector<Tool>& tools) {
  for (const ToolKind kind : {ToolKind::kChamferMill, ToolKind::kVBit}) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
      const bool fits = tools[i].kind == kind && is_conical(tools[i]) && leans_as_asked(tools[i], edge);
      if (fits && edge.wall_slope.radians() > 0 &&
          edge.chamfer->depth <= flank_height(tools[i]) + kSameEndRadius)
        return static_cast<int>(i);
    }
  }
  return std::max(0, chamfer_tool(tools));
}

}  // namespace

int chamfer_tool(const std::vector<Tool>& tools) {
  for (const ToolKind kind : {ToolKind::kChamferMill, ToolKind::kVBit}) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
      if (tools[i].kind == kind && is_conical(tools[i])) return static_cast<int>(i);
    }
  }
  return -1;
}

int t_slot_tool(const std::vector<Tool>& tools) {
  const auto found = std::find_if(tools.begin(), tools.end(),
                                  [](const Tool& tool) { return tool.kind == ToolKind::kTSlot; });
  return found == tools.end() ? -1 : static_cast<int>(found - tools.begin());
}

int tool_for(const Feature& feature, const std::vector<Tool>& tools, const std::vector<char>& passed_over,
             const Tolerances& tol) {
  if (tools.size() == 1) return 0;
  if (feature.chamfer) return cone_of_edge(feature, tools);
  if (const int carver = carving_tool(feature, tools); carver >= 0) return carver;
  if (feature.kind == FeatureKind::kTSlot) return std::max(0, t_slot_tool(tools));
  if (feature.profile) return profile_tool(*feature.profile, tools, tol);
  const double fits = largest_fitting_diameter(feature, tol) + tol.fit;
  // A drill leaves its cone on the floor: pockets are flat down to theirs, and only holes may end so.
  const auto hole = feature.kind == FeatureKind::kRoundHole ? round_hole_of(feature, tol) : std::nullopt;
  if (feature.floor_fillet > 0) {
    if (const int round = fillet_tool(feature, tools, fits); round >= 0) return round;
  }
  int best = 0;
  const auto drills = [&](const Tool& tool) {
    return hole && tool.kind == ToolKind::kDrill && makes_hole(tool, *hole, tol);
  };
  const auto leaves_corner = [](const Tool& tool) { return end_radius_of(tool) < kSameEndRadius; };
  const auto better = [&](const Tool& a, const Tool& b) {
    if (drills(a) != drills(b)) return drills(a);
    if (clears_floors(a) != clears_floors(b)) return clears_floors(a);
    if (keeps_walls(a, feature) != keeps_walls(b, feature)) return keeps_walls(a, feature);
    const bool a_fits = a.diameter <= fits && has_room_to_enter(feature, a, tol),
               b_fits = b.diameter <= fits && has_room_to_enter(feature, b, tol);
    if (a_fits != b_fits) return a_fits;
    // A rounded end leaves its own shape between floor and walls, although the part has a corner there.
    if (a_fits && leaves_corner(a) != leaves_corner(b)) return leaves_corner(a);
    return a_fits ? a.diameter > b.diameter : a.diameter < b.diameter;
  };
  const auto is_open = [&](std::size_t i) { return passed_over.empty() || !passed_over[i]; };
  while (!is_open(static_cast<std::size_t>(best))) ++best;
  for (std::size_t i = 1; i < tools.size(); ++i) {
    if (is_open(i) && better(tools[i], tools[static_cast<std::size_t>(best)])) best = static_cast<int>(i);
  }
  return best;
}

}  // namespace clearcut::features
