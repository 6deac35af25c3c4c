// The moves of entries, down into material: helix, ramp, zigzag, plunge.
#pragma once

#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"
#include "link/link.h"
#include "model/move.h"

namespace clearcut::link {

/// Where a pass begins, and the material above it. mm.
struct EntryPlace {
  Vec2 start;                         ///< first point of the pass
  Vec2 direction;                     ///< unit vector along which the pass begins
  double z_above = 0;                 ///< height a little above the material
  double z = 0;                       ///< depth of the pass
  std::optional<Vec2> circle_center;  ///< the pass begins by circling this point once
  const Path* ring = nullptr;         ///< for closed passes: the whole pass from its start
  const Path* run = nullptr;          ///< what is cut from the start on, all of it in one go
  bool stays_on_run = false;          ///< beside the pass something may stand that no earlier one has cut
};

/// The moves of one entry.
struct Entry {
  std::vector<Move> moves;
  EntryKind kind = EntryKind::kPlunge;
  /// mm along the ring at which the depth is reached, so that the pass has to begin there; 0: at its start.
  double along_ring = 0;
};

/// The moves from z_above down to the pass, all inside `legal`; they begin at or beside its start. Takes the
/// first of these kinds that fits, beginning with the one asked for:
///
/// Helix    About circle_center, whatever is asked for, because the circle of the pass would be cut at full width after any other
///          entry; else about a centre beside the start so that the helix touches `direction`.
///          As wide as options.helix_widest and, while it does not fit, narrower down to helix_narrowest; no
///          steeper than the entry angle, at least once round, with a level circle at the end.
/// Ramp     Along the ring at the entry angle, as far as that takes, a few times round at most.
/// Zigzag   To and fro along the beginning of the pass on zigzag_length mm, or less if that does not fit: straight on or straight
///          back, or along its bends where it has to stay on the pass, or that way is more than twice as long.
/// Plunge   Straight down.
///
/// Cost     O(edges near the entry).
Entry entry_at(const EntryPlace& place, const Regions& legal, const LinkOptions& options);

}  // namespace clearcut::link
