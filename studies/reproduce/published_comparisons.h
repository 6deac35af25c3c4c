// The papers' comparisons of methods, beside ours. Their outlines are not printed: ours stand in, and the tables say so.
#pragma once

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// CPO-kappa table 1: lengths of the proposed method, of bisector segments and of loops on a concave and a convex outline.
Reproduction length_comparison();

/// CPO-rho table 3: cutting times (eq. 9) of eleven cutters on a polygon of inscribed radius 20.46 mm.
Reproduction cutter_comparison();

/// The same, which is faster at which feed.
Reproduction cutter_trend();

}  // namespace clearcut::studies
