// Relief in inside corners, so that parts with square corners fit: dogbones and T-bones.
#pragma once

#include "model/part.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Cuts the corners free that a round cutter leaves: where two walls of a pocket or a profile meet at an inside corner, the outline
/// is widened by what the cutter sweeps on a straight way from where it touches both walls until its rim reaches the corner.
///
/// Shape   "corner": along the bisector. "t-bone": along the longer wall, so that the bone lies beyond the shorter one.
/// Radius  that of the narrowest mill which works on the feature, and 0.02 mm, so that the way is no exact fit.
/// Left    corners of leaning walls, corners that leave less than 0.02 mm, and those where the way has no room, or the bone would run
///         into another wall of the feature or into another feature: each is said. Bones are noted with their places.
///
/// Does nothing where options.shop.dogbones is absent. Each profile's tool has been chosen, and of pockets all steps are there.
void relieve_profiles(Part& part, const PlanOptions& options);
void relieve_pockets(Part& part, const PlanOptions& options);

}  // namespace clearcut::resolve
