// Joins the passes of all layers of one feature into one section of moves.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "part/part.h"
#include "toolpath/machine.h"
#include "toolpath/pass.h"

namespace clearcut {

struct LinkOptions {
  double tool_radius = 0;     ///< mm
  double safe_z = 10;         ///< where rapids cross the work, absolute
  double above_material = 1;  ///< mm over the material where a rapid down ends and the plunge begins
  CutDirection direction = CutDirection::kClimb;
  bool spindle_clockwise = true;
  MmPerMin feed = MmPerMin::of(1000);
  MmPerMin plunge_feed = MmPerMin::of(300);
  MmPerMin ramp_feed = MmPerMin::of(500);
  EntryKind entry = EntryKind::kPlunge;
  Radians entry_angle = Radians::of_degrees(3);
  /// Plan view of the raw block: outside it there is only air. Absent: solid everywhere outside the targets.
  std::optional<Box> stock;
  Machine machine;  ///< decides between staying down and lifting
};

/// All moves of one feature, layers from the top down.
///
/// Order     inside-out within each connected legal area (rings before the ring that surrounds them), nearest
/// first. Links     down at depth where the straight way or a way along the legal boundary stays in the legal
/// area and is
///           quicker than lifting, else up to safe_z; a rapid never touches material: it comes down to
///           `above_material` over the layer's top, or outside the stock, or into what earlier layers
///           cleared.
/// Direction region loops as oriented are climb for a clockwise spindle; passes that are not reversible keep
/// theirs. Shape     section.moves begins at safe_z over the first pass and ends at safe_z; empty when no
/// layer has a pass.
///           Label, workingstep and tool number are left to the caller.
/// Cost      O(passes^2 + links * edges near them).
Section link_layers(const std::vector<LayerPasses>& layers, const LinkOptions& options,
                    const Tolerances& tol);

}  // namespace clearcut
