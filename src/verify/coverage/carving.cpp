#include "verify/coverage/carving.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "model/cutter_profile.h"
#include "verify/part/edge_tree.h"
#include "verify/program/shaped_cutter.h"

namespace clearcut::verify {
namespace {

/// mm along the outline between circles, and between places on an engraved line.
constexpr double kRaySpacing = 0.002;
constexpr double kLineSpacing = 0.02;
/// mm. An outline reaching no deeper than this into a circle only touches the circle.
constexpr double kTouch = 1e-7;
constexpr int kMostShrinks = 200;
/// mm. Squares of the floor are not divided below this half diagonal.
constexpr double kSmallestCell = 0.004;
/// mm. Least half diagonal of the squares searched for a place of a flat tip.
constexpr double kSmallestPlace = 0.0005;

/// The cone with the smallest tip of the cones carving a feature; null if none does.
const Tool* carver_of(const Part& part, int feature) {
  const Tool* carver = nullptr;
  for (const Workingstep& step : part.workplan) {
    const bool known = step.operation.tool >= 0 && step.operation.tool < static_cast<int>(part.tools.size());
    if (step.feature != feature || !known ||
        !is_carved(part.features[static_cast<std::size_t>(feature)], tool_of(part, step)))
      continue;
    if (!carver || tool_of(part, step).tip_diameter < carver->tip_diameter) carver = &tool_of(part, step);
  }
  return carver;
}

class CarvingCheck {
 public:
  CarvingCheck(const Part& part, const CheckedProgram& program, const Tolerances& tol, CarvingWork& work)
      : feature_(part.features[static_cast<std::size_t>(work.feature)]),
        carver_(*carver_of(part, work.feature)),
        tol_(tol),
        work_(work),
        outline_(feature_.target) {
    const Box here = box(feature_.target);
    for (const CheckedMove& checked : program.moves) {
      if (!checked.feeds() || !checked.tool || checked.radius() <= 0 || checked.low_z() >= feature_.top_z)
        continue;
      const Move& move = *checked.move;
      const Box path = move.is_vertical() ? Box{move.path.from, move.path.from} : move.path.box();
      if (!path.grown(checked.radius()).overlaps(here)) continue;
      work_.any_cut = true;
      const bool cone = is_conical(*checked.tool) || checked.tool->kind == ToolKind::kBallEndMill;
      if (cone) shaped_.add(move, *checked.tool);
      if (!cone && checked.tool->kind != ToolKind::kTSlot &&
          std::max(move.z_from, move.z_to) <= feature_.floor_z + tol_.uncut)
        floor_mills_.push_back(move.path),
            floor_radii_.push_back(std::max(0.0, inner_profile(*checked.tool).flat));
    }
    mill_tree_ = EdgeTree(floor_mills_);
    for (const double radius : floor_radii_) widest_mill_ = std::max(widest_mill_, radius);
  }

  void check_engraving() {
    const double bound = kLineSpacing / 2 * (is_conical(carver_) ? 1 / flank_slope(carver_) : 0);
    for (const Edge& edge : feature_.profile->line) {
      const int steps = std::max(1, static_cast<int>(std::ceil(edge.length() / kLineSpacing)));
      for (int i = 0; i <= steps; ++i) {
        const Vec2 p = edge.at(static_cast<double>(i) / steps);
        // Between the tested places a path on the line is as deep as at the places; only for cones beside the line,
        // the material could be `bound` higher.
        keep(p, shaped_.at(p) - feature_.floor_z, feature_.floor_z, std::min(bound, tol_.uncut / 4));
      }
    }
  }

  void check_v_carving() {
    slope_ = flank_slope(carver_);
    tip_ = carver_.tip_diameter / 2;
    widest_ = tip_ + (feature_.top_z - feature_.floor_z) * slope_;
    across_ = slope_ / base::hypot(1.0, slope_);
    for (const Region& region : feature_.target) {
      check_loop(region.outer());
      for (const Loop& island : region.islands()) check_loop(island);
    }
    check_floor();
  }

 private:
  void keep(Vec2 p, double left, double z, double bound) {
    const double thickness = left + bound;
    if (thickness <= work_.left_mm) return;
    work_.left_mm = thickness;
    work_.worst = p;
    work_.worst_z = z;
  }

  void check_loop(const Loop& loop) {
    const Edge* before = &loop.back();
    for (const Edge& edge : loop) {
      check_corner(*before, edge);
      const int steps = std::max(1, static_cast<int>(std::ceil(edge.length() / kRaySpacing)));
      for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        check_ray(edge.at(t), left_of(edge.tangent_at(t)));
      }
      before = &edge;
    }
  }

  /// Checks the directions all round a corner pointing into the carving.
  void check_corner(const Edge& before, const Edge& after) {
    const Vec2 in = before.tangent_at(1), out = after.tangent_at(0);
    const double turn = base::atan2(cross(in, out), dot(in, out));
    if (turn >= -kSameAngleRad) return;
    const double from = angle_of(left_of(in));
    const int steps = std::max(1, static_cast<int>(std::ceil(-turn * widest_ / kRaySpacing)));
    for (int i = 0; i <= steps; ++i) check_ray(after.from, direction_of(from + turn * i / steps));
  }

  /// mm; radius of the largest circle tangent to the outline at b, with its centre in direction n, and without
  /// outline inside.
  double circle_from(Vec2 b, Vec2 n) const {
    double radius = widest_;
    for (int i = 0; i < kMostShrinks; ++i) {
      const Vec2 center = b + n * radius;
      const auto hit = outline_.nearest(center, radius - kTouch);
      if (hit.edge < 0) return radius;
      const Vec2 to = nearest_point(outline_.edges()[static_cast<std::size_t>(hit.edge)], center) - b;
      const double ahead = dot(to, n);
      if (ahead <= 1e-12) return 0;
      const double smaller = dot(to, to) / (2 * ahead);
      if (smaller >= radius) return radius;
      radius = smaller;
    }
    return radius;
  }

  void check_ray(Vec2 b, Vec2 n) {
    const double radius = circle_from(b, n);
    if (radius <= tip_) return;  // out of the tip's reach
    const Vec2 middle = b + n * radius;
    const double z = feature_.top_z - (radius - tip_) / slope_;
    keep(middle, (shaped_.at(middle) - z) * across_, z, kRaySpacing * std::sqrt(1 - across_ * across_));
  }

  bool in_a_mills_way(Vec2 p, double reach) const {
    bool found = false;
    mill_tree_.within(p, widest_mill_, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      found = found || distance(floor_mills_[at], p) + reach <= floor_radii_[at] + tol_.uncut;
    });
    return found;
  }

  /// mm; distance of p from the outline; negative outside of the carving.
  double depth_into(Vec2 p) const {
    const double d = outline_.nearest(p).distance;
    return outline_.winding(p) != 0 ? d : -d;
  }

  void check_floor() {
    const Box whole = outline_.box();
    const double half = std::max(whole.width(), whole.height()) / 2;
    check_cell(whole.center(), half);
  }

  bool is_near_a_mill(Vec2 p, double reach) const {
    bool found = false;
    mill_tree_.within(p, widest_mill_ + reach, [&](int) { found = true; });
    return found;
  }

  /// Whether a flat tip can be over p at the floor: narrow ends of the floor are out of its reach.
  bool is_in_tips_reach(Vec2 p) const { return tip_ <= 0 || has_place_for_tip(p, p, tip_); }

  /// Whether a square about `middle` contains a place for the tip's axis at the floor, within the tip's radius of p.
  /// The depth at any place is at most the depth in the middle plus the distance from the middle.
  bool has_place_for_tip(Vec2 p, Vec2 middle, double half) const {
    const double diagonal = half * std::sqrt(2.0), away = distance(p, middle);
    if (away - diagonal > tip_) return false;
    const double inside = depth_into(middle);
    if (away <= tip_ && inside >= widest_) return true;
    if (inside + diagonal < widest_ || diagonal < kSmallestPlace) return false;
    const auto quarters = {Vec2{-0.5, -0.5}, Vec2{0.5, -0.5}, Vec2{-0.5, 0.5}, Vec2{0.5, 0.5}};
    return std::any_of(quarters.begin(), quarters.end(),
                       [&](Vec2 way) { return has_place_for_tip(p, middle + way * half, half / 2); });
  }

  void check_cell(Vec2 p, double half) {
    const double diagonal = half * std::sqrt(2.0), foot = widest_ - tip_;
    const double inside = depth_into(p);
    if (inside + diagonal < foot) return;
    if (in_a_mills_way(p, diagonal)) return;
    const double over = shaped_.at(p) - feature_.floor_z;
    if (over + diagonal / slope_ <= kHighestCusp) return;
    const bool untouched = over - diagonal / slope_ > kHighestCusp && !is_near_a_mill(p, diagonal);
    if (untouched && inside - diagonal >= foot && is_in_tips_reach(p))
      return keep(p, std::min(over, foot / slope_), feature_.floor_z, 0);
    if (diagonal > kSmallestCell) {
      for (const Vec2 way : {Vec2{-0.5, -0.5}, Vec2{0.5, -0.5}, Vec2{-0.5, 0.5}, Vec2{0.5, 0.5}})
        check_cell(p + way * half, half / 2);
      return;
    }
    if (inside < foot + tol_.uncut || in_a_mills_way(p, 0)) return;
    if (over > kHighestCusp && is_in_tips_reach(p))
      keep(p, std::min(over, foot / slope_), feature_.floor_z, 0);
  }

  const Feature& feature_;
  const Tool& carver_;
  const Tolerances& tol_;
  CarvingWork& work_;
  EdgeTree outline_;
  CutHeights shaped_;
  std::vector<Edge> floor_mills_;
  std::vector<double> floor_radii_;
  EdgeTree mill_tree_;
  double widest_mill_ = 0;
  double slope_ = 0, tip_ = 0, widest_ = 0;
  double across_ = 0;  ///< mm square to the flank for each mm of height
};

}  // namespace

std::vector<CarvingWork> carvings_of(const Part& part) {
  std::vector<CarvingWork> works;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const int feature = part.workplan[i].feature;
    if (!carver_of(part, feature)) continue;
    const auto known = std::find_if(works.begin(), works.end(),
                                    [&](const CarvingWork& work) { return work.feature == feature; });
    if (known == works.end()) {
      CarvingWork work;
      work.feature = feature;
      work.last_workingstep = static_cast<int>(i);
      works.push_back(work);
    } else {
      known->last_workingstep = static_cast<int>(i);
    }
  }
  return works;
}

void check_carving(const Part& part, const CheckedProgram& program, const Tolerances& tol,
                   CarvingWork& work) {
  if (part.features[static_cast<std::size_t>(work.feature)].chamfer)
    return check_chamfer(part, program, tol, work);
  CarvingCheck check(part, program, tol, work);
  if (!work.any_cut) return;
  if (part.features[static_cast<std::size_t>(work.feature)].profile) {
    check.check_engraving();
  } else {
    check.check_v_carving();
  }
  if (std::isinf(work.left_mm))
    work.left_mm = part.top_z() - part.features[static_cast<std::size_t>(work.feature)].floor_z;
}

std::vector<Fault> faults_of_carving(const Feature& feature, const CarvingWork& work, const Tolerances& tol) {
  if (!work.any_cut) {
    const Vec2 middle = feature.target.empty() ? Vec2{} : box(feature.target).center();
    return {{FaultKind::kNothingCut,
             feature.name,
             {middle, feature.floor_z, 0},
             feature.top_z - feature.floor_z,
             feature.name + ": nothing of it is cut; the program has no feed move down there."}};
  }
  if (work.left_mm <= tol.uncut) return {};
  return {{FaultKind::kUncut,
           feature.name,
           {work.worst, work.worst_z, 0},
           work.left_mm,
           feature.name + ": up to " + trimmed(work.left_mm, 3) + " mm is left uncut, at x " +
               trimmed(work.worst.x, 3) + " y " + trimmed(work.worst.y, 3) + " z " +
               trimmed(work.worst_z, 3) + "."}};
}

namespace {

/// mm between places along the line.
constexpr double kSpacing = 0.02;
/// mm. A place on the line no farther than this from the side of the stock is on that side.
constexpr double kOnSide = 0.005;
/// Shares of the chamfer's width at which its depth is checked. At the top, 1, no material is to be cut.
constexpr double kAcross[] = {0, 0.5, 0.9};

class ChamferCheck {
 public:
  ChamferCheck(const Part& part, const CheckedProgram& program, const Tolerances& tol, CarvingWork& work)
      : part_(part),
        feature_(part.features[static_cast<std::size_t>(work.feature)]),
        tol_(tol),
        work_(work),
        slope_(base::tan(feature_.wall_slope.radians())),
        line_(std::vector<Edge>(feature_.chamfer->line)) {
    const Box here = line_.box();
    for (const CheckedMove& checked : program.moves) {
      if (!checked.feeds() || !checked.tool || checked.radius() <= 0 || checked.low_z() >= feature_.top_z)
        continue;
      const Move& move = *checked.move;
      const Box path = move.path.box();
      if (!path.grown(checked.radius() + width()).overlaps(here)) continue;
      if (is_conical(*checked.tool)) {
        work_.any_cut = true;
        cones_.add(move, *checked.tool);
      } else if (low_all_along(checked) <= feature_.floor_z + tol_.uncut) {
        mills_.push_back(move.is_vertical() ? Edge::line(move.path.from, move.path.from) : move.path);
        radii_.push_back(checked.radius());
      }
    }
    for (const double radius : radii_) widest_ = std::max(widest_, radius);
    mill_tree_ = EdgeTree(mills_);
  }

  void check() {
    const double out = feature_.chamfer->air_inside == (signed_area(feature_.chamfer->line) > 0) ? -1 : 1;
    for (const Edge& edge : line_.edges()) {
      const int steps = std::max(1, static_cast<int>(std::ceil(edge.length() / kSpacing)));
      for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        check_place(edge.at(t), left_of(edge.tangent_at(t)) * out);
      }
    }
  }

 private:
  double width() const { return feature_.chamfer->depth * slope_; }

  static double low_all_along(const CheckedMove& checked) {
    const Move& move = *checked.move;
    return move.is_vertical() ? checked.low_z() : std::max(move.z_from, move.z_to);
  }

  bool is_wall(Vec2 p) const {
    if (part_.stock) {
      const Box& plan = part_.stock->plan;
      const double inside =
          std::min({p.x - plan.min.x, plan.max.x - p.x, p.y - plan.min.y, plan.max.y - p.y});
      if (inside < kOnSide) return true;
    }
    bool found = false;
    mill_tree_.within(p, widest_ + tol_.uncut, [&](int i) {
      const auto at = static_cast<std::size_t>(i);
      const double d =
          mills_[at].from == mills_[at].to ? distance(mills_[at].from, p) : distance(mills_[at], p);
      found = found || d <= radii_[at] + tol_.uncut;
    });
    return found;
  }

  /// mm. In places not reached by the mills there is no wall, although the line continues there.
  double distance_to_wall(Vec2 p) const {
    const auto is_milled = [&](int i) {
      return is_wall(nearest(line_.edges()[static_cast<std::size_t>(i)], p).point);
    };
    return line_.nearest(p, std::numeric_limits<double>::infinity(), is_milled).distance;
  }

  void check_place(Vec2 foot, Vec2 into_solid) {
    if (!is_wall(foot)) return;
    const double square = slope_ / base::hypot(1.0, slope_);
    for (const double share : kAcross) {
      const Vec2 p = foot + into_solid * (share * width());
      const double z = feature_.floor_z + distance_to_wall(p) / slope_;
      const double left = (std::min(cones_.at(p), feature_.top_z) - z) * square;
      if (left <= work_.left_mm) continue;
      work_.left_mm = left;
      work_.worst = p;
      work_.worst_z = z;
    }
  }

  const Part& part_;
  const Feature& feature_;
  const Tolerances& tol_;
  CarvingWork& work_;
  double slope_;  ///< mm by which the chamfer's plane moves into the solid for each mm upwards
  EdgeTree line_;
  CutHeights cones_;
  std::vector<Edge> mills_;
  std::vector<double> radii_;
  double widest_ = 0;
  EdgeTree mill_tree_;
};

}  // namespace

void check_chamfer(const Part& part, const CheckedProgram& program, const Tolerances& tol,
                   CarvingWork& work) {
  ChamferCheck check(part, program, tol, work);
  if (work.any_cut) check.check();
}

}  // namespace clearcut::verify
