// Properties of one move used by objectives.
#pragma once

#include "geometry/vec2.h"

namespace clearcut::order {

/// All properties of the move a -> b used by objectives.
struct MoveShape {
  double length = 0;       ///< in the problem's metric
  Vec2 leaves;             ///< direction at a, not normalised
  Vec2 arrives;            ///< direction at b
  int inner_turns = 0;     ///< turns of a legal detour between its ends
  double inner_angle = 0;  ///< degrees
  bool straight = true;
};

}  // namespace clearcut::order
