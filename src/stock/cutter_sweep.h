// The volume a tool removes for certain, in the form used by the remaining stock.
#pragma once

#include "model/cutter_profile.h"
#include "model/move.h"
#include "model/tool.h"
#include "stock/material.h"

namespace clearcut::stock {

/// The volume removed by a cutter, and the circle for its engagement, mm; 0: no engagement, as for cones and T-slot
/// cutters.
struct Removal {
  CutterProfile profile;
  double circle = 0;
};
Removal removal_by(const Tool& tool);

/// Makes the tool known to the material; returns the number of its cutter.
int add_tool(Material& material, const Tool& tool);

/// Removes the volume swept by the tool along `move`.
void remove_cut(Material& material, const Move& move, const Tool& tool);

}  // namespace clearcut::stock
