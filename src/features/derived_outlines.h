// Outlines that follow from those of features: at a depth under draft, the kerf cleared by a cutter that follows a
// contour, and the distance of a cutter from the raw block.
#pragma once

#include <algorithm>
#include <cmath>
#include <set>

#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/region.h"
#include "model/part.h"

namespace clearcut::features {

/// The outline `below_top` mm under the top of a feature whose outline at the top is `regions` and whose
/// walls have the draft `wall_slope`: `regions` inset by below_top * tan(wall_slope).
Regions at_depth(const Regions& regions, Radians wall_slope, double below_top, const Tolerances& tol);

/// All points within `width` mm of the profile's outline on its free side; for a line to engrave, all points
/// within half of that on both sides. Costs one offset of the outline.
Regions kerf_of(const ProfileCut& cut, double width, const Tolerances& tol);

/// The profiles of the part, as indices of features, that go through the material. A line followed by the cutter's
/// centre goes through if it reaches the underside of the stock; if no stock is stated, the underside of the other
/// profiles, else the lowest floor.
std::set<int> profiles_through(const Part& part);

/// Whether the piece inside the feature may come free: true for profiles on one side of their outline, and for closed
/// lines followed down to the underside of the stated stock.
bool may_free(const Feature& feature, const Part& part);

/// Makes `feature` a profile along `cut`. Until a cutter is chosen its areas are those of a kerf 0.1 mm wide.
void follow(Feature& feature, ProfileCut cut, const Tolerances& tol);

/// mm; distance of a cutter's rim from the sawn block if the cutter descends beside the block: its radius, within
/// usual limits.
inline double clear_of_raw_stock(double radius) {
  constexpr double kLeast = 1, kMost = 2;
  return std::clamp(radius, kLeast, kMost);
}

/// mm by which a cutter keeps farther off a wall with a fillet of radius `fillet` at its foot than off one without, its tip `above` mm over
/// the floor: its corner, an arc of radius `corner` (0: sharp), then just touches the fillet.
inline double clear_of_fillet(double fillet, double corner, double above) {
  const double apart = fillet - corner;  // of the centres of both arcs
  if (apart <= above) return 0;
  const double across = apart - std::max(0.0, above);
  return apart - std::sqrt(apart * apart - across * across);
}

}  // namespace clearcut::features
