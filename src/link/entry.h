// The moves of entries, down into material: helix, ramp, zigzag, plunge.
#pragma once

#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"
#include "link/link.h"
#include "model/move.h"

namespace clearcut::link {

/// The beginning of a pass, and the material above it. mm.
struct EntryPlace {
  Vec2 start;                         ///< first point of the pass
  Vec2 direction;                     ///< unit vector of the pass's first direction
  double z_above = 0;                 ///< height a little above the material
  double z = 0;                       ///< depth of the pass
  std::optional<Vec2> circle_center;  ///< the pass begins by circling this point once
  const Path* ring = nullptr;         ///< for closed passes: the whole pass from its start
  const Path* run = nullptr;          ///< path cut from the start on without interruption
  bool stays_on_run = false;          ///< there may be uncut material beside the pass
};

/// The moves of one entry.
struct Entry {
  std::vector<Move> moves;
  EntryKind kind = EntryKind::kPlunge;
  /// mm along the ring to the place where the depth is reached; the pass must begin at this place. 0: at its start.
  double along_ring = 0;
};

/// The moves from z_above down to the pass, all inside `legal`; they begin at or beside its start. Takes the first
/// fitting one of these kinds, beginning with the requested one:
///
/// Helix    About circle_center, regardless of the request, because after any other entry the circle of the pass
///          would be cut at full width; else about a centre beside the start so that the helix is tangent to
///          `direction`. As wide as options.helix_widest or, if that does not fit, narrower down to helix_narrowest;
///          no steeper than the entry angle, at least once round, with a level circle at the end.
/// Ramp     Along the ring at the entry angle, over the length needed, at most a few times around.
/// Zigzag   To and fro along the beginning of the pass on zigzag_length mm, or less if this length does not fit:
///          straight ahead or straight back; along the bends of the pass if the tool must stay on the pass, or if the
///          length available along the pass is more than twice as long.
/// Plunge   Straight down.
///
/// Cost     O(edges near the entry).
Entry entry_at(const EntryPlace& place, const Regions& legal, const LinkOptions& options);

}  // namespace clearcut::link
