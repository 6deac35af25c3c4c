// The step from one contour to the next by each rule.
#pragma once

#include <vector>

#include "plan/common/rings.h"
#include "plan/contour/contour.h"
#include "plan/contour/ring_band.h"

namespace clearcut::plan::contour {

/// mm from `ring` to the next contours inside it, at most the diameter. Angles are those of `ring` itself, computed
/// anew for every contour (edges that have vanished make others). The published rules end with the reduced loop in the
/// centre (CPO-kappa alg. 3): where the next contour would vanish and leave a centre farther than R, its step is
/// 3/2 R kappa instead.
double step_after(const RingNode& ring, const std::vector<AxisPiece>& inside, const StepRule& rule,
                  double radius);

/// A contour, and the step that its smallest angle asks for.
struct ContourStep {
  double from_wall = 0;       ///< mm
  double smallest_angle = 0;  ///< radians, between successive edges; pi where all is smooth or reflex
  double step = 0;            ///< mm to the contours inside it; 0: there are none
};

/// All contours of a rule in a closed area, from the wall inwards, first at `first_level`; of several at one distance the one
/// with the sharpest corner.
std::vector<ContourStep> contour_steps(const Regions& allowed, const StepRule& rule, double radius,
                                       double first_level, const Tolerances& tol);

/// What contours of a rule leave in the worst place of all, before anything is added to clear it: cause kNone where that is
/// nothing. `allowed` is what the cutter may not leave; first contour at the radius.
Rest worst_rest(const Regions& allowed, const StepRule& rule, double radius, const Tolerances& tol);

}  // namespace clearcut::plan::contour
