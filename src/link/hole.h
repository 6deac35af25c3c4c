// Round holes: drilled with a tool of their size, or bored along a helix with a smaller mill.
#pragma once

#include "link/link.h"
#include "model/part.h"

namespace clearcut::link {

/// The volume to remove: a cylinder about `center` from z_top down to z. mm.
struct HoleWork {
  Vec2 center;
  double radius = 0;  ///< radius of the cut: that of the hole less the stock to leave
  double z_top = 0;
  double z = 0;
};

/// Moves over the centre, down in pecks of at most `peck` mm with a retract to above_material between them to
/// clear the chips, and out again; a post can write these moves as one drilling cycle. One peck if `peck` is
/// as deep as the hole. `feeds`: other feeds at the beginning and the end of the hole, and for the retract.
Section drill_hole(const HoleWork& hole, double peck, const LinkOptions& options,
                   const HoleFeeds& feeds = {});

/// The same, but each peck only breaks the chip: the drill rises by kPeckGap and stays in the hole.
Section chip_hole(const HoleWork& hole, double peck, const LinkOptions& options);

/// Down at the plunge feed and out of the hole at the same feed, for reamers, boring bars and taps. (The spindle
/// reverses to retract a tap; these moves do not contain the reversal.)
Section feed_out_hole(const HoleWork& hole, const LinkOptions& options);

/// mm above the last depth, at which a drill begins to feed again after a retract; LinuxCNC's own cycle has the
/// same value.
inline constexpr double kPeckGap = 0.254;

/// Whether a helix along the wall leaves nothing in the middle, where the flat end of the tool clears the floor, and is wide enough to be
/// quicker than a plunge.
bool can_bore(const HoleWork& hole, double tool_radius, double flat);

/// Descends along the wall on a helix no steeper than the entry angle and at most `stepdown` mm deeper in
/// each turn, once round at the depth, to the middle and out. Climb or conventional as in `options`.
Section bore_hole(const HoleWork& hole, double stepdown, const LinkOptions& options);

}  // namespace clearcut::link
