// Proven lower bounds for lattices, with or without holes. The proofs are in docs/tour.md.
#pragma once

#include "order/lattice.h"

namespace clearcut::order {

/// Length of any path or tour through all points, moves of any direction: unit steps alternate the colours of
/// a chessboard, and every step between equal colours is at least sqrt 2 long. mm. O(n).
double lattice_length_bound(const Lattice& lattice, bool closed);

/// Turns of any path or tour of axis-parallel unit steps through all points: covers by maximal strips.
/// Exact for full lattices (2 min(n, m) - 2 open). O(n sqrt n).
int lattice_turns_bound(const Lattice& lattice, bool closed);

/// Turns of any path or tour, moves of any direction and length: a straight run meets at most max(n, m)
/// points. O(1).
int lattice_turns_bound_any_moves(const Lattice& lattice, bool closed);

}  // namespace clearcut::order
