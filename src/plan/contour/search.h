// The fastest of several plans: rings at several steps, each pulled taut, checked by the machine's time. Used
// by the planner alone.
#pragma once

#include "plan/contour/contour.h"
#include "plan/contour/passes.h"

namespace clearcut::plan::contour {

/// Replaces the passes of each component of `result` by one continuous path wherever that is proven to clear
/// everything and is faster. `job` is what result.passes of the layer were made with.
void shorten_passes(const std::vector<Domain>& domains, RingJob job, const Layer& layer,
                    const ContourOptions& options, const Tolerances& tol, LayerPasses& result);

}  // namespace clearcut::plan::contour
