// Feeds of a plan that follow the load, if requested.
#pragma once

#include <optional>
#include <vector>

#include "model/options/resolved_plan.h"
#include "stock/material.h"

namespace clearcut::pipeline {

/// Sets the feeds of all sections whose tools are mills, in the material at the start of each; nothing without
/// plan.feed_rule.
void follow_load(Toolpath& toolpath, const ResolvedPlan& plan);

/// The material at the start of a program: the stock, minus drilled holes and the cuts of the earlier program.
/// `radii` as in Material.
stock::Material material_at_start(const Part& part, const std::optional<Toolpath>& earlier,
                                  std::vector<double> radii);

/// Removes the volume swept by a section's feed moves.
void take_away(stock::Material& material, const Section& section, const Tool& tool);

}  // namespace clearcut::pipeline
