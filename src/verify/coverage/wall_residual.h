// The material that must remain on walls: the allowance, and the material inside the outline of walls with draft.
#pragma once

#include <vector>

#include "verify/coverage/convex.h"
#include "verify/coverage/coverage.h"

namespace clearcut::verify {

/// The material to remain at the height of a question. Keeps a reference to the question.
class WallResidual {
 public:
  explicit WallResidual(const CoverageQuestion& question);

  /// Whether there may be any.
  bool may_be() const { return question_.allowance > 0 || question_.part->greatest_draft_offset() > 0; }
  /// Whether p is in the material to be left on a wall.
  bool holds(Vec2 p) const;
  /// Whether the whole `polygon`, located within `reach` mm of `center`, is in the material to be left on one wall.
  bool holds_on_one_wall(const ConvexPolygon& polygon, Vec2 center, double reach) const;

 private:
  bool wall_holds(const Wall& wall, const ConvexPolygon& polygon, Vec2 center, double reach) const;

  const CoverageQuestion& question_;
  std::vector<Wall> beyond_;  ///< outlines beside the stock with an allowance that may extend into the stock
};

}  // namespace clearcut::verify
