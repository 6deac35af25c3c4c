// The widest cutter that fits into a feature, and the choice of one of several tools if the user named none.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::features {

/// Diameter of the largest cutter that has a legal position over the feature's floor, mm; 0 when none. At open
/// sides only places over the feature itself count.
double largest_fitting_diameter(const Feature& feature, const Tolerances& tol);

/// Whether the cutter can go down into the feature at all: where it may not plunge it needs room for a ramp or a small circle, unless the
/// feature is open at a side. Holes that are there before are left out of account.
bool has_room_to_enter(const Feature& feature, const Tool& tool, const Tolerances& tol);

/// For each feature the diameter of the largest cutter that is worth a try, mm: as above, and where sides are open also a wider one that
/// comes in from outside and reaches nine tenths of the floor. Features in a row with the same walls share the work.
std::vector<double> largest_cutters(const Part& part, const Tolerances& tol);

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

/// Whether the tool's end leaves the fillet between the feature's floor and walls whole: sharper ends cut into it.
bool keeps_fillet(const Tool& tool, const Feature& feature);

/// Whether the tool's end has the radius of that fillet.
bool makes_fillet(const Tool& tool, const Feature& feature);

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
