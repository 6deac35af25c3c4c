// Relief in inside corners, so that parts with square corners fit: dogbones and T-bones.
#pragma once

#include "model/part.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Clears the corners left by a round cutter: at an inside corner of two walls of a pocket or a profile, the outline
/// is widened by the area swept by the cutter on a straight move from its contact with both walls until its rim
/// reaches the corner.
///
/// Shape   "corner": along the bisector. "t-bone": along the longer wall, so that the bone is beyond the shorter one.
/// Radius  that of the narrowest mill used on the feature, plus 0.02 mm, so that the move is no exact fit.
/// Left    corners of inclined walls, corners with less than 0.02 mm left, and corners without room for the move, or
///         whose bone would run into another wall of the feature or into another feature: each is reported. Bones are
///         noted with their places.
///
/// Does nothing if options.shop.dogbones is absent. Each profile's tool must have been chosen, and all steps of
/// pockets must exist.
void relieve_profiles(Part& part, const PlanOptions& options);
void relieve_pockets(Part& part, const PlanOptions& options);

}  // namespace clearcut::resolve
