// Cutters that cut by their shape: how deep cones and balls go into the finished part, and what they leave.
#pragma once

#include <optional>
#include <vector>

#include "geometry/spatial/cell_grid.h"
#include "model/move.h"
#include "model/tool.h"
#include "verify/faults/gouge.h"
#include "verify/part/edge_tree.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// The deepest cut of a cone or a ball into the part along `move`: how far, sideways or upwards, it would have to be shifted.
///
/// Over each wall near, the distance of the path from the wall is held against the cutter's radius at the height to which the wall
/// stands there; for a leaning wall at its foot, at its top, and where the flank ends. Along straight paths beside straight
/// walls the excess has one maximum, found by sections; else the path is halved until a Lipschitz bound settles it.
/// `slack`: gouges below it need not be found.
std::optional<Gouge> shaped_gouge_of(const FinishedPart& part, const Move& move, const Tool& tool,
                                     double slack);

/// Height over its tip at which a cutter is `distance` mm wide from its axis; nothing beyond its radius.
std::optional<double> height_at(const Tool& tool, double distance);

/// What cutters have cut so far, asked for at places. Every answer is a height that was really reached.
class CutHeights {
 public:
  /// A feed move. Pointers are kept.
  void add(const Move& move, const Tool& tool);

  /// Lowest height that the cutters passed over p; infinite where none did.
  double at(Vec2 p) const;

 private:
  struct Entry {
    const Move* move;
    const Tool* tool;
  };

  std::vector<Entry> entries_;
  BoxIndex index_{1};  ///< 1 mm: a fraction of most cutters
};

}  // namespace clearcut::verify
