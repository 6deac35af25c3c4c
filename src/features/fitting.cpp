#include "features/fitting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "features/at_depth.h"
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

/// mm; how far axes may lie from where they are.
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

}  // namespace clearcut::features
