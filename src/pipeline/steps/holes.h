// Round holes have their own steps in the pipeline: no layers, one plunge or one helix.
#pragma once

#include <optional>
#include <vector>

#include "model/layer.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// The section of a workingstep made as a hole; nothing if it is to be cleared layer by layer.
///
/// Drilled  with drills and reamers always (a section without moves if they cannot make or pierce the hole), with
///          centre-cutting mills of the hole's own size.
/// Bored    features declared as round holes, with a mill that leaves no post, unless another strategy or a plunge is
/// requested. `layers` are those of the step.
std::optional<Section> hole_step(const std::vector<Layer>& layers, int workingstep, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
