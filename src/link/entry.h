// Paths down into material: helix, ramp, plunge.
#pragma once

#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"
#include "link/link.h"
#include "model/move.h"

namespace clearcut::link {

/// Where a pass begins, and what is known about the material over it. mm.
struct EntryPlace {
  Vec2 start;                         ///< first point of the pass
  Vec2 direction;                     ///< unit, in which the pass begins
  double z_above = 0;                 ///< height where the material is met (and a little more)
  double z = 0;                       ///< depth of the pass
  std::optional<Vec2> circle_center;  ///< the pass begins by circling this point once
  const Path* ring = nullptr;         ///< the whole pass from its start, where it is closed
};

/// The moves of one entry.
struct Entry {
  std::vector<Move> moves;
  EntryKind kind = EntryKind::kPlunge;
  /// mm. How far along the ring the depth is reached: there it has to be begun. 0: at its start.
  double along_ring = 0;
};

/// The moves from z_above down to the pass, all inside `legal`; they begin at or beside its start. The first of these
/// kinds that fits, beginning with the one asked for:
///
/// Helix    about circle_center, else about a centre beside the start so that it touches `direction`, as wide as
///          options.helix_widest and less while it does not fit, down to helix_narrowest; no steeper than the
///          entry angle, at least once round, with a flat circle at the end.
/// Ramp     along the ring, at the entry angle, as far as that takes (a few times round at most).
/// Zigzag   to and fro along the beginning of the pass, zigzag_length of it, less where that does not fit.
/// Plunge   straight down.
///
/// Cost     O(edges near the entry).
Entry entry_at(const EntryPlace& place, const Regions& legal, const LinkOptions& options);

}  // namespace clearcut::link
