// Joins the passes of all layers of one feature into one section of moves.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "link/lead.h"
#include "model/machine.h"
#include "model/part.h"
#include "model/pass.h"

namespace clearcut::link {

struct LinkOptions {
  double tool_radius = 0;  ///< mm
  double safe_z = 10;      ///< absolute; where the section begins and ends
  double cross_z =
      10;  ///< where rapids cross between its passes, over all that stands; no higher than safe_z
  double above_material = 1;  ///< mm over the material where a rapid down ends and the plunge begins
  CutDirection direction = CutDirection::kClimb;
  bool spindle_clockwise = true;
  MmPerMin feed = MmPerMin::of(1000);
  MmPerMin plunge_feed = MmPerMin::of(300);
  MmPerMin ramp_feed = MmPerMin::of(500);
  std::optional<MmPerMin> lead_feed;  ///< arcs and lines into and out of passes; absent: feed
  std::optional<MmPerMin>
      link_feed;  ///< links at depth through what is cleared; absent: feed, or rapid within a pass
  EntryKind entry = EntryKind::kPlunge;
  Radians entry_angle = Radians::of_degrees(3);
  std::optional<double> helix_widest;      ///< mm, diameter of the centre's circle; absent: 0.9 of the tool's
  std::optional<double> helix_narrowest;   ///< mm; absent: 0.2 of the tool's diameter
  bool may_plunge = true;                  ///< false: straight down is the last resort, and noted
  double zigzag_length = 0;                ///< mm of one stroke of a zigzag ramp; 0: up to two diameters
  LeadShape lead;                          ///< of size 0: passes along walls begin and end on the wall
  double link_lift = 0;                    ///< mm; links at depth run this much higher
  std::vector<PredrilledHole> predrilled;  ///< holes through which a cutter no wider than they are goes down
  /// Plan view of the raw block: outside it there is only air. Absent: solid everywhere outside the targets.
  std::optional<Box> stock;
  Machine machine;  ///< decides between staying down and lifting
};

/// All moves of one feature, layers from the top down.
///
/// Entries   see link/entry.h; from beside the stock or down a predrilled hole where a legal path leads in.
/// Leads     passes along walls of closed pockets begin and end with an arc or a line, see link/lead.h, and run on over
///           their start by lead.overlap, which goes without leads, too. What could not be done as asked is told
///           in section.notes.
/// Order     rings before the ring that surrounds them; a place before what is under it. Layer by layer, always what
///           is reached soonest; the same over all layers, which cuts one area after the other to the bottom; and
///           both improved (link/short_order.h): the fastest of these, the first where it makes no difference.
/// Links     down at depth where the straight path stays in the legal area and is quicker than lifting, else by rapids
///           just over the layer where that path is legal and nothing stands in it, else at cross_z. A rapid never
///           touches material: it comes down to `above_material` over the layer's top, or outside the stock, or
///           into what earlier layers cleared.
/// Direction region loops as oriented are climb for a clockwise spindle; passes that are not reversible keep
///           theirs.
/// Shape     section.moves begins at safe_z over the first pass and ends at safe_z; empty when no layer has a pass.
///           Label, workingstep and tool number are left to the caller.
/// Cost      O(passes^2 + links * edges near them), and the order's.
Section link_layers(const std::vector<LayerPasses>& layers, const LinkOptions& options,
                    const Tolerances& tol);

}  // namespace clearcut::link
