// Proves quickly that other edges clear what only the corner of a path had cleared on its outer side.
#pragma once

#include <span>

#include "geometry/edge.h"

namespace clearcut::plan {

/// mm. The rim is tested this far inside, since its own edges clear it no deeper.
inline constexpr double kAtRim = 1e-6;

/// Whether `edges` clear the rim, on the outer side, of the area that two successive straight pieces clear within `radius` mm, and all
/// places within `deep` mm inside of this rim. May return false although they do.
///
/// Where another path from the beginning of `first` to the end of `second` deviates from both pieces by less than `deep` to the inner
/// side of their turn, places that it leaves are nearer than `deep` to the rim: then nothing is left. With a smaller `deep`, an
/// uncleared place inside of the rim is a hole with a complete border, found by an exact check (Cover::has_hole).
bool clear_outer_rim(const Edge& first, const Edge& second, std::span<const Edge> edges, double radius,
                     double deep);

}  // namespace clearcut::plan
