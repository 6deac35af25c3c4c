// The tables and figures of the Tour text that need nothing but an order of points.
#pragma once

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// Tables 6.3 and 6.6: lattices, turns, turn angle, fitness.
Reproduction lattice_table();
/// Table 6.5: feed length, turns and turn angle of the whole fishhead, by several readings of the printed job.
Reproduction fishhead_table();
/// Section 5.3.2: how many points the largest feature has, which pins the grid of table 6.5.
Reproduction grid_points_table();

}  // namespace clearcut::studies
