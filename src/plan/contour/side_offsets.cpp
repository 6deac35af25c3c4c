#include "plan/contour/side_offsets.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "base/units.h"

namespace clearcut::plan::contour {
namespace {

/// rad. Sides nearer to parallel than this do not meet.
constexpr double kParallel = 1e-9;

double cot_half(double angle) {
  return base::cos(angle / 2) / base::sin(angle / 2);
}

Vec2 direction(double angle) {
  return {base::cos(angle), base::sin(angle)};
}

/// Computes one step from a contour to the next.
class Stepper {
 public:
  Stepper(SideList list, double step, ReflexCorners corners)
      : list_(std::move(list)), step_(step), rounded_(corners == ReflexCorners::kRounded) {}

  SideOffset run() {
    SideOffset result;
    for (;;) {
      if (list_.sides.size() < 3) return result;
      const auto shortest = shortest_side();
      if (length_after(shortest) > kRoundingMm) break;
      const SideOffsetEnd end = merge(shortest);
      if (end != SideOffsetEnd::kContour) {
        result.end = end;
        return result;
      }
      ++result.vanished;
    }
    result.contour = offset();
    result.end = SideOffsetEnd::kContour;
    return result;
  }

 private:
  const Side& corner_before(std::size_t j) const {
    return list_.sides[j == 0 ? list_.sides.size() - 1 : j - 1];
  }
  bool is_reflex(const Side& corner) const { return corner.angle > kPi; }

  /// Contours with reflex corners may split; the formulas do not detect this.
  bool is_convex() const {
    return std::none_of(list_.sides.begin(), list_.sides.end(),
                        [&](const Side& side) { return is_reflex(side); });
  }

  /// mm by which a step shortens the straight length at a corner; negative if it lengthens the side.
  double taken_at(const Side& corner) const {
    if (is_reflex(corner) && (rounded_ || corner.radius > 0))
      return 0;  // the arc about the corner grows, the sides keep their length
    return std::max(0.0, step_ - corner.radius) * cot_half(corner.angle);
  }

  /// mm; length of side j after the step: CPO-kappa eq. 2, with the arcs of CPO-rho appendix B.
  double length_after(std::size_t j) const {
    return list_.sides[j].length - taken_at(corner_before(j)) - taken_at(list_.sides[j]);
  }

  std::size_t shortest_side() const {
    std::size_t shortest = 0;
    for (std::size_t j = 1; j < list_.sides.size(); ++j) {
      if (length_after(j) < length_after(shortest)) shortest = j;
    }
    return shortest;
  }

  /// CPO-kappa alg. 2, one side of a run at a time: side j vanishes, its neighbours are prolonged to their
  /// intersection.
  SideOffsetEnd merge(std::size_t j) {
    const std::size_t n = list_.sides.size(), i = (j + n - 1) % n, k = (j + 1) % n;
    Side &before = list_.sides[i], &side = list_.sides[j], &after = list_.sides[k];
    if (n == 3) return SideOffsetEnd::kGone;
    for (const Side* corner : {&before, &side}) {
      if (corner->radius >= step_ || (is_reflex(*corner) && (rounded_ || corner->radius > 0))) {
        return SideOffsetEnd::kBeyond;
      }
    }
    const double angle = before.angle + side.angle - kPi;
    if (angle < kParallel) return is_convex() ? SideOffsetEnd::kGone : SideOffsetEnd::kBeyond;
    if (std::abs(angle - kPi) < kParallel || angle > 2 * kPi - kParallel) return SideOffsetEnd::kBeyond;
    const double sharp =
        side.length + before.radius * cot_half(before.angle) + side.radius * cot_half(side.angle);
    const double meet_before = sharp * base::sin(kPi - side.angle) / base::sin(angle);
    const double meet_after = sharp * base::sin(kPi - before.angle) / base::sin(angle);
    const double cut_before = before.radius * cot_half(before.angle),
                 cut_after = side.radius * cot_half(side.angle);
    before.length += cut_before + meet_before;
    after.length += cut_after + meet_after;
    if (k == 0) list_.start = list_.start - direction(list_.orientation) * (cut_after + meet_after);
    if (j == 0) {
      const Vec2 corner = list_.start + direction(list_.orientation) * (side.length + cut_after);
      list_.orientation += kPi - side.angle;
      list_.start = corner - direction(list_.orientation) * meet_after;
    }
    before.angle = angle;
    before.radius = 0;
    list_.sides.erase(list_.sides.begin() + static_cast<std::ptrdiff_t>(j));
    return SideOffsetEnd::kContour;
  }

  SideList offset() const {
    SideList next = list_;
    const Vec2 along = direction(list_.orientation), inwards{-along.y, along.x};
    next.start = list_.start + along * taken_at(list_.sides.back()) + inwards * step_;
    for (std::size_t j = 0; j < list_.sides.size(); ++j) {
      auto& side = next.sides[j];
      side.length = length_after(j);
      const bool grows = is_reflex(side) && (rounded_ || side.radius > 0);
      side.radius = grows ? side.radius + step_ : std::max(0.0, side.radius - step_);
    }
    return next;
  }

  SideList list_;
  double step_;
  bool rounded_;
};

}  // namespace

SideOffset offset_sides(const SideList& list, double step, ReflexCorners corners) {
  CLEARCUT_ASSERT(step > 0);
  return Stepper(list, step, corners).run();
}

double length_of(const SideList& list) {
  double sum = 0;
  for (const auto& side : list.sides) sum += side.length + arc_length(side);
  return sum;
}

double smallest_angle(const SideList& list) {
  double smallest = kPi;
  for (const auto& side : list.sides) {
    if (side.radius <= 0) smallest = std::min(smallest, side.angle);
  }
  return smallest;
}

}  // namespace clearcut::plan::contour
