// Rapids above the material that earlier passes really left.
#pragma once

#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// Keeps the rapids of all sections, in their order, above the material really left by earlier sections and by
/// plan.earlier. See link/sections/high_rapids.h.
void keep_rapids_high(Toolpath& toolpath, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
