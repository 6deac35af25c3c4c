// A lower bound for turns on lattices with holes: how few corners any cover by runs has.
#pragma once

#include "order/lattice.h"

namespace clearcut::order {

/// Turns that no path or tour of unit steps through all points undercuts. Sharp where rows of different regions
/// have to be cut in different directions, which whole strips cannot tell apart.
///
/// Every point has two of its (at most four) edges, ends of a path one, and turns at least
/// max(|left - right|, |up - down|). The degrees are relaxed with multipliers pi, the maximum with a share mu for
/// the row; what is left falls apart into strips, each solved exactly by going along it. Subgradient ascent as for
/// length [held1971]; any multipliers give a bound.
/// Cost O(iterations * points), a few milliseconds for a thousand points; deterministic.
int run_cover_bound(const Lattice& lattice, bool closed);

}  // namespace clearcut::order
