// What a kind of tool can take: how wide a ring of material at its rim, sideways and straight down, and what it must feed.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "model/cutter_profile.h"
#include "stock/material.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// mm. A ring at a tool's rim that may be in material; infinite: all of the tool's end may be.
struct ToolTakes {
  double sideways = HUGE_VAL;
  double down = HUGE_VAL;
  double lead =
      0;  ///< mm over the tip for each mm from the axis: what stands lower does not count on the way down
  double idle_tip = 0;     ///< radius of a flat tip that does not cut: it may not go down into material
  double idle_from = 1;    ///< mm down for each mm of advance from which on that tip counts
  bool feeds_out = false;  ///< it comes out of its hole at the feed
  const char* needs = "";  ///< what has to be there before it goes down
  const char* says_sideways = "";  ///< what it did wrong sideways, where its ring does not tell
};

/// The row of the tool's kind. Threads deeper than the tool's own pitch says are those of the part.
ToolTakes takes_of(const Tool& tool, const Part& part);

/// What a feed move takes of the material, as it stands before the move, that its tool cannot; and a way out of a hole that is no feed.
///
/// Error   Material is what stock::Material takes for material; rings are measured to kTakenSliver.
std::optional<Overcut> overcut_of(const CheckedMove& checked, const ToolTakes& takes,
                                  const stock::Material& material);

/// One sentence on what went wrong, without its place.
std::string overcut_text(const CheckedMove& checked, const Part& part);

}  // namespace clearcut::verify
