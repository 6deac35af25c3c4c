// Engagement-limited clearing: a spiral in the widest place, then arcs that peel along the medial axis.
#pragma once

#include "base/tolerances.h"
#include "base/units.h"
#include "plan/layer.h"
#include "toolpath/pass.h"

namespace clearcut {

struct AdaptiveOptions {
  /// Largest angle of the cutter's circle in material while it cuts, after the entry.
  Radians engagement = Radians::of_degrees(60);
};

/// The passes of one layer with the cutter's engagement limited.
///
/// Shape   one open pass for each connected legal area (spiral, arcs, and links through what is cleared),
/// then the
///         closed wall passes at radius + wall_stock, which surround it. Empty where the cutter has no legal
///         position.
/// Error   engagement exceeds the limit only on the first circle of an entry, and where the legal area is
/// narrower
///         than a tenth of the radius: there nothing but a slot is possible.
/// Cost    O(discs * boundary edges); a disc every R (1 - cos(engagement)) or so along the medial axis.
/// Source  [elber2005]: circles of the medial axis; the step between them is solved for the engagement in
/// closed form.
LayerPasses plan_adaptive(const Layer& layer, const AdaptiveOptions& options, const Tolerances& tol);

}  // namespace clearcut
