// The Tour text's table 6.4 and figure 6-15: one objective at a time, several at once, and engagement.
#pragma once

#include "studies/reproduce/reproduction.h"
#include "studies/reproduce/table_runs.h"

namespace clearcut::studies {

/// Table 6.4: every feature of the fishhead and plates with islands, one objective at a time, with its bound and
/// gap, and length, turns and engagement at once.
Reproduction objectives_table(const TableWatch& watch);
/// Figure 6-15: how engagement is spread for targets from 20 to 100 %, by the raster and by the exact model.
Reproduction engagement_table();

/// Tour figures 6-16 and 6-17: engagement along the path where it alone is asked for, and beside length and turns.
Reproduction single_multi_table();

}  // namespace clearcut::studies
