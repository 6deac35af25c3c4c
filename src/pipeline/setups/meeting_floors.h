// Cuts of two set-ups from opposite sides meeting inside the block.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/control.h"
#include "pipeline/setups/carried_stock.h"

namespace clearcut::pipeline {

/// A condition "floors-meet" for each two features, one of `earlier`, one of `next` at `place`, cut from opposite
/// sides and together deeper than the block's thickness, over more than 1 mm2, while each by itself ends inside the
/// block: the floor in either drawing does not exist. Features through the block are intended, and the views of a
/// solid from its sides agree. `next` must have its stock. Cost: one boolean for each pair with overlapping boxes.
std::vector<Condition> meeting_floors(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                                      const Part& next, const Tolerances& tol);

}  // namespace clearcut::pipeline
