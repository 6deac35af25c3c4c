// Thin slivers of material between two nearly touching features: too thin to count as material.
#pragma once

#include <vector>

#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// mm. Thickness up to which material counts as a thin sliver: the depth of a gouge that is no fault.
inline constexpr double kThinSliver = 0.001;

struct Slivers {
  std::vector<Wall> walls;    ///< walls without the thin slivers, divided at the ends of slivers
  std::vector<Wall> slivers;  ///< the pieces of walls with a thin sliver behind them, from z_low up
};

/// Separates walls from thin slivers. A line drawn twice, as the edge of two pockets, often differs by some
/// hundredths or tenths of a um, with alternating sides.
///
/// Cost    O(n log n) if no two walls are so near; else with the walls near each.
/// Error   Walls of one and the same feature have no slivers between them, nor have walls with draft.
Slivers parted(const std::vector<Wall>& walls);

/// The edges of walls, under their numbers.
EdgeTree tree_of(const std::vector<Wall>& walls);

}  // namespace clearcut::verify
