// What earlier workingsteps have left of a feature.
#pragma once

#include "base/tolerances.h"
#include "part/part.h"

namespace clearcut {

/// The part of `target` over which material still stands above `z` when workingstep `index` begins: `target` without
/// the targets of other features that earlier workingsteps have cut to `z` or deeper, leaving no stock.
///
/// Corners that an earlier cutter could not reach count as cut: they are the same corners for a cutter of its size.
/// Cost  one boolean per earlier feature that overlaps `target`.
Regions standing_above(const Part& part, int index, const Regions& target, double z, const Tolerances& tol);

}  // namespace clearcut
