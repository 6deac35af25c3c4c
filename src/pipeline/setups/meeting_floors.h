// Cuts of two set-ups from opposite sides that meet inside the block.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/control.h"
#include "pipeline/setups/carried_stock.h"

namespace clearcut::pipeline {

/// A condition "floors-meet" for each two features, one of `earlier`, one of `next` at `place`, that are cut from opposite sides and
/// together go deeper than the block is thick, over more than 1 mm2, while each alone ends in it: the floor that either
/// drawing shows is not there. Features that go through the block are meant to, and of a solid what is seen from its sides agrees.
/// `next` has its stock. Cost one boolean for each two of them whose boxes overlap.
std::vector<Condition> meeting_floors(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                                      const Part& next, const Tolerances& tol);

}  // namespace clearcut::pipeline
