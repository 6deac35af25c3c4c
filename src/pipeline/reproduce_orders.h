// The tables and figures of the Tour text that need nothing but an order of points.
#pragma once

#include "report/text_table.h"

namespace clearcut {

/// Tables 6.3 and 6.6: lattices, turns, turn angle, fitness.
TextTable lattice_table();
/// Table 6.5: feed length, turns and turn angle of the whole fishhead, by several readings of the printed job.
TextTable fishhead_table();
/// Table 6.4: one objective at a time, and several at once.
TextTable objectives_table();
/// Figure 6-15: how engagement is spread for targets from 20 to 100 %, by the raster and by the exact model.
TextTable engagement_table();

}  // namespace clearcut
