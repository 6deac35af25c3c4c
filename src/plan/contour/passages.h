// Passages from contour to contour along a corner's bisector, as the published methods run them.
#pragma once

#include "model/pass.h"
#include "plan/contour/contour.h"

namespace clearcut::plan::contour {

/// Joins rings of which each surrounds just one other into one pass: once round each ring, beginning and ending at one corner,
/// then along the bisector of that corner to the next ring. It is the sharpest corner of the ring at the wall; where that
/// corner has vanished farther in, the passage goes to the nearest place of the ring. Rings stay as they are
/// where they surround several, or where the passage would leave the legal area.
///
/// Shape   passes from the innermost ring outwards, or inwards where options.outside_in; parents of
///         all passes are the joined passes that hold them. Single passages that a joined pass contains are dropped.
/// Source  CPO-kappa eq. 1 and 3, M = H / sin(alpha / 2); CPO-rho eq. 6 and 7; see docs/texts.md.
void join_along_bisectors(LayerPasses& layer, const ContourOptions& options);

}  // namespace clearcut::plan::contour
