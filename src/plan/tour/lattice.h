// Square lattices of points to visit in a box.
#pragma once

#include <vector>

#include "geometry/box.h"
#include "geometry/route/legal_area.h"

namespace clearcut::plan::tour {

using Points = std::vector<Vec2>;

/// Rows and columns of points, `pitch` mm apart, from the lower left one at `corner`.
struct Lattice {
  Vec2 corner;
  double pitch = 0;
  int columns = 0, rows = 0;

  Vec2 at(int column, int row) const { return corner + Vec2{column * pitch, row * pitch}; }
};

/// The lattice from the box's lower left corner, as published.
Lattice published_lattice(const Box& box, double pitch);
/// A lattice of at most `largest` mm pitch, reduced so that rows meet both ends of the box's longer side;
/// centred along the other side. For a box far smaller than the pitch, only its middle.
Lattice fitted_lattice(const Box& box, double largest);
/// The same lattice with as many more columns and rows as fill `box`.
Lattice filling(const Lattice& lattice, const Box& box);
/// The points of the lattice in `area`, row by row.
Points points_in(const Lattice& lattice, const LegalArea& area);

}  // namespace clearcut::plan::tour
