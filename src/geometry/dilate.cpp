// Growing is shrinking the complement: each region's outside is a pocket in a large box with the region as
// its island, each of its islands is a pocket of its own.
#include "base/error.h"
#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "geometry/rectangle.h"
#include "geometry/unite_all.h"

namespace clearcut::inline geometry {
namespace {

Region dilated(const Region& region, double d, const Tolerances& tol) {
  const Loop frame = rectangle(region.box().grown(3 * d + 1));
  const Region outside = Region::from_valid_loops(frame, {region.outer()});
  Loop outer;
  std::vector<Loop> islands;
  for (const Region& rest : inset(outside, d, tol)) {
    // The part along the frame goes around the grown region; all others are bays that have closed.
    if (rest.islands().empty()) {
      islands.push_back(rest.outer());
    } else {
      outer = rest.islands().front();
    }
  }
  for (const Loop& island : region.islands()) {
    for (const Region& rest : inset(Region::from_valid_loops(island, {}), d, tol))
      islands.push_back(rest.outer());
  }
  CLEARCUT_ASSERT(!outer.empty());
  return Region::from_valid_loops(std::move(outer), std::move(islands));
}

}  // namespace

Regions dilate(const Regions& regions, double d, const Tolerances& tol) {
  CLEARCUT_ASSERT(d >= 0);
  Regions grown;
  for (const Region& region : regions) grown.push_back(dilated(region, d, tol));
  if (grown.size() == 2) return unite({grown[0]}, {grown[1]}, tol);
  // One by one many would take quadratic time.
  return grown.size() < 2 ? grown : unite_all(grown, tol);
}

}  // namespace clearcut::inline geometry
