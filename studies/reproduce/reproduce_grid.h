// The table of the grid paper.
#pragma once

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// Grid table 1: squares after interpolation and after reduction, and the time to an optimal order of each.
Reproduction grid_table();

/// Table 1 of the grid paper: squares before and after reduction, and the time to an order of visits with
/// what is proven of it, beside the printed times of its genetic algorithm.
report::TextTable grid_reduction_table();

}  // namespace clearcut::studies
