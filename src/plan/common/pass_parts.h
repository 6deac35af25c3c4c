// Replaces passes of a layer by parts of them.
#pragma once

#include <vector>

#include "model/layer.h"

namespace clearcut::plan {

/// Gives the layer, instead of each of its passes, the parts in `parts`, which may be none. What is left of a pass follows all
/// that the pass followed; what waited for a pass without parts waits for what that pass waited for.
void replace_passes(LayerPasses& layer, std::vector<std::vector<Pass>> parts);

/// The stretches of a path inside `where`, in their order; the whole path if it is wholly inside. A closed path's stretch over its
/// beginning is one.
std::vector<Path> stretches_inside(const Path& path, bool closed, const Regions& where);

}  // namespace clearcut::plan
