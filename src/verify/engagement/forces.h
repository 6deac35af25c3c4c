// Cutting force, power, energy and wear from engagement and material.
#pragma once

#include <span>

#include "model/work_material.h"
#include "stock/material.h"
#include "verify/checked_move.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// What the cutter meets over a short stretch of a level move.
struct Bite {
  stock::CutterEngagement contact;
  double axial = 0;   ///< mm of depth in material
  double length = 0;  ///< mm of path; 0: a place that only may be the worst
  Place at;
};

/// Adds a stretch to the forces of a move. Nothing without spindle speed, teeth and feed. Source: docs/forces.md.
void add_forces(JudgedMove& judged, const Bite& bite, const WorkMaterial& material);

/// The wall of the finished part that bends most when half of `force` N, the part that presses on the wall, acts on its
/// top; none where none bends by over 0.02 mm. Walls up to 20 mm thick are looked at. O(walls^2), none beyond 3000 walls.
std::optional<ThinWall> thinnest_wall(const FinishedPart& part, double force, const WorkMaterial& material);

}  // namespace clearcut::verify
