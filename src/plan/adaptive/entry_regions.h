// Finds the places where adaptive clearing enters the material.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/voronoi/clearance.h"
#include "model/layer.h"
#include "plan/adaptive/clearing/clearing_path.h"
#include "plan/adaptive/clearing/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// Finds the wide places of one connected legal area. The radius of a Disc is that of the material to be
/// cleared.
class EntryRegionFinder {
 public:
  /// `front`: where the centre may be while it clears. `limit`: of the engagement, radians. `start`: near
  /// which the first entry is asked for. References are kept.
  EntryRegionFinder(const Region& front, const Clearance& clearance, const RemainingStock& remaining,
                    const Layer& layer, double limit, std::optional<Vec2> start);

  /// The widest places, each of them worth an entry of its own.
  std::vector<Disc> choose() const;
  /// The widest place whose middle is not cleared yet.
  std::optional<Disc> widest_uncut() const;
  /// mm; radius of the widest disc about a place that lies in a predrilled hole; 0 if it lies in none.
  double hole_at(Vec2 place) const;
  /// A straight cut from a place in a passage that has no room for the circle of a helix (which would have thousands of turns on one
  /// spot): towards the farthest place on the passage's axis up to four tool radii away. Nothing where there is room, or no such place.
  std::optional<Edge> stroke_in_passage(const Disc& entry_region) const;

 private:
  std::optional<Disc> first_entry_region() const;
  bool is_worth_entry(const Disc& disc) const;

  const Region& front_;
  const Clearance& clearance_;
  const RemainingStock& remaining_;
  double radius_, reach_, depth_, limit_;
  std::optional<Vec2> start_;
  std::vector<PredrilledHole> holes_;
};

/// Index of the entry region whose rim is nearest to p; of regions that hold p, the one in which it lies
/// deepest. There must be one.
std::size_t nearest_entry_region(const std::vector<Disc>& entry_regions, Vec2 p);

}  // namespace clearcut::plan::adaptive
