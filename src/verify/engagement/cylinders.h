// What of a cutter takes material away for certain.
#pragma once

#include <vector>

#include "model/tool.h"

namespace clearcut::verify {

/// A cylinder within a cutter, from `above` its tip up, mm.
struct Cylinder {
  double above = 0;
  double radius = 0;
};

/// What a cutter removes for certain with all that stands above it: within the flanks of a tapered end mill cylinders that miss
/// them by 0.05 mm at most; nothing for a T-slot cutter, over which material stays.
std::vector<Cylinder> cylinders_within(const Tool& tool);

/// mm above the tip up to which a cutter takes material away: over the disc of a T-slot cutter runs its neck alone.
double height_of_edges(const Tool& tool);

}  // namespace clearcut::verify
