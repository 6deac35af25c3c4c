// Steps whose cutter cuts by its shape along lines in space: V-carving and engraving.
#pragma once

#include <optional>

#include "model/move.h"
#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// The section of a carved workingstep; nothing if it is cleared layer by layer.
std::optional<Section> carve_step(int workingstep, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
