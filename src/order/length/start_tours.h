// Tours to begin a search with.
#pragma once

#include <vector>

#include "base/random.h"
#include "order/length/length_model.h"

namespace clearcut::order {

/// Shortest candidate edges first, as long as they close no early circle and leave no branching; the
/// fragments are then joined end to nearest end [bentley1992]. About 16-20 % above the optimum. O(n log n).
/// `noise` > 0 multiplies each edge by a random factor in [1, 1 + noise].
std::vector<int> greedy_tour(const LengthModel& model, double noise, Random& random);

std::vector<int> random_tour(const LengthModel& model, Random& random);

}  // namespace clearcut::order
