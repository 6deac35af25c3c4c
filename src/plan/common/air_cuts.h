// Takes out of the passes of a layer what cuts nothing: stretches in the air, and over what other passes clear.
#pragma once

#include <optional>

#include "base/units.h"
#include "model/layer.h"
#include "plan/common/machine_clock.h"

namespace clearcut::plan {

struct AirCutJob {
  double radius = 0;  ///< radius of the cutter, mm
  MmPerMin feed;
  const RetractLink* retract = nullptr;  ///< the links between what is left of a pass
  bool keeps_direction = false;          ///< what is left of a ring is cut in the ring's direction
  /// Whether a pass may go because others clear the same; else, as where the distance of passes is asked for, only what clears nothing
  /// of the target goes.
  bool takes_overlaps = true;
  /// Share of the length of the passes. If more stays, the passes stay as they are.
  double most_left = 1;
};

/// The layer with shorter passes that clear the same places of its target; nothing if no pass gets shorter.
///
/// Method  Passes are divided into short pieces, each with the witness points that it clears: a raster of the target
///         and points along its boundary. A stretch may go if every witness is cleared by a piece outside of the stretch. Passes
///         with the least share of pieces that no other pass replaces come first: they go wholly, lose their ends, or are parted
///         where a link is quicker than the stretch. An exact check (plan/common/cover.h) then finds what is left between
///         the witnesses, which becomes witnesses, and all is begun anew.
/// Shape   Passes keep their sequence: what is left of a ring follows all passes that the ring followed. A ring that loses a
///         stretch is an open pass from then on. Passes with edges of several kinds stay as they are.
/// Error   Every place of the target within the cutter's reach of the passes before is within it afterwards.
/// Cost    O(rounds * pieces * witnesses of each).
std::optional<LayerPasses> without_air_cuts(const LayerPasses& layer, const AirCutJob& job);

}  // namespace clearcut::plan
