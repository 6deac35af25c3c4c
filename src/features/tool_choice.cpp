#include "features/tool_choice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>

#include "base/tolerances.h"
#include "features/derived_outlines.h"
#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::features {
namespace {

/// Clearance of a feature's walls, kept for the next feature with the same walls.
struct Walls {
  Walls(const Region& allowed, const Tolerances& tol) : region(allowed), clearance(allowed, tol) {}
  Region region;
  Clearance clearance;
};

/// Greatest distance of a place in `target` from the walls, by their medial axis; if the axis runs beside the target
/// (far open sides), by the middle of the target.
double widest_over(const Regions& target, const Walls& walls, const Tolerances& tol) {
  double widest = 0;
  for (const AxisPoint& p : walls.clearance.axis().points) {
    if (p.clearance > widest && contains(target, p.point)) widest = p.clearance;
  }
  for (const Region& region : target) {
    const Clearance own(region, tol);
    for (const AxisPoint& p : own.centers()) {
      if (walls.region.contains(p.point)) widest = std::max(widest, walls.region.boundary_distance(p.point));
    }
  }
  return widest;
}

/// Points all over a target, evenly in each of its regions.
std::vector<Vec2> spread_over(const Regions& target) {
  constexpr int kFinest = 128;
  constexpr std::ptrdiff_t kEnough = 100;
  std::vector<Vec2> points;
  for (const Region& region : target) {
    const Box box = region.box();
    const auto before = static_cast<std::ptrdiff_t>(points.size());
    for (int n = 12; n <= kFinest && std::ssize(points) - before < kEnough; n *= 2) {
      points.resize(static_cast<std::size_t>(before));
      for (int k = 0; k < n * n; ++k) {
        const int row = k / n, column = k % n;
        const Vec2 p{box.min.x + (column + 0.5) / n * box.width(),
                     box.min.y + (row + 0.5) / n * box.height()};
        if (region.contains(p)) points.push_back(p);
      }
    }
  }
  return points;
}

/// Of the cutter's radius: how far its centre has to be free to go for a ramp, or a ring that it follows several times, to come down as
/// gently as a cutter without teeth in its middle has to.
constexpr double kRoomToEnter = 0.075;

/// mm; greatest error of the chords that stand for a curved medial axis.
constexpr double kChordOfCurve = 0.01;

/// The widest discs between walls, from one end of a piece of their medial axis to the other: middles and radii
/// change evenly.
struct Discs {
  AxisPoint from, to;
};

std::vector<Discs> discs_at(const Box& place, const Clearance& clearance) {
  std::vector<Discs> discs;
  for (std::size_t i = 0; i < clearance.axis().edges.size(); ++i) {
    const std::vector<AxisPoint> curve = clearance.axis_curve(static_cast<int>(i), kChordOfCurve);
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
      const bool grows = curve[k].clearance < curve[k + 1].clearance;
      const AxisPoint &from = curve[grows ? k : k + 1], &to = curve[grows ? k + 1 : k];
      Box middles;
      middles.add(from.point);
      middles.add(to.point);
      if (place.overlaps(middles.grown(to.clearance))) discs.push_back({from, to});
    }
  }
  return discs;
}

/// mm; radius of the widest of the discs containing the point, 0 if none does. The squared distance of a point
/// outside of a disc is quadratic along the piece; the piece is wider at its end.
double widest_about(Vec2 p, const Discs& discs) {
  const Vec2 way = discs.to.point - discs.from.point, off = discs.from.point - p;
  const double low = discs.from.clearance + kChordOfCurve, grows = discs.to.clearance - discs.from.clearance;
  const double a = dot(way, way) - grows * grows, b = 2 * (dot(off, way) - low * grows),
               c = dot(off, off) - low * low;
  if (a + b + c <= 0) return discs.to.clearance;
  const double under = b * b - 4 * a * c;
  if (under < 0) return 0;
  const double at = std::abs(a) > 0 ? (-b + (a > 0 ? 1 : -1) * std::sqrt(under)) / (2 * a) : -c / b;
  const double other = std::abs(a) > 0 ? -b / a - at : at;
  const auto radius_of = [&](double t) { return t >= 0 && t <= 1 ? discs.from.clearance + t * grows : 0; };
  return std::max(radius_of(at), radius_of(other));
}

/// mm; radius of the largest cutter that reaches nine tenths of the target, from any side.
double radius_that_reaches_most(const Regions& target, const Clearance& clearance) {
  constexpr double kMayStay = 0.1;
  const std::vector<Vec2> points = spread_over(target);
  if (points.empty()) return 0;
  const std::vector<Discs> all = discs_at(box(target), clearance);
  std::vector<double> reached_by;
  for (const Vec2 p : points) {
    double widest = 0;
    for (const Discs& discs : all) {
      if (discs.to.clearance > widest) widest = std::max(widest, widest_about(p, discs));
    }
    reached_by.push_back(widest);
  }
  std::sort(reached_by.begin(), reached_by.end());
  return reached_by[static_cast<std::size_t>(kMayStay * static_cast<double>(points.size()))];
}

bool same_walls(const Region& a, const Region& b) {
  return a.outer() == b.outer() && a.islands() == b.islands();
}

/// Fitting cutters of one feature after the other.
class Fitting {
 public:
  explicit Fitting(const Tolerances& tol) : tol_(tol) {}

  double fitting(const Feature& feature);
  double worth_a_try(const Feature& feature);

 private:
  const Walls& walls_of(const Region& allowed) {
    if (!last_ || !same_walls(last_->region, allowed)) last_.emplace(allowed, tol_);
    return *last_;
  }

  Tolerances tol_;
  std::optional<Walls> last_;
};

double Fitting::fitting(const Feature& feature) {
  if (feature.profile && feature.profile->side != ProfileSide::kInside) return 2 * kOpenReach;
  if (feature.profile) return 2 * Clearance(Region::from_valid_loops(feature.profile->line, {}), tol_).max();
  const double deep = feature.top_z - feature.floor_z;
  const bool leans = feature.wall_slope.radians() != 0 && deep > 0;
  const Regions allowed = leans ? at_depth(feature.allowed, feature.wall_slope, deep, tol_) : feature.allowed;
  const Regions target = leans ? intersect(feature.target, allowed, tol_) : feature.target;
  const bool closed = closed_all_round(feature);
  double radius = 0;
  for (const Region& region : allowed) {
    const Walls& walls = walls_of(region);
    radius = std::max(radius, closed ? walls.clearance.max() : widest_over(target, walls, tol_));
  }
  return 2 * radius;
}

double Fitting::worth_a_try(const Feature& feature) {
  double diameter = fitting(feature);
  if (feature.profile || closed_all_round(feature) || feature.wall_slope.radians() != 0) return diameter;
  for (const Region& region : feature.allowed)
    diameter = std::max(diameter, 2 * radius_that_reaches_most(feature.target, walls_of(region).clearance));
  return diameter;
}

}  // namespace

double largest_fitting_diameter(const Feature& feature, const Tolerances& tol) {
  return Fitting(tol).fitting(feature);
}

bool has_room_to_enter(const Feature& feature, const Tool& tool, const Tolerances& tol) {
  if (tool.center_cutting || !clears_floors(tool) || feature.profile || !closed_all_round(feature))
    return true;
  // An exact fit has room along itself.
  const Regions centers = inset(feature.allowed, tool.radius() - tol.fit - tol.chord, tol);
  return std::any_of(centers.begin(), centers.end(), [&](const Region& region) {
    const Box box = region.box();
    return std::max(box.width(), box.height()) >= kRoomToEnter * tool.radius();
  });
}

std::vector<double> largest_cutters(const Part& part, const Tolerances& tol) {
  Fitting fitting(tol);
  std::vector<double> diameters;
  for (const Feature& feature : part.features) diameters.push_back(fitting.worth_a_try(feature));
  return diameters;
}

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

/// mm, radians. Differences within which an end's radius equals a fillet's, and a cone's angle that of a solid's
/// broken edge.
constexpr double kSameEndRadius = 0.002, kSameConeLean = 0.002;

/// mm; radius of the fillet left by the tool's end between a floor and a wall.
double end_radius_of(const Tool& tool) {
  if (tool.kind == ToolKind::kBallEndMill) return tool.radius();
  return mills_upright(tool) ? tool.corner_radius : 0;
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

/// Whether a tool leaves a sharp corner between a floor and a wall, and cuts walls upright down to its tip.
bool leaves_corner(const Tool& tool) {
  return end_radius_of(tool) < kSameEndRadius;
}

/// The mills with upright sides and flat ends, from large to small: others leave the shape of their ends at the foot of a wall. Without
/// such mills, all.
std::vector<int> mills_of_walls(const std::vector<Tool>& tools) {
  const std::vector<int> all = mills_by_size(tools);
  std::vector<int> flat;
  std::copy_if(all.begin(), all.end(), std::back_inserter(flat),
               [&](int mill) { return leaves_corner(tools[static_cast<std::size_t>(mill)]); });
  return flat.empty() ? all : flat;
}

/// Largest mill reaching all but kCorners of the profile's corners, else the smallest.
int profile_tool(const ProfileCut& cut, const std::vector<Tool>& tools, const Tolerances& tol) {
  const std::vector<int> mills = mills_of_walls(tools);
  if (mills.empty()) return 0;
  if (cut.side == ProfileSide::kOn) return mills.back();
  for (const int mill : mills) {
    if (left_in_corners(cut, tools[static_cast<std::size_t>(mill)].radius(), tol) <= kCorners) return mill;
  }
  return mills.back();
}

/// For V-carving the first V-bit, for engraving the first V-bit or ball; else a chamfer mill, whose flat tip does not go down into
/// the material of a line if there is a mill for it; -1 if there is none.
int carving_tool(const Feature& feature, const std::vector<Tool>& tools) {
  const bool is_milled = feature.kind == FeatureKind::kEngraving && !mills_by_size(tools).empty();
  for (const ToolKind kind : {ToolKind::kVBit, ToolKind::kBallEndMill, ToolKind::kChamferMill}) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
      if (kind == ToolKind::kChamferMill && is_milled && tools[i].tip_diameter > 0) continue;
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

bool keeps_fillet(const Tool& tool, const Feature& feature) {
  return end_radius_of(tool) >= feature.floor_fillet - kSameEndRadius;
}

bool makes_fillet(const Tool& tool, const Feature& feature) {
  return std::abs(end_radius_of(tool) - feature.floor_fillet) <= kSameEndRadius;
}

int tool_for_tabs(const Feature& feature, int chosen, const std::vector<Tool>& tools) {
  if (!is_carved(feature, tools[static_cast<std::size_t>(chosen)])) return chosen;
  const std::vector<int> mills = mills_of_walls(tools);
  return mills.empty() ? chosen : mills.back();
}

namespace {

/// The largest mill with the end radius of the fillet between the feature's floor and walls; -1 if there is none.
int fillet_tool(const Feature& feature, const std::vector<Tool>& tools, double fits) {
  int best = -1;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    if (!makes_fillet(tools[i], feature) || tools[i].diameter > fits) continue;
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
  const bool may_be_milled =
      hole && std::any_of(tools.begin(), tools.end(), [&](const Tool& tool) {
        return clears_floors(tool) && tool.diameter <= fits && has_room_to_enter(feature, tool, tol);
      });
  // In a hole shallower than its point a drill never comes to its width.
  const auto drills = [&](const Tool& tool) {
    return hole && tool.kind == ToolKind::kDrill && makes_hole(tool, *hole, tol) &&
           (!may_be_milled || !is_shallower_than_point(feature, tool, tol));
  };
  const auto better = [&](const Tool& a, const Tool& b) {
    if (drills(a) != drills(b)) return drills(a);
    if (clears_floors(a) != clears_floors(b)) return clears_floors(a);
    if (keeps_walls(a, feature) != keeps_walls(b, feature)) return keeps_walls(a, feature);
    if (keeps_fillet(a, feature) != keeps_fillet(b, feature)) return keeps_fillet(a, feature);
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
