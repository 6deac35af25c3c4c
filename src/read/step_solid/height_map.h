// Height of a solid over every place of its plan.
#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "base/tolerances.h"
#include "geometry/region.h"
#include "read/step_solid/solid_model.h"

namespace clearcut::read {

/// An upward face in plan view, with the lowest permitted height of cuts there.
struct Cell {
  int face = 0;  ///< index into SolidModel::faces
  double z = 0;
  bool floor = false;  ///< flat, or the conical end of a drilled hole
  /// Also for a face too thin for an area, so that its neighbours' edges find their counterpart.
  std::vector<Path> curves;
  Regions area;
  std::vector<Vec2> inside;  ///< points well inside the area
};

/// mm. Heights differing by less are equal.
inline constexpr double kSameHeight = 1e-5;

class HeightMap {
 public:
  /// Throws InputError naming the face whose outline does not close.
  HeightMap(const SolidModel& solid, const std::string& file_name, const Tolerances& tol);

  const std::vector<Cell>& cells() const { return cells_; }
  /// The plan out to kOpenReach around it.
  const Box& reach() const { return reach_; }
  /// Mends in faces' outlines.
  const Diagnostics& mends() const { return mends_; }

 private:
  Box reach_;
  std::vector<Cell> cells_;
  Diagnostics mends_;
};

}  // namespace clearcut::read
