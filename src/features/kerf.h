// The kerf: the strip cleared by a cutter following a contour.
#pragma once

#include <set>

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::features {

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

}  // namespace clearcut::features
