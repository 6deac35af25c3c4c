// Which of several tools makes a feature, where nobody has said it.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::features {

/// Index of the tool that breaks edges: a chamfer mill, else a V-bit; -1: none is at hand.
int chamfer_tool(const std::vector<Tool>& tools);

/// Index of the tool that leaves tabs in a profile: the one that was chosen, or in place of a pointed or round tip, which leaves none, the
/// smallest mill with upright sides where there is one.
int tool_for_tabs(const Feature& feature, int chosen, const std::vector<Tool>& tools);

/// Index of the first T-slot cutter; -1: none is at hand.
int t_slot_tool(const std::vector<Tool>& tools);

/// Whether the tool leaves the feature's walls as they are drawn: a tapered end mill those alone that lean as much as its flanks.
bool keeps_walls(const Tool& tool, const Feature& feature);

/// For chamfers a cone; for T-slots the first cutter made for them; for V-carving and engraving the first tool that carves by its shape; for profiles the largest mill that
/// reaches all but 1 mm2 of their corners; else a drill of the hole's size, or the largest mill that keeps the walls and has a
/// legal position in the feature. Where nothing does, the one that comes nearest, for whoever plans to say why it does not: the smallest mill, or
/// a tool of another kind. `passed_over`: one flag a tool, or none at all; those set are not chosen, one at least is open. Needs at least one tool;
/// returns its index. Cost: a clearance of the feature, and for profiles one for each tool tried.
int tool_for(const Feature& feature, const std::vector<Tool>& tools, const std::vector<char>& passed_over,
             const Tolerances& tol);

}  // namespace clearcut::features
