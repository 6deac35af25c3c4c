// The first population: nearest-neighbour paths from random points, with few common edges (Tour 4.3.2, fig. 4-13).
#pragma once

#include <vector>

#include "order/genetic/operator_context.h"

namespace clearcut::order {

/// From a random point (or the fixed start) on, the next point is drawn among the `breadth` nearest unused
/// neighbours; if all neighbours are used, the nearest unused point is taken. Keeps ends and precedence.
/// `breadth` 1 is the plain nearest-neighbour path of 3.6.1; equally near points come by their index. O(n) and
/// O(n) more at each dead end.
Tour nearest_path(const OperatorContext& context, int breadth, Random& random);

/// `count` valid individuals. An individual sharing more than `most_shared` of its edges with an earlier one is
/// replaced by a new one from another point; good paths always share more on lattices, so after ten the least similar
/// is taken.
std::vector<Genome> first_population(const OperatorContext& context, int count, double most_shared,
                                     int breadth, Random& random);

}  // namespace clearcut::order
