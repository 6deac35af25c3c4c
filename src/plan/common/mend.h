// Completes any set of paths: finds what they leave uncut and adds short detours there and back that clear it. Used by
// strategies alone.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/edge.h"

namespace clearcut::plan {

struct MendJob {
  double radius = 0;                  ///< of the cutter, mm
  double residual = 5e-4;             ///< mm; what is left between paths a diameter apart may be as thick
  std::function<bool(Vec2)> matters;  ///< whether a place has to be cut
  std::span<const Edge> fixed;        ///< cut in any case, by paths that stay as they are
  /// Whether the straight path between two points is legal.
  std::function<bool(Vec2, Vec2)> legal;
};

/// What `paths` and job.fixed leave of the places that matter: see Cover::holes.
std::vector<Vec2> left_by(std::span<const Path> paths, const MendJob& job);

/// Adds to `paths` what it takes to leave nothing. False when something stays that no straight legal path clears.
///
/// Method  A disc that holds the vertices of a hole's rim holds the hole, or nearly all of it. Vertices are gathered
/// into groups that fit into one disc; from the nearest place of a path the cutter goes towards the disc's centre as far
/// as needed and back. Repeated until the exact check finds nothing.
/// Cost    O(rounds * (n + holes * n)), few rounds.
bool mend(std::vector<Path>& paths, const MendJob& job);

}  // namespace clearcut::plan
