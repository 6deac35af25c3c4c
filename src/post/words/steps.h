// From moves to the elements of a program: lines and arcs between printed positions.
#pragma once

#include <span>
#include <vector>

#include "model/move.h"
#include "model/options/post_options.h"
#include "post/words/print_grid.h"

namespace clearcut::post {

/// One motion word: straight to `to`, or an arc whose centre is (i, j) from the printed start.
struct Step {
  Ticks to;
  Turn turn = Turn::kStraight;
  long long i = 0;
  long long j = 0;
};

struct StepRules {
  PrintGrid grid;
  bool arcs = true;
  double largest_radius = 10000;  ///< mm; 32-bit controllers lose the centre of wider arcs
  double chord = 0.0002;          ///< mm; chord error of arcs replaced by lines
  /// Largest difference of the printed radii at an arc's ends, mm: the tightest rule of any control.
  double radius_mismatch = 0.002;
};

/// Largest distance in plan between a move and its steps, mm, if no arc becomes lines: an arc deviates by at most a
/// step (or 0.3 um), and an end may additionally be displaced by half a step in each axis.
double largest_deviation(const PrintGrid& grid);

StepRules step_rules(const PostOptions& options, int decimals, double largest_radius);

/// Appends the steps of `move` starting from the printed position `from` (within a step of the move's start);
/// motion rounded to zero gives no step.
///
/// Error   ends within half a grid step per axis; arcs deviate from the wanted curve by at most about two grid steps;
///         arcs that cannot be printed with this accuracy become shorter arcs or lines within rules.chord.
/// Cost    constant per step.
/// Returns the printed position reached.
Ticks append_steps(const Move& move, Ticks from, const StepRules& rules, std::vector<Step>& out);

/// The moves with successive straight ones joined if they have exactly the same printed direction and feed: one block
/// replaces them. Rapids are joined only along Z or level, because controls may run others along a bent path.
std::vector<Move> with_lines_joined(std::span<const Move> moves, const PrintGrid& grid);

}  // namespace clearcut::post
