// What of an outline lies in the stock: beside it there is nothing to cut.
#pragma once

#include <optional>

#include "geometry/region.h"

namespace clearcut::verify {

/// The part of `target` in the stock; all of it where no stock is given, or where none of it lies beyond the edge. Boundaries
/// of the result may run to and fro along the stock's edge, which changes neither areas nor winding numbers.
///
/// Method  Every point beyond the stock moves to the nearest one on its edge: a boundary then winds around each point within
///         as often as before. O(edges), exact up to rounding.
Regions within_stock(const Regions& target, const std::optional<Box>& stock);

}  // namespace clearcut::verify
