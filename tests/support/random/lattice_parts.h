// Random orthogonal parts on a lattice: corridors exactly as wide as the cutter, blocks with
// arms of any width, and rooms that end in a tip.
#pragma once

#include "base/random.h"
#include "model/part.h"

namespace clearcut::test_support {

/// A closed pocket of up to 40 squares whose side is the cutter's diameter in mm, joined along their sides: each corridor
/// is an exact fit.
Part exact_fit_pocket(Random& random, double diameter);

/// The same as a block that stands free in the air, on a lattice whose lines are 0.3 to 2 diameters apart.
Part block_with_arms(Random& random, double diameter);

/// A closed pocket that narrows, between a wall and a corner one diameter from it, to a tip through which the cutter just
/// goes into a recess.
Part room_with_tip(Random& random, double diameter);

}  // namespace clearcut::test_support
