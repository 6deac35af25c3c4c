// Joins the passes of all layers of one feature into one section of moves.
#pragma once

#include <optional>
#include <vector>

#include "base/tolerances.h"
#include "link/lead.h"
#include "model/layer.h"
#include "model/machine.h"
#include "model/part.h"

namespace clearcut::link {

struct LinkOptions {
  double tool_radius = 0;  ///< mm
  double safe_z = 10;      ///< mm, absolute; height at which the section begins and ends
  /// mm, absolute; height of rapids between passes, above all remaining material; at most safe_z.
  double cross_z = 10;
  double above_material = 1;  ///< mm above the material at which a rapid down ends and the plunge begins
  /// mm; distance of a cutter's rim from the raw block during a rapid down beside it.
  double beside_stock = 1;
  CutDirection direction = CutDirection::kClimb;
  bool spindle_clockwise = true;
  MmPerMin feed = MmPerMin::of(1000);
  MmPerMin plunge_feed = MmPerMin::of(300);
  MmPerMin ramp_feed = MmPerMin::of(500);
  std::optional<MmPerMin> lead_feed;  ///< feed of arcs and lines into and out of passes; absent: `feed`
  /// Feed of links at depth through cleared areas. Absent: `feed`; for links within a pass the rapid feed.
  std::optional<MmPerMin> link_feed;
  EntryKind entry = EntryKind::kPlunge;
  Radians entry_angle = Radians::of_degrees(3);
  std::optional<double> helix_widest;     ///< mm, diameter of the centre's circle; absent: 0.9 of the tool's
  std::optional<double> helix_narrowest;  ///< mm; absent: 0.2 of the tool's diameter
  bool may_plunge = true;                 ///< false: straight down only if nothing else fits, and then noted
  double zigzag_length = 0;  ///< mm; length of one stroke of a zigzag ramp; 0: up to two tool diameters
  LeadShape lead;            ///< with size 0 passes along walls begin and end on the wall
  double link_lift = 0;      ///< mm by which links at depth are higher than their passes
  std::vector<PredrilledHole> predrilled;  ///< holes in which a cutter no wider than the hole may descend
  /// Plan view of the raw block; outside it there is no material. Absent: material everywhere outside the
  /// targets.
  std::optional<Box> stock;
  Machine machine;  ///< machine whose times decide between links at depth and retract links
};

/// All moves of one feature, layers from the top down.
///
/// Entries   See link/entry.h; from beside the stock or down a predrilled hole if a legal path leads from
///           there.
/// Leads     Passes along walls of closed pockets begin and end with an arc or a line, see link/lead.h, and continue
///           beyond their start by lead.overlap, with or without leads. Requests that could not be fulfilled are
///           listed in section.notes.
/// Order     Rings before the ring around them, higher layers before the layers below. These orders are compared:
///           layer by layer, always the pass that is reached soonest; the same over all layers, clearing one area
///           after the other down to the bottom; and both improved (link/linker.h). The fastest is taken, the
///           first if they are equal.
/// Links     At depth if the straight path is legal and quicker than a retract link. Else by rapids just
///           above the layer, if that path is legal and free of material, else at cross_z. A rapid never
///           touches material: it comes down to above_material over the top of the layer, outside the stock, or into
///           volumes cleared by earlier layers.
/// Direction Loops as oriented in their regions are climb for a clockwise spindle; passes that are not
///           reversible keep their direction.
/// Shape     section.moves begins and ends at safe_z; empty if no layer has a pass. The caller sets label,
///           workingstep and tool number.
/// Cost      O(passes^2 + links * edges near them), and the cost of the orders.
Section link_layers(const std::vector<LayerPasses>& layers, const LinkOptions& options,
                    const Tolerances& tol);

}  // namespace clearcut::link
