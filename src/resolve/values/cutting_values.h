// Starting values of feeds and speeds, from material and tool.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Messages to the user.
struct FilledValues {
  std::vector<std::string> filled;  ///< "spindle 12000 rpm", in the form used for defaults
  /// One sentence for each stated value that is more than twice or less than half of the value that would have been
  /// filled, and one if the machine cannot turn as slowly as required by the material.
  std::vector<std::string> warnings;
};

/// Fills the speed, the feed and the plunge feed that are not stated, from the material of the work
/// (options.shop.material) and the tool: its kind, diameter, teeth, the material of its edges and their coating; see
/// docs/feeds.md. Taps get only their speed. Fills nothing without a material. `depth`: depth of one pass of a mill,
/// mm; for a cone, the depth of the whole cut.
///
/// Chips   if the engagement is limited below a quarter turn the feed compensates for the thinner chip.
/// Limits  speed of the tool and the machine; feed, rapid, power, torque and force of the machine at full width and
///         depth; the bending of the cutter if its holder is known. In woods and plastics the spindle turns more
///         slowly if the feed is limited.
/// Slots   on light machines a slot feed below the feed, if none is stated.
/// Source  of each value names the material, the cutting speed or the feed per tooth, and the limiting quantity.
FilledValues fill_cutting_values(Operation& operation, const Tool& tool, double depth,
                                 const PlanOptions& options, Sources& sources);

}  // namespace clearcut::resolve
