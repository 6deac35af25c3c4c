// Cutting force, power, energy and wear from engagement and material.
#pragma once

#include <span>

#include "model/work_material.h"
#include "stock/material.h"
#include "verify/part/finished_part.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// Engagement of the cutter on a short piece of a level move.
struct CutSample {
  stock::CutterEngagement contact;
  double axial = 0;   ///< mm of depth in material
  double length = 0;  ///< mm of path; 0: a point only compared with the worst one
  Place at;
};

/// Adds a piece to the forces of a move. Nothing if spindle speed, teeth or feed are unknown. Source:
/// docs/forces.md.
void add_forces(CheckedMove& checked, const CutSample& sample, const WorkMaterial& material);

/// The wall of the finished part that bends most if half of `force` N, the share pressing on the wall, acts on its
/// top; nothing if no wall bends by more than 0.02 mm. Considers walls up to 20 mm thick. O(walls^2); nothing for
/// more than 3000 walls.
std::optional<ThinWall> thinnest_wall(const FinishedPart& part, double force, const WorkMaterial& material);

/// N; greatest force of the move, 0 if it does not cut.
inline float force_of(const CheckedMove& checked) {
  return checked.load.forces ? static_cast<float>(checked.load.forces->max_force_n) : 0;
}

}  // namespace clearcut::verify
