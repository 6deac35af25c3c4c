// Holes whose tool makes its own shape: spots, countersinks, taps, thread mills.
#pragma once

#include <optional>

#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// The section of a workingstep on a formed hole; nothing for any other.
std::optional<Section> formed_hole_step(int workingstep, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
