// The worked example of the genetic operators in the Tour text.
#pragma once

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// Tour 3.6.2: two offspring of the partially mapped crossover, the genetic edges of table 3.1, by the operators that run.
Reproduction operators_table();

}  // namespace clearcut::studies
