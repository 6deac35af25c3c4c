// The part of an outline in the stock: there is no material to cut outside.
#pragma once

#include <optional>

#include "geometry/region.h"

namespace clearcut::verify {

/// The part of `target` in the stock; the whole target if no stock is given, or if no part of the target is beyond
/// the edge. Boundaries of the result may run to and fro along the stock's edge; this changes neither areas nor
/// winding numbers.
///
/// Method  Every point beyond the stock moves to the nearest one on its edge: a boundary then winds around each point
/// within
///         as often as before. O(edges), exact up to rounding.
Regions within_stock(const Regions& target, const std::optional<Box>& stock);

}  // namespace clearcut::verify
