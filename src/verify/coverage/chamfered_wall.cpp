#include "verify/coverage/chamfered_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "verify/part/edge_tree.h"
#include "verify/program/shaped_cutter.h"

namespace clearcut::verify {
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
