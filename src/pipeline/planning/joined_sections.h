// The chosen plans of all workingsteps as one toolpath.
#pragma once

#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "pipeline/selection/selection.h"

namespace clearcut::pipeline {

/// Joins the sections in their order, or in a short one if the order is free, with feeds allowed by the material
/// around each move. `over_rests`: rapids stay above all material left by the passes.
Toolpath toolpath_of(const Selection& selection, const ResolvedPlan& plan, bool over_rests);

}  // namespace clearcut::pipeline
