// Round holes: straight down with a tool of their size, or along a helix with a smaller mill.
#pragma once

#include "link/link.h"

namespace clearcut::link {

/// What is to be taken out: a cylinder about `center` from z_top down to z. mm.
struct HoleWork {
  Vec2 center;
  double radius = 0;  ///< of what may be cut: the hole less the stock to leave
  double z_top = 0;
  double z = 0;
};

/// Over the centre, down in pecks of at most `peck` mm with a rise to above_material between them to clear the
/// chips, and out again: moves that a post can write as one drilling cycle. One peck where `peck` reaches.
Section drill_hole(const HoleWork& hole, double peck, const LinkOptions& options);

/// mm. How far above the last depth a drill feeds again after a rise (what LinuxCNC's own cycle does).
inline constexpr double kPeckGap = 0.254;

/// Whether a helix along the wall leaves nothing in the middle and is wide enough to be worth its turns.
bool can_bore(const HoleWork& hole, double tool_radius);

/// Along the wall down a helix no steeper than the entry angle and dropping at most `stepdown` a turn, once round at
/// the depth, to the middle and out. Climb or conventional as the options say.
Section bore_hole(const HoleWork& hole, double stepdown, const LinkOptions& options);

}  // namespace clearcut::link
