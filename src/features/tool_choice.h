// Chooses one of several tools for a feature if the user named none.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::features {

/// Index of the tool for breaking edges: a chamfer mill, else a V-bit; -1: there is none.
int chamfer_tool(const std::vector<Tool>& tools);

/// Index of a tool able to leave tabs in a profile: the chosen tool, or, instead of a pointed or round tip, which
/// leaves no tabs, the smallest mill with vertical sides if there is one.
int tool_for_tabs(const Feature& feature, int chosen, const std::vector<Tool>& tools);

/// Index of the first T-slot cutter; -1: none is at hand.
int t_slot_tool(const std::vector<Tool>& tools);

/// Whether the tool makes the feature's walls as drawn: a tapered end mill only makes walls with the draft angle of
/// its flanks.
bool keeps_walls(const Tool& tool, const Feature& feature);

/// For chamfers a cone; for T-slots the first T-slot cutter; for V-carving and engraving the first tool that carves
/// by its shape; for profiles the largest mill that reaches all but 1 mm2 of their corners; else a drill of the
/// hole's size, or the largest mill that keeps the walls and has a legal position in the feature. If no tool fits,
/// the nearest one, so that planning can report why it does not fit: the smallest mill, or a tool of another kind.
/// `passed_over`: one flag for each tool, or empty; flagged tools are not chosen, and at least one must be unflagged.
/// Needs at least one tool; returns its index. Cost: a clearance of the feature, and for profiles one for each tool
/// tried.
int tool_for(const Feature& feature, const std::vector<Tool>& tools, const std::vector<char>& passed_over,
             const Tolerances& tol);

}  // namespace clearcut::features
