// The fastest of several plans: rings at several steps, each pulled taut, judged by the machine's time. Used
// by the planner alone.
#pragma once

#include "plan/contour.h"
#include "plan/contour_passes.h"

namespace clearcut {

/// Replaces the passes of each component of `result` by one continuous way wherever that is proven to clear
/// everything and is faster. `job` is what result.passes were made with; `bare`: not even a film may stay.
void shorten_passes(const std::vector<Domain>& domains, RingJob job, const ContourOptions& options,
                    const Tolerances& tol, bool bare, LayerPasses& result);

}  // namespace clearcut
