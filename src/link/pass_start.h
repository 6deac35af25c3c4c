// The place on a pass at which cutting begins.
#pragma once

#include "model/pass.h"

namespace clearcut::link {

struct PassStart {
  Vec2 point;
  std::size_t edge = 0;  ///< for closed passes: the edge of the place
  double t = 0;
  bool backwards = false;  ///< for open passes: run from the last point to the first
};

/// The closed path, begun at `start`.
Path rotated_to(const Path& path, const PassStart& start);

/// The start nearest to p: anywhere on a closed pass, at an end of a reversible one, else at its beginning.
/// Cost O(edges).
PassStart nearest_start(const Pass& pass, Vec2 p);

}  // namespace clearcut::link
