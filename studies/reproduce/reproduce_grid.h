// The table of the grid paper.
#pragma once

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// Grid table 1: squares after interpolation and after reduction, and the time to an optimal order of each.
Reproduction grid_table();

}  // namespace clearcut::studies
