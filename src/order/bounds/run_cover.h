// A lower bound for turns on lattices with holes: how few corners any cover by runs has.
#pragma once

#include "order/lattice.h"

namespace clearcut::order {

/// Lower bound of the turns of any path or tour of unit steps through all points. Sharp if rows of different regions
/// must be cut in different directions; whole strips cannot distinguish these.
///
/// Every point has two of its (at most four) edges, ends of a path one, and turns at least
/// max(|left - right|, |up - down|). The degrees are relaxed with multipliers pi, the maximum with a share mu for
/// the row; the rest separates into strips, each solved exactly by one pass along the strip. Subgradient ascent as
/// for length [held1971]; any multipliers give a bound. Cost O(iterations * points), a few milliseconds for a
/// thousand points; deterministic.
int run_cover_bound(const Lattice& lattice, bool closed);

}  // namespace clearcut::order
