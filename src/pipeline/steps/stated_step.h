// Workingsteps whose input states the way of the cutter.
#pragma once

#include <optional>

#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// The section of a workingstep that is cut by a stated path; nothing for any other. The moves stand as stated. Where one does not begin
/// at the end of the one before, and before the first and after the last, the cutter goes over all that stands: down again by a rapid to
/// where rapids cross and from there at the plunge feed. The section has no moves where the path of an earlier workingstep also makes this one.
std::optional<Section> stated_step(int workingstep, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
