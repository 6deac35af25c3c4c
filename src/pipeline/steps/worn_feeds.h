// Feeds that follow the load where the control compensates for wear: they hold for cutters off their size, too.
#pragma once

#include "model/move.h"
#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// Lowers the feeds of moves that would load a cutter more than the rule allows when it is off its size by the range of wear either
/// way and the D words hold as much. Nothing without plan.feed_rule or without compensation for wear.
///
/// The paths at both ends of the range are those of the control: the toolpath is posted and read back with the D words of the end.
/// Cost of a post, and at each end of a reading and of queries of Material.
void keep_load_when_worn(Toolpath& toolpath, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
