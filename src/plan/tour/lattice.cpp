#include <algorithm>
#include <cmath>

#include "plan/tour/tour.h"

namespace clearcut::plan::tour {
namespace {

int steps_in(double extent, double pitch) {
  return static_cast<int>(std::floor(extent / pitch + 1e-9));
}

}  // namespace

Lattice published_lattice(const Box& box, double pitch) {
  return {box.min, pitch, steps_in(box.width(), pitch) + 1, steps_in(box.height(), pitch) + 1};
}

Lattice fitted_lattice(const Box& box, double largest) {
  const double wide = std::max(box.width(), box.height());
  const bool stretched = wide > largest / 2;
  Lattice lattice =
      published_lattice(box, stretched ? wide / std::max(1.0, std::ceil(wide / largest - 1e-9)) : largest);
  const auto centred = [&](double low, double extent, int count) {
    return low + (extent - (count - 1) * lattice.pitch) / 2;
  };
  lattice.corner = {centred(box.min.x, box.width(), lattice.columns),
                    centred(box.min.y, box.height(), lattice.rows)};
  return lattice;
}

Lattice filling(const Lattice& lattice, const Box& box) {
  const int left = std::max(0, steps_in(lattice.corner.x - box.min.x, lattice.pitch));
  const int below = std::max(0, steps_in(lattice.corner.y - box.min.y, lattice.pitch));
  return {lattice.at(-left, -below), lattice.pitch,
          steps_in(box.max.x - lattice.corner.x, lattice.pitch) + left + 1,
          steps_in(box.max.y - lattice.corner.y, lattice.pitch) + below + 1};
}

Points points_in(const Lattice& lattice, const LegalArea& area) {
  Points points;
  for (int row = 0; row < lattice.rows; ++row) {
    for (int column = 0; column < lattice.columns; ++column) {
      if (area.holds(lattice.at(column, row))) points.push_back(lattice.at(column, row));
    }
  }
  return points;
}

}  // namespace clearcut::plan::tour
