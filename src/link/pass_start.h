// Where on a pass cutting begins.
#pragma once

#include "model/pass.h"

namespace clearcut::link {

struct PassStart {
  Vec2 point;
  std::size_t edge = 0;  ///< closed passes: the edge it lies on
  double t = 0;
  bool backwards = false;  ///< open passes: from the last point to the first
};

/// The closed path, begun at `start`.
Path rotated_to(const Path& path, const PassStart& start);

/// Nearest to p: anywhere on a closed pass, an end of a reversible one, else where it begins. Cost O(edges).
PassStart nearest_start(const Pass& pass, Vec2 p);

}  // namespace clearcut::link
