// Where adaptive clearing goes down into the material.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/clearance.h"
#include "model/layer.h"
#include "plan/adaptive/disc_engagement.h"
#include "plan/adaptive/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// Finds the wide places of one connected legal area. Radii are those of the material cleared there.
class EntryRegionFinder {
 public:
  /// `front`: where the centre may be while it clears. `start`: where the first entry is asked for.
  EntryRegionFinder(const Region& front, const Clearance& clearance, const RemainingStock& remaining,
                    const Layer& layer, double limit, std::optional<Vec2> start);

  /// The widest places, each worth an entry of its own.
  std::vector<Disc> choose() const;
  /// The widest place where the centre has never been.
  std::optional<Disc> widest_uncut() const;
  /// Radius of the widest hole about a place, mm; 0 or less where there is none.
  double hole_at(Vec2 place) const;

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

/// The entry region whose rim is nearest to p (deepest around it). `entry_regions` holds at least one.
std::size_t nearest_entry_region(const std::vector<Disc>& entry_regions, Vec2 p);

}  // namespace clearcut::plan::adaptive
