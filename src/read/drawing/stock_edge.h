// The stock named in a drawing, and outlines reaching its edge: they are open there.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {

/// Gives the part the block bounded by outlines of the role stock, if there are any: down to their depth, else the
/// depth of the deepest feature; there must be one.
void set_stock(Part& part, const std::vector<ShapedGroup>& groups, const std::vector<Feature>& features,
               const ReadOptions& options);

/// Lets the cutter of every feature of a drawing or outline that reaches part.stock's edge, without another stated
/// permitted area, run out over this edge: there is no wall. Areas beside the stock are no target. Does nothing
/// without a stock. Cost: one boolean for each feature that reaches the edge.
void open_at_stock_edge(Part& part, const Tolerances& tol);

}  // namespace clearcut::read
