// Growing is shrinking the complement: each region's outside is a pocket in a large box with the region as
// its island, each of its islands is a pocket of its own.
#include <optional>
#include <utility>

#include "base/error.h"
#include "geometry/contours/boolean.h"
#include "geometry/gaps/unite_over_gaps.h"
#include "geometry/region.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::inline geometry {
namespace {

/// mm. Edges up to this length make corners in which outlines of a boolean may cross by its rounding.
constexpr double kShortEdge = 0.001;

std::optional<Region> grown(const Region& region, double d, const Tolerances& tol) {
  const Loop frame = rectangle(region.box().grown(3 * d + 1));
  const Region outside = Region::from_valid_loops(frame, {region.outer()});
  Loop outer;
  std::vector<Loop> islands;
  for (const Region& rest : inset(outside, d, tol)) {
    // The part along the frame goes around the grown region; all other parts are closed bays.
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
  if (outer.empty()) return std::nullopt;
  return Region::from_valid_loops(std::move(outer), std::move(islands));
}

/// The region within tol.chord in straight lines that do not cross.
Regions straightened(const Region& region, const Tolerances& tol) {
  std::vector<Loop> loops{loop_from_points(flattened(region.outer(), tol.chord))};
  for (const Loop& island : region.islands()) loops.push_back(loop_from_points(flattened(island, tol.chord)));
  return without_short_edges(resolve_nonzero(loops, tol), kShortEdge);
}

void add_dilated(const Region& region, double d, const Tolerances& tol, Regions& all) {
  if (std::optional<Region> whole = grown(region, d, tol)) return all.push_back(std::move(*whole));
  // The result of a boolean may cross itself in acute corners, by rounding.
  for (const Region& piece : straightened(region, tol)) {
    std::optional<Region> whole = grown(piece, d, tol);
    CLEARCUT_ASSERT(whole);
    all.push_back(std::move(*whole));
  }
}

}  // namespace

Regions dilate(const Regions& regions, double d, const Tolerances& tol) {
  CLEARCUT_ASSERT(d >= 0);
  Regions all;
  for (const Region& region : regions) add_dilated(region, d, tol, all);
  if (all.size() == 2) return unite({all[0]}, {all[1]}, tol);
  // One by one many would take quadratic time.
  return all.size() < 2 ? all : unite_all(all, tol);
}

}  // namespace clearcut::inline geometry
