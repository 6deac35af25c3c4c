// The aerospace test part of [tour]: four faces, six pockets, two tools.
#pragma once

#include "model/part.h"

namespace clearcut::studies {

/// The fishhead, from a table of its dimensions: block 135 x 185 x 40 mm, faces 1..3, pockets 1..6, face 4 in
/// the order of [tour], feeds and speeds as there, 2 mm a layer, tops by stacking. `sloped`: the walls of
/// POCKET3 have a draft of 0.785 radians, scallops up to 0.5 mm. The boss in POCKET5 has the diameter 8.5 that is
/// printed, though 17 is likely meant (POCKET6, 14 wide, lies inside it). Source  [tour] appendix 9.1; see
/// docs/stepnc.md.
Part fishhead(bool sloped, const Tolerances& tol);

}  // namespace clearcut::studies
