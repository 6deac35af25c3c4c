// Ways down into material: helix, ramp, plunge.
#pragma once

#include <optional>
#include <vector>

#include "link/link.h"
#include "toolpath/legal_area.h"
#include "toolpath/move.h"

namespace clearcut {

/// Where a pass begins and what is known about the way to it.
struct EntryPlace {
  Vec2 start;                         ///< first point of the pass
  Vec2 direction;                     ///< unit, in which the pass begins
  double z_above = 0;                 ///< height where the material is met (and a little more)
  double z = 0;                       ///< depth of the pass
  std::optional<Vec2> circle_center;  ///< the pass begins by circling this point once
};

/// The moves from (start, z_above) down to (start, z), all inside `legal`.
///
/// Helix    about circle_center, else a circle that touches `direction` at the start, of 0.45 diameter and
/// less while it
///          does not fit (down to 0.1), no steeper than the entry angle, with a flat circle at the end; where
///          none fits: ramp.
/// Ramp     to and fro along the beginning of the pass, at most two diameters of it; where nothing fits:
/// plunge. Plunge   straight down. Cost     O(edges near the entry).
std::vector<Move> entry_moves(const EntryPlace& place, const Regions& legal, const LinkOptions& options);

}  // namespace clearcut
