// The tables and figures of the Tour text that need nothing but an order of points.
#pragma once

#include "report/text_table.h"

namespace clearcut::studies {

/// Tables 6.3 and 6.6: lattices, turns, turn angle, fitness.
report::TextTable lattice_table();
/// Table 6.5: feed length, turns and turn angle of the whole fishhead, by several readings of the printed job.
report::TextTable fishhead_table();

}  // namespace clearcut::studies
