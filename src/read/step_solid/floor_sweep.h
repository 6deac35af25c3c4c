// Area open to a cutter at each level, from the highest level of a solid to the lowest, and the curves of faces in
// plan view: selection of those bounding an area, and their order.
#pragma once

#include <string>
#include <vector>

#include "base/tolerances.h"
#include "geometry/region.h"
#include "read/repair/repair.h"
#include "read/step_solid/height_map.h"

namespace clearcut::read {

/// mm. Ends of edges of different faces nearer than this are one point.
inline constexpr double kSamePlace = 1e-4;

/// Indices, ascending, of the curves without a reversed counterpart. Common ends must be equal. O(n log n)
/// while few curves end in one point.
std::vector<std::size_t> unpaired(const std::vector<const Path*>& curves);

/// Joins curves end to start into closed ones as far as they go; the repair sees to the rest. O(n log n).
std::vector<RawCurve> chained(const std::vector<Path>& curves, const std::string& source);

/// Material above a level is also above every lower one, so that each level only adds its own faces.
///
/// While faces do not overlap in plan view their own edges make the boundary, exactly. From the first level with
/// overlaps on, the material is kept as regions.
///
/// Cost    all levels together: O(e log^2 e) for the faces' e edges, each united with its neighbours once, and for
///         each level O(b log b) for the b edges of the boundary there. Memory O(e).
class FloorSweep {
 public:
  FloorSweep(const HeightMap& map, const Tolerances& tol);

  /// The area without material above z, out to kOpenReach around the plan. z must not increase from call to call.
  Regions free_at(double z);

 private:
  struct Curve {
    std::size_t order = 0;  ///< among all curves of the file
    const Path* path = nullptr;
  };

  std::vector<int> take_above(double z);
  void add_curves(const std::vector<int>& cells);
  double excess(const Regions& free) const;
  Regions exact_free(double z) const;
  Regions overlaid_free();

  const HeightMap& map_;
  Tolerances tol_;
  std::vector<int> highest_first_;  ///< indices of cells
  std::vector<std::size_t> first_curve_;
  std::size_t taken_ = 0;
  std::size_t united_ = 0;  ///< number of taken cells contained in standing_
  /// Boundary of the material: curves present in only one direction, in the order of the file.
  std::vector<Curve> boundary_;
  double sum_of_areas_ = 0;  ///< mm2
  bool overlaps_ = false;
  Regions standing_;
};

}  // namespace clearcut::read
