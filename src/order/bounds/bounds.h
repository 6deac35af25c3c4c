// Proven lower bounds of the length and of the turns of paths and tours.
#pragma once

#include <functional>
#include <span>

#include "order/lattice.h"
#include "order/length/length_model.h"
#include "order/stop.h"

namespace clearcut::order {

// Proven lower bounds for lattices, with or without holes. The proofs are in docs/tour.md.

/// Length of any path or tour through all points, moves of any direction: unit steps alternate the colours of
/// a chessboard, and every step between equal colours is at least sqrt 2 long. mm. O(n).
double lattice_length_bound(const Lattice& lattice, bool closed);

/// Turns of any path or tour of axis-parallel unit steps through all points: covers by maximal strips.
/// Exact for full lattices (2 min(n, m) - 2 open). O(n sqrt n).
int lattice_turns_bound(const Lattice& lattice, bool closed);

/// Turns of any path or tour, moves of any direction and length: a straight run meets at most max(n, m)
/// points. O(1).
int lattice_turns_bound_any_moves(const Lattice& lattice, bool closed);

/// Lower bound of the turns of any path or tour through all points, with any moves. `is_legal` returns whether the
/// straight move between two points stays inside; lines end where it does not. Legal detours are straight pieces too,
/// so they count.
///
/// A path of R straight pieces has R - 1 turns (closed: R). Each piece is on a line of points, and two that follow
/// each other on different ones or in one and the same, so no direction has more than half of the lines, (R + 1) / 2
/// in a path. For any weights w of the points, with M1 >= M2 the heaviest lines of two directions:
///     sum w <= M1 (R + 1) / 2 + M2 (R - 1) / 2.
/// The weights are found by multiplicative updates, any serve. Cost O(iterations * points * directions), bounded;
/// deterministic.
int line_cover_bound(const Lattice& lattice, bool closed, const std::function<bool(int, int)>& is_legal);

/// Lower bound of the turns of any path or tour of unit steps through all points. Sharp if rows of different regions
/// must be cut in different directions; whole strips cannot distinguish these.
///
/// Every point has two of its (at most four) edges, ends of a path one, and turns at least
/// max(|left - right|, |up - down|). The degrees are relaxed with multipliers pi, the maximum with a share mu for
/// the row; the rest separates into strips, each solved exactly by one pass along the strip. Subgradient ascent as
/// for length [held1971]; any multipliers give a bound. Cost O(iterations * points), a few milliseconds for a
/// thousand points; deterministic.
int run_cover_bound(const Lattice& lattice, bool closed);

// Held and Karp's lower bound for the length of tours and paths [held1971].

/// A lower bound of the length of any tour or path of the model, in the problem's unit; typically 0.7 % below the
/// optimum.
///
/// A minimum 1-tree with penalties on nodes bounds every tour from below. The penalties are found by
/// subgradient ascent [volgenant1982] on a sparse graph (candidate edges and `tour`, any valid tour of the
/// model); the bound itself is the 1-tree of the complete graph under the final penalties, found exactly
/// through a k-d tree, so the bound is valid regardless of edges missing in the sparse graph. Whole-number problems
/// are rounded up. Cost O(iterations n log n); deterministic unless `watch` ends first.
double held_karp_bound(const LengthModel& model, std::span<const int> tour, int iterations,
                       const StopWatch& watch);

}  // namespace clearcut::order
