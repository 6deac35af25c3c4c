// The published system on its own part, from the file to the checked program, beside ours.
#pragma once

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// Every workingstep of the fishhead on the published grid, ordered by the published algorithm (three seeds: mean and interval of
/// eq. 4.11) and by ours; the sums beside table 6.5. All figures are those of the program that was written and read back.
Reproduction published_fishhead_table();

}  // namespace clearcut::studies
