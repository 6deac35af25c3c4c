// The undercuts of T-slots.
#pragma once

#include <optional>

#include "model/move.h"
#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// The disc descends at the beginning of its line, moves along the line at one height, and retracts at a free end: at
/// the end, or back at the beginning. Nothing for steps on other features.
std::optional<Section> t_slot_step(int workingstep, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
