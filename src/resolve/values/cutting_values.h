// Starting values of feeds and speeds from what is cut and with what.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// What is told to the user.
struct FilledValues {
  std::vector<std::string> filled;  ///< "spindle 12000 rpm", as values by default are told
  /// One sentence for each stated value that is more than twice or less than half of what would have been filled, and where a
  /// machine cannot turn as slowly as the material asks for.
  std::vector<std::string> warnings;
};

/// Fills the speed, the feed and the plunge feed that nobody has stated from the material of the work (options.shop.material)
/// and the tool: its kind, diameter, teeth, the material of its edges and their coating; see docs/feeds.md. Taps get their
/// speed alone. Nothing without a material. `depth`: mm that one pass of a mill takes; of a cone the depth of the whole cut.
///
/// Chips   where the engagement is limited below a quarter turn the feed makes up for the thinner chip.
/// Limits  speed of the tool and the machine; feed, rapid, power, torque and force of the machine at full width and depth; what
///         bends the cutter where its holder is known. Woods and plastics turn more slowly where the feed is limited.
/// Slots   on light machines a slot feed below the feed, where nobody states one.
/// Source  of each value says the material, the cutting speed or the feed per tooth, and what has limited it.
///
FilledValues fill_cutting_values(Operation& operation, const Tool& tool, double depth,
                                 const PlanOptions& options, Sources& sources);

}  // namespace clearcut::resolve
