// Outlines that reach the edge of the material are open there.
#pragma once

#include "base/tolerances.h"
#include "model/part.h"

namespace clearcut::read {

/// Lets the cutter of every feature of a drawing or outline that reaches part.stock's edge, and of which nothing says where
/// else the cutter may go, run out over that edge: there is no wall. What lies beside the stock is no target. Does nothing
/// without a stock. Cost one boolean a feature that reaches the edge.
void open_at_stock_edge(Part& part, const Tolerances& tol);

}  // namespace clearcut::read
