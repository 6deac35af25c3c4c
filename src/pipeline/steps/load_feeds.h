// Feeds of a plan that follow the load, where that is asked for.
#pragma once

#include <optional>
#include <vector>

#include "model/options/resolved_plan.h"
#include "stock/material.h"

namespace clearcut::pipeline {

/// Sets the feeds of all sections whose tools are mills, in the material as it stands when each runs; nothing without plan.feed_rule.
void follow_load(Toolpath& toolpath, const ResolvedPlan& plan);

/// What stands when a program begins: the stock, less drilled holes and what the program before has cut. `radii` as in Material.
stock::Material material_at_start(const Part& part, const std::optional<Toolpath>& earlier,
                                  std::vector<double> radii);

/// Removes what the feed moves of a section sweep.
void take_away(stock::Material& material, const Section& section, const Tool& tool);

}  // namespace clearcut::pipeline
