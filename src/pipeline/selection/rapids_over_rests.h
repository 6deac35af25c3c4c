// Rapids above material left by published methods and skipped workingsteps.
#pragma once

#include "model/options/resolved_plan.h"
#include "pipeline/selection/selection.h"

namespace clearcut::pipeline {

/// Whether material assumed as cut by later workingsteps may remain: with a strategy that does not promise complete
/// clearing (published methods, the published grid, the user's own strategies), with a step without passes, and with
/// a tool end that is not flat: rounded corners, points and cones leave more material than a cylinder.
bool may_leave_material(const Selection& selection, const ResolvedPlan& plan);

/// Keeps the rapids of all sections, in their order, above the material really left by earlier sections and by
/// plan.earlier. See link/sections/high_rapids.h.
void keep_rapids_high(Toolpath& toolpath, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
