// Passages from contour to contour along a corner's bisector, as the published methods run them.
#pragma once

#include "model/pass.h"
#include "plan/contour/contour.h"

namespace clearcut::plan::contour {

/// Joins rings that each surround exactly one other ring into one pass: once round each ring, beginning and ending at
/// one corner, then along the bisector of that corner to the next ring. This is the sharpest corner of the ring at
/// the wall; if that corner has vanished farther in, the passage leads to the nearest place of the ring. Rings are
/// unchanged if they surround several rings, or if the passage would leave the legal area.
///
/// Shape   passes from the innermost ring outwards, or inwards if options.outside_in; parents of all passes are the
///         joined passes around them. Single passages contained in a joined pass are dropped.
/// Source  CPO-kappa eq. 1 and 3, M = H / sin(alpha / 2); CPO-rho eq. 6 and 7; see docs/texts.md.
void join_along_bisectors(LayerPasses& layer, const ContourOptions& options);

}  // namespace clearcut::plan::contour
