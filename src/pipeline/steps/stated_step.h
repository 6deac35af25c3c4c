// Workingsteps with a stated path of the cutter.
#pragma once

#include <optional>

#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// The section of a workingstep with a stated path; nothing for any other. The moves are as stated. If a move does
/// not begin at the end of the previous one, and before the first and after the last, the cutter moves above all
/// remaining material: down again by a rapid to the height of crossing rapids and from there at the plunge feed. The
/// section has no moves if the path of an earlier workingstep also makes this one.
std::optional<Section> stated_step(int workingstep, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
