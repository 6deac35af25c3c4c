// Feeds and speeds: starting values from material and tool, and values stated for one tool, which are not used for
// another.
#pragma once

#include <string>
#include <vector>

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// Replaces the operation's cutting data by those stated for its tool.
void take_tool_cutting(Operation& operation, const PlanOptions& options);

/// The operation with another tool of the part, with the cutting data stated for that tool: in the options, else in
/// another operation of the part with this tool. Data of the former tool are removed; requests for the operation are
/// kept.
void change_tool(Operation& operation, int tool, const Part& part, const PlanOptions& options);

/// Messages to the user.
struct FilledValues {
  std::vector<std::string> filled;  ///< "spindle 12000 rpm", in the form used for defaults
  /// One sentence for each stated value that is more than twice or less than half of the value that would have been
  /// filled, and one if the machine cannot turn as slowly as required by the material.
  std::vector<std::string> warnings;
};

/// Fills the speed, the feed and the plunge feed that are not stated, from the material of the work (a name of work_material_names()) and the
/// tool: its kind, diameter, teeth, the material of its edges and their coating; see docs/feeds.md. Taps get only their speed. Fills nothing
/// for an unknown material. `depth`: depth of one pass of a mill, mm; for a cone, the depth of the whole cut.
///
/// Chips   if the engagement is limited below a quarter turn the feed compensates for the thinner chip.
/// Limits  speed of the tool and the machine; feed, rapid, power, torque and force of the machine at full width and
///         depth; the bending of the cutter if its holder is known. In woods and plastics the spindle turns more
///         slowly if the feed is limited.
/// Slots   on light machines a slot feed below the feed, if none is stated.
/// Source  of each value names the material, the cutting speed or the feed per tooth, and the limiting quantity.
FilledValues fill_cutting_values(Operation& operation, const Tool& tool, double depth,
                                 const std::string& material, const PlanOptions& options, Sources& sources);

}  // namespace clearcut::resolve
