#include "plan/contour/step_rule.h"

#include <algorithm>

#include "base/error.h"
#include "plan/contour/ring_band.h"

namespace clearcut::plan::contour {
namespace {

using Kind = StepRule::Kind;

/// mm. Ways longer than the radius by less than this leave nothing that counts.
constexpr double kNoRest = 0.001;

/// The published rule (CPO-rho eq. 8) has w = 1 mm, which makes no sense for cutters under 2 mm: w is at most R / 2.
double overlap_of(const StepRule& rule, double radius) {
  return std::min(rule.value, radius / 2);
}

/// kappa or rho of the contour, with the angle that the rule takes.
double coefficient(const Region& contour, const StepRule& rule, double radius) {
  switch (rule.kind) {
    case Kind::kKappa:
      return kappa(smallest_angle(contour));
    case Kind::kRho:
      return rho(smallest_angle(contour), radius, overlap_of(rule, radius));
    default:
      return rho(second_smallest_angle(contour), radius, overlap_of(rule, radius));
  }
}

double greatest_clearance(const std::vector<AxisPiece>& inside) {
  double most = 0;
  for (const auto& piece : inside) most = std::max(most, piece.high.clearance);
  return most;
}

double published_step(const RingNode& ring, const std::vector<AxisPiece>& inside, const StepRule& rule,
                      double radius) {
  const double share = coefficient(ring.contour, rule, radius), step = 2 * radius * share;
  const double to_centre = greatest_clearance(inside) - ring.level;  // A of CPO-kappa alg. 3
  return to_centre > radius && to_centre <= step ? 1.5 * radius * share : step;
}

}  // namespace

double step_after(const RingNode& ring, const std::vector<AxisPiece>& inside, const StepRule& rule,
                  double radius) {
  switch (rule.kind) {
    case Kind::kWidest:
      return 2 * radius;
    case Kind::kKappa:
    case Kind::kRho:
    case Kind::kSecondAngle:
      return published_step(ring, inside, rule, radius);
    case Kind::kKappaCorrected:
      return RingBand(inside, ring.level, radius).widest_step(radius);
    case Kind::kRhoCorrected:
      return RingBand(inside, ring.level, radius).widest_step(radius - overlap_of(rule, radius));
    case Kind::kFraction:
      return 2 * radius * rule.value;
    case Kind::kMm:
      return std::min(rule.value, 2 * radius);
    case Kind::kPerContour:
      break;
  }
  CLEARCUT_ASSERT(!rule.contours.empty());
  const auto index = std::min(static_cast<std::size_t>(ring.depth), rule.contours.size() - 1);
  return step_after(ring, inside, rule.contours[index], radius);
}

Rest worst_rest(const Regions& allowed, const StepRule& rule, double radius, const Tolerances& tol) {
  Rest worst;
  for (const auto& region : allowed) {
    const auto step_of = [&](const RingNode& ring, const std::vector<AxisPiece>& inside) {
      const double step = std::max(step_after(ring, inside, rule, radius), radius);
      const Rest rest = RingBand(inside, ring.level, radius).worst(step, radius + kNoRest);
      if (rest.way > worst.way) worst = rest;
      return step;
    };
    ring_tree(Clearance(region, tol), region, radius, step_of, tol);
  }
  return worst;
}

}  // namespace clearcut::plan::contour
