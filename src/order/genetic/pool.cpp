#include "order/genetic/pool.h"

#include <algorithm>
#include <numeric>

namespace clearcut::order {

Pool::Pool(std::vector<Individual> individuals, bool closed)
    : closed_(closed),
      individuals_(std::move(individuals)),
      ranked_(individuals_.size()),
      values_(individuals_.size()),
      known_(individuals_.size() * individuals_.size(), Known::kNo) {
  std::iota(ranked_.begin(), ranked_.end(), 0);
  rank();
}

/// Insertion sort: after a replacement only one is out of place.
void Pool::rank() {
  const auto is_before = [&](int a, int b) {
    return at(a).value < at(b).value || (at(a).value <= at(b).value && a < b);
  };
  for (std::size_t i = 1; i < ranked_.size(); ++i) {
    for (std::size_t j = i; j > 0 && is_before(ranked_[j], ranked_[j - 1]); --j)
      std::swap(ranked_[j], ranked_[j - 1]);
  }
  for (std::size_t i = 0; i < ranked_.size(); ++i) values_[i] = at(ranked_[i]).value;
}

double Pool::mean_value() const {
  return std::accumulate(values_.begin(), values_.end(), 0.0) / static_cast<double>(size());
}

void Pool::replace(int i, Individual& by) {
  std::swap(individuals_[static_cast<std::size_t>(i)], by);
  for (int j = 0; j < size(); ++j) known(i, j) = known(j, i) = Known::kNo;
  rank();
}

bool Pool::too_similar(int i, int j, double most) {
  if (most >= 1) return false;
  Known& answer = known(std::min(i, j), std::max(i, j));
  if (answer == Known::kNo) {
    const bool similar = shared_edges(at(i).genome, at(j).genome, closed_, most) > most;
    answer = similar ? Known::kSimilar : Known::kDifferent;
  }
  return answer == Known::kSimilar;
}

}  // namespace clearcut::order
