// Computes the step from one contour to the next by each rule.
#pragma once

#include <vector>

#include "plan/common/rings.h"
#include "plan/contour/contour.h"
#include "plan/contour/ring_band.h"

namespace clearcut::plan::contour {

/// mm from `ring` to the next contours inside it; at most the diameter. Angles are those of `ring` itself,
/// measured anew on every contour, because edges that vanish change them. The published rules end with the
/// reduced loop in the centre (CPO-kappa alg. 3): if the next contour would vanish and leave a centre farther
/// away than R, the step is 3/2 R kappa instead.
double step_after(const RingNode& ring, const std::vector<AxisPiece>& inside, const StepRule& rule,
                  double radius);

/// The worst place that contours of a rule leave before anything is added to clear it; its cause is kNone if
/// they leave nothing. `allowed`: where the cutter may be; the first contour is `radius` mm inside it.
Rest worst_rest(const Regions& allowed, const StepRule& rule, double radius, const Tolerances& tol);

}  // namespace clearcut::plan::contour
