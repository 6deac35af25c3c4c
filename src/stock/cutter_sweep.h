// What a tool takes away for certain, as the remaining stock knows it.
#pragma once

#include "model/cutter_profile.h"
#include "model/move.h"
#include "model/tool.h"
#include "stock/material.h"

namespace clearcut::stock {

/// What a cutter removes, and the circle with which it asks for engagement, mm; 0: never, as cones and T-slot cutters.
struct Removal {
  CutterProfile profile;
  double circle = 0;
};
Removal removal_by(const Tool& tool);

/// Makes the tool known to the material; returns the number of its cutter.
int add_tool(Material& material, const Tool& tool);

/// Removes what the tool sweeps along `move`.
void remove_cut(Material& material, const Move& move, const Tool& tool);

}  // namespace clearcut::stock
