// The chosen plans of all workingsteps as one toolpath.
#pragma once

#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "pipeline/selection/selection.h"

namespace clearcut::pipeline {

/// In their order, or in a short one where that is free, at the feeds that what stands around each move allows. `over_rests`: rapids
/// stay above all that the passes leave.
Toolpath toolpath_of(const Selection& selection, const ResolvedPlan& plan, bool over_rests);

}  // namespace clearcut::pipeline
