// The material that has to stay on walls: the allowance, and what stands inside the outline of walls with draft.
#pragma once

#include <vector>

#include "verify/coverage/convex.h"
#include "verify/coverage/coverage.h"

namespace clearcut::verify {

/// That material at the height of a question. Keeps a reference to the question.
class WallResidual {
 public:
  explicit WallResidual(const CoverageQuestion& question);

  /// Whether there may be any.
  bool may_be() const { return question_.allowance > 0 || question_.part->greatest_draft_offset() > 0; }
  /// Whether p lies in what is to be left on a wall.
  bool holds(Vec2 p) const;
  /// Whether all of `polygon`, which lies within `reach` mm of `center`, lies in what is to be left on one wall.
  bool holds_on_one_wall(const ConvexPolygon& polygon, Vec2 center, double reach) const;

 private:
  bool wall_holds(const Wall& wall, const ConvexPolygon& polygon, Vec2 center, double reach) const;

  const CoverageQuestion& question_;
  std::vector<Wall> beyond_;  ///< outlines beside the stock whose allowance may reach into it
};

}  // namespace clearcut::verify
