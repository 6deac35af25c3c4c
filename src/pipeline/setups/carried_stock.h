// Stock carried from one set-up of a job to the next, and cuts of two set-ups from opposite sides meeting inside the
// block.
#pragma once

#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/control.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/machined_setup.h"
#include "model/setup_place.h"

namespace clearcut::pipeline {

/// The stock of a later set-up at `place` with the part `next`.
///
/// Shape   If verticals stay vertical and the block is not turned over, all cuts of end mills and drills count. In a
///         block turned over, each cut is a hollow below a ceiling (Section::carried_below): it counts for features
///         with their top no higher, and for rapids and engagement if the cut goes through the block. If the block
///         lies on another side, only the block itself is carried, without layers faced off completely.
/// Error   On the safe side: all material that counts as removed is removed; cones, taps, thread mills and all tools
///         without full width down to the tip count as having cut nothing.
CarriedStock carried_stock(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                           const Part& next);

/// `part` on the block that earlier set-ups have left. Workingsteps of a STEP-NC program whose features lie inside the
/// part's own block and above what is left are left out with a note: there is nothing for them to cut. Throws
/// NothingToMachine, which is done, if these are all and no other was left out.
Part on_block(Part part, const Stock& left);

/// A condition "floors-meet" for each two features, one of `earlier`, one of `next` at `place`, cut from opposite
/// sides and together deeper than the block's thickness, over more than 1 mm2, while each by itself ends inside the
/// block: the floor in either drawing does not exist. Features through the block are intended, and the views of a
/// solid from its sides agree. `next` must have its stock. Cost: one boolean for each pair with overlapping boxes.
std::vector<Condition> meeting_floors(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                                      const Part& next, const Tolerances& tol);

}  // namespace clearcut::pipeline
