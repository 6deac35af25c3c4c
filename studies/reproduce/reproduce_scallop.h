// The table of the Tour text about drafted walls.
#pragma once

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// Table 6.1: the scallop height asked for on the walls of the sloped fishhead's third pocket and that of the program, as its
/// certificate measures it; planned by the text's strategy.
Reproduction scallop_table();

}  // namespace clearcut::studies
