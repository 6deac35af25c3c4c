// The strip that a cutter leaves empty when it follows a contour.
#pragma once

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::stock {

/// Everything within `width` mm of the profile's outline on its free side; for a line to engrave everything within half of
/// that on both sides. Cost that of an offset of the outline.
Regions kerf_of(const ProfileCut& cut, double width, const Tolerances& tol);

}  // namespace clearcut::stock
