// Square lattices of places to visit in a box.
#pragma once

#include <vector>

#include "geometry/box.h"
#include "geometry/route/legal_area.h"

namespace clearcut::plan::tour {

using Points = std::vector<Vec2>;

/// Rows and columns of places, `pitch` mm apart, from the lower left one at `corner`.
struct Lattice {
  Vec2 corner;
  double pitch = 0;
  int columns = 0, rows = 0;

  Vec2 at(int column, int row) const { return corner + Vec2{column * pitch, row * pitch}; }
};

/// From the box's lower left corner, as published.
Lattice published_lattice(const Box& box, double pitch);
/// Stretched down from a pitch of at most `largest` mm so that the wider side of the box is met at both ends, in the middle
/// of the other side. Of a box far smaller than the pitch only the middle is met.
Lattice fitted_lattice(const Box& box, double largest);
/// The same lattice with as many more columns and rows as it takes to fill `box`.
Lattice filling(const Lattice& lattice, const Box& box);
/// The places of the lattice that lie in `area`, row by row.
Points points_in(const Lattice& lattice, const LegalArea& area);

}  // namespace clearcut::plan::tour
