// Finds the fastest of several plans: rings at several steps, joined to shortened paths, compared by the
// machine's time.
#pragma once

#include "plan/contour/contour.h"
#include "plan/contour/passes.h"

namespace clearcut::plan::contour {

/// Replaces the passes of each component of `result` by one continuous path if this path is proven to clear
/// everything and is faster. `job`: the settings with which the passes were made.
void shorten_passes(const std::vector<Domain>& domains, RingJob job, const Layer& layer,
                    const ContourOptions& options, const Tolerances& tol, LayerPasses& result);

}  // namespace clearcut::plan::contour
