// Facing: stock that stands over everything that is asked for comes off before anything else.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Where the stock's top lies above that of every feature, a planar face over the whole stock becomes the first step of the
/// workplan, and a note says so. Without tools among the options it takes the widest of the part's cutters that clear
/// floors.
void add_facing(Part& part, const PlanOptions& options);

}  // namespace clearcut::resolve
