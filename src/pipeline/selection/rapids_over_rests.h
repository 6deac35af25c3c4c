// Rapids over what published methods and skipped workingsteps leave.
#pragma once

#include "model/options/resolved_plan.h"
#include "pipeline/selection/selection.h"

namespace clearcut::pipeline {

/// Whether what later workingsteps take to be cut may stand: where a strategy does not promise to leave nothing (published
/// methods, the published grid, strategies of the user's own), where one found no passes, and where a tool's end is not flat: under
/// rounded corners, points and cones more stands than in a cylinder.
bool may_leave_material(const Selection& selection, const ResolvedPlan& plan);

/// Keeps the rapids of all sections, in their order, above what those before them really leave, and what plan.earlier left.
/// See link/sections/high_rapids.h.
void keep_rapids_high(Toolpath& toolpath, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
