// Completes a set of paths: finds what they leave uncut and adds detours, there and back, that clear it.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/edge.h"

namespace clearcut::plan {

struct MendJob {
  double radius = 0;       ///< of the cutter, mm
  double residual = 5e-4;  ///< mm; residuals up to this thick may stay between two paths one diameter apart
  std::function<bool(Vec2)> matters;  ///< whether a place has to be cleared
  std::span<const Edge> fixed;        ///< edges that clear as well, and that no detour is added to
  /// Whether the cutter's centre may go straight from one point to the other.
  std::function<bool(Vec2, Vec2)> legal;
};

/// Places that have to be cleared and that neither `paths` nor `job.fixed` clear; see Cover::holes.
std::vector<Vec2> left_by(std::span<const Path> paths, const MendJob& job);

/// Adds detours to `paths` until nothing is left. False if something stays that no straight legal detour
/// clears.
///
/// Method  The vertices of a hole's rim are gathered into groups that one position of the cutter clears. From
///         the nearest legal place on a path the cutter goes as far towards that position as the group needs,
///         and back. A disc that holds the vertices holds nearly all of the hole; the search for holes is
///         repeated until it finds none.
/// Cost    O(rounds * (n + holes * n)) for n edges, at most 24 rounds.
bool mend(std::vector<Path>& paths, const MendJob& job);

}  // namespace clearcut::plan
