// Adds the steps requested by options to a workplan: smaller tools for material left by larger ones, finishing.
#pragma once

#include "model/options/resolved_plan.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// "walls", "floor", "all". Throws InputError for other names.
Finish finish_of(const ShopOptions& shop);

/// Whether programs are to have their control compensate for wear.
bool writes_wear(const ShopOptions& shop);

/// For milled features one step more for each smaller mill of the part, on what is left: for all where rest machining is
/// asked for, else for those whose tool was chosen by size and under which others lie, since what stands there would stand in their way. Such steps come
/// before the first step underneath, the others after all steps there are, tool by tool.
void add_rest_steps(Part& part, const PlanOptions& options, StepSources& sources);

/// For every milled feature the finishing steps asked for, after all others, which leave stock for them: the floor with
/// the feature's first mill and what is left of it with its narrower ones, then the walls with its last, in
/// options.shop.finish_depths depths (drafted ones in the layers of roughing) and with leads of half the cutter's radius; in
/// finish_steps steps beside each other, the last of which is repeated spring_passes times.
void add_finishing_steps(Part& part, const PlanOptions& options, StepSources& sources);

}  // namespace clearcut::resolve
