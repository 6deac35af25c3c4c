// Adds the steps requested by options to a workplan: smaller tools for material left by larger ones, finishing.
#pragma once

#include "model/options/resolved_plan.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// "walls", "floor", "all". Throws InputError for other names.
Finish finish_of(const ShopOptions& shop);

/// Adds for milled features one step for each smaller mill of the part, on the material left: for all features if
/// rest machining is requested, else for features with a tool chosen by size and with other features below, since the
/// remaining material would be in their way. These latter steps come before the first step underneath, the others
/// after all existing steps, tool by tool.
void add_rest_steps(Part& part, const PlanOptions& options, StepSources& sources);

/// Adds for every milled feature the requested finishing steps, after all others, which leave stock for them: the
/// floor with the feature's first mill and the rest of the floor with its narrower ones, then the walls with its last
/// mill, in options.shop.finish_depths depths (drafted ones in the layers of roughing) and with leads of half the
/// cutter's radius.
void add_finishing_steps(Part& part, const PlanOptions& options, StepSources& sources);

}  // namespace clearcut::resolve
