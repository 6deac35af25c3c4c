// Fillets between the walls of an outline.
#pragma once

#include <vector>

#include "geometry/edge.h"

namespace clearcut::read::stepnc {

struct Filleted {
  Path path;
  std::vector<Vec2>
      sharp;  ///< corners that stay sharp, because no arc of the radius fits between their edges
};

/// `path` with an arc of `radius`, mm, in each corner at which it turns to the left (counter-clockwise loops: the corners of a pocket, not
/// those of an island in it); `closed`: also where its end meets its start. Edges that go on in one direction are no corner.
///
/// Error   exact but for rounding: an arc touches both edges.
/// Cost    O(edges).
Filleted filleted(const Path& path, bool closed, double radius);

/// The same for corners at which the path turns to the right.
Filleted filleted_on_the_right(const Path& path, double radius);

}  // namespace clearcut::read::stepnc
