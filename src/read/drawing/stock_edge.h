// The material that a drawing names, and outlines that reach its edge: they are open there.
#pragma once

#include <vector>

#include "base/tolerances.h"
#include "model/part.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {

/// Gives the part the block that outlines of the role stock bound, if there are any: down to their depth, else that of the
/// deepest feature, of which there must be one.
void set_stock(Part& part, const std::vector<ShapedGroup>& groups, const std::vector<Feature>& features,
               const ReadOptions& options);

/// Lets the cutter of every feature of a drawing or outline that reaches part.stock's edge, and of which nothing says where
/// else the cutter may go, run out over that edge: there is no wall. What lies beside the stock is no target. Does nothing
/// without a stock. Cost one boolean a feature that reaches the edge.
void open_at_stock_edge(Part& part, const Tolerances& tol);

}  // namespace clearcut::read
