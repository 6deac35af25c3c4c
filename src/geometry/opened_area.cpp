#include "geometry/opened_area.h"

#include "base/units.h"

namespace clearcut::inline geometry {

double area_within(const Regions& regions, double d) {
  double sum = 0;
  for (const Region& region : regions) {
    sum += signed_area(region.outer()) + kPi * d * d * (1 - static_cast<double>(region.islands().size()));
    for (const Loop& island : region.islands()) sum += signed_area(island);
    for (const Edge& edge : region.edges()) sum += d * edge.length();
  }
  return sum;
}

bool is_opened_at_corners_only(const Region& region, const Regions& inset) {
  return inset.empty() || (inset.size() == 1 && inset.front().islands().size() == region.islands().size());
}

}  // namespace clearcut::inline geometry
