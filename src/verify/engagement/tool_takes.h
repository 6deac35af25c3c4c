// Cutting ability of a kind of tool: the material removed for certain by the cutter of a move, the width of a ring of
// material at its rim, sideways and straight down, and required feeds.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "model/cutter_profile.h"
#include "stock/cutting_load.h"
#include "stock/material.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// The removal of its tool; cuts of earlier set-ups were made narrower, by the ends of their cutters, when they were
/// carried over, and count as cylinders.
stock::Removal removal_of(const CheckedMove& checked);

/// mm above the tip up to which a cutter removes material: above the disc of a T-slot cutter there is only its neck.
double height_of_edges(const Tool& tool);

/// mm. Width of the ring at a tool's rim permitted in material; infinite: the whole end of the tool.
struct ToolTakes {
  double sideways = HUGE_VAL;
  double down = HUGE_VAL;
  double lead = 0;  ///< mm over the tip for each mm from the axis: lower material does not count in descents
  double idle_tip = 0;     ///< radius of a flat tip that does not cut: it must not descend into material
  double idle_from = 1;    ///< mm down for each mm of advance from which on the flat tip counts
  bool feeds_out = false;  ///< the tool retracts from its hole at the feed
  const char* needs = "";  ///< precondition of a descent
  const char* says_sideways = "";  ///< description of a lateral fault, if the ring is not specific enough
};

/// The row of the tool's kind. The depth of threads is that of the part if greater than that of the tool's own pitch.
ToolTakes takes_of(const Tool& tool, const Part& part);

/// Material (in its state before the move) taken by a feed move beyond its tool's ability; also a retract from a hole
/// not at feed. `bottom`: the underside of the block, below which nothing stands.
///
/// Error   as of stock::Material; rings are measured to kTakenSliver.
std::optional<Overcut> overcut_of(const CheckedMove& checked, const ToolTakes& takes,
                                  const stock::Material& material, double bottom);

/// One sentence describing the fault, without its place.
std::string overcut_text(const CheckedMove& checked, const Part& part);

}  // namespace clearcut::verify
