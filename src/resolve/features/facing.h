// Facing: stock above all requested features is removed first.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// If the stock's top is above that of every feature, a planar face over the whole stock becomes the first step of
/// the workplan, with a note. Without tools in the options, the step uses the widest of the part's cutters that clear
/// floors.
void add_facing(Part& part, const PlanOptions& options);

}  // namespace clearcut::resolve
