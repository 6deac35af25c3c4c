// Computes the step from one contour to the next by each rule, and the stepover of strategies cutting along lines or
// spirals; for the papers named here see docs/texts.md.
#pragma once

#include <optional>
#include <vector>

#include "model/options/shop_options.h"
#include "plan/common/rings.h"
#include "plan/contour/contour.h"
#include "plan/contour/ring_band.h"

namespace clearcut::plan::contour {

/// mm from `ring` to the next contours inside it; at most the diameter. Angles are those of `ring` itself,
/// measured anew on every contour, because vanishing edges change them. The published rules end with the
/// reduced loop in the centre (CPO-kappa alg. 3): if the next contour would vanish and leave a centre farther
/// away than R, the step is 3/2 R kappa instead.
double step_after(const RingNode& ring, const std::vector<AxisPiece>& inside, const StepRule& rule,
                  double radius);

/// mm from `ring` to the next contours whose reflex corners stay corners, at most: by the corrected rules the widest
/// step that leaves nothing in a reflex corner. Halfway between two contours the bisector of a corner of angle alpha is
/// farthest from both, so that step <= R + reach sin(alpha / 2), as for the axis of a convex corner (ring_band.h).
/// Infinite by all other rules.
double step_past_reflex_corners(const RingNode& ring, const StepRule& rule, double radius);

/// A contour, and the step required by its smallest angle.
struct ContourStep {
  double from_wall = 0;       ///< mm
  double smallest_angle = 0;  ///< radians, between successive edges; pi if all corners are smooth or reflex
  double step = 0;            ///< mm to the contours inside; 0: there are none
};

/// All contours of a rule in a closed area, from the wall inwards, first at `first_level`; of several at one distance
/// the one with the sharpest corner.
std::vector<ContourStep> contour_steps(const Regions& allowed, const StepRule& rule, double radius,
                                       double first_level, const Tolerances& tol);

/// The worst residual of the contours of a rule before passes are added to clear it; its cause is kNone if there is
/// no residual. `allowed`: area permitted to the cutter; the first contour is `radius` mm inside this area.
Rest worst_rest(const Regions& allowed, const StepRule& rule, double radius, const Tolerances& tol);

}  // namespace clearcut::plan::contour

namespace clearcut::plan {

/// mm between neighbouring lines for a cutter of `diameter` mm; nothing if the rule leaves it to the
/// strategy. Throws InputError for rules about angles between contours, which do not apply to lines.
std::optional<double> line_distance(const Stepover& stepover, double diameter);

}  // namespace clearcut::plan
