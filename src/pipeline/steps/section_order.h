// Order of sections if the input leaves it open, as drawings and solids do, and feeds of sections that follow the
// load, if requested.
#pragma once

#include <optional>
#include <vector>

#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/part.h"
#include "stock/material.h"

namespace clearcut::pipeline {

/// Orders the sections of a part without a requested order, for few tool changes and short rapids.
///
/// Kept    sections that may overlap (by the boxes of their swept areas) stay in their order.
/// Tools   the least number of changes allowed by the kept order, if there are not too many possibilities; all
///         sections that can be cut with the tool in the spindle come before the next tool.
/// Rapids  the sections of each turn of a tool are ordered by the optimiser, from the end of the previous turn; the
///         given order is kept if it is as short. The same sections give the same order on any number of threads.
/// Alike   with `alike_together` holes of one cycle follow each other within the turn of their tool, unless other
///         sections must come between them: the control repeats the cycle.
/// Cost    O(sections^2) comparisons of boxes, plus the cost of the optimiser.
std::vector<Section> in_short_order(std::vector<Section> sections, const Part& part,
                                    bool alike_together = false);

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
