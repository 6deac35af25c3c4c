// Contours whose reflex corners stay corners, as the papers print them.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "plan/common/rings.h"

namespace clearcut::plan::contour {

/// The contours of a polygon from the distance `first_level`, mm, inwards: each with its sides moved in and prolonged
/// to their intersections (CPO-kappa eq. 2, in which interior angles above pi lengthen the sides; all moves are
/// straight). Parents come before their children; the nodes have no gaps. `step_of` gets one piece of axis rising to
/// the greatest clearance inside the contour.
///
/// Shape   nested as given by the moved sides: regions split, sides vanish, and islands grow.
/// Error   1 nm a contour.
/// Cost    one offset and one Voronoi diagram for each contour.
std::vector<RingNode> mitred_ring_tree(const Region& domain, double first_level, const StepOf& step_of,
                                       const Tolerances& tol);

}  // namespace clearcut::plan::contour
