// Which section follows which, where the input leaves that open: drawings and solids.
#pragma once

#include <vector>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::pipeline {

/// The sections of a part whose order is nobody's wish, so that few tool changes and short rapids join them.
///
/// Kept    sections that may meet (the boxes of what their cutters sweep overlap) stay in the order they have.
/// Tools   as few changes as the kept order allows, where there are not too many ways to try; all that can be cut with the
///         tool in the spindle comes before the next tool.
/// Rapids  the sections of each turn of a tool are ordered by the optimiser, from where the turn before ended; the order
///         they have stays where that is as short. The same sections give the same order on any number of threads.
/// Alike   with `alike_together` holes that one cycle makes follow each other within the turn of their tool, where nothing else has
///         to come between them: the control repeats the cycle.
/// Cost    O(sections^2) looks at boxes, and the optimiser's.
std::vector<Section> in_short_order(std::vector<Section> sections, const Part& part,
                                    bool alike_together = false);

}  // namespace clearcut::pipeline
