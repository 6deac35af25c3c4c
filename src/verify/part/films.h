// What is left standing between two features that all but touch: too thin to count as material.
#pragma once

#include <vector>

#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// mm. Thickness up to which it is a film: as much as a gouge may be deep without being a fault.
inline constexpr double kFilm = 0.001;

struct Films {
  std::vector<Wall> walls;  ///< what stands without the films, cut where a film begins or ends
  std::vector<Wall> films;  ///< the pieces of walls behind which a film would stand, from z_low up
};

/// Parts walls from films. A line that a drawing has twice, as the edge of two pockets, often lies some hundredths or tenths of a
/// um apart, here on one side and there on the other.
///
/// Cost    O(n log n) where no two walls are that near; else with the walls near each.
/// Error   Walls of one and the same feature have no films between them, nor have walls with draft.
Films parted(const std::vector<Wall>& walls);

/// The edges of walls, under their numbers.
EdgeTree tree_of(const std::vector<Wall>& walls);

}  // namespace clearcut::verify
