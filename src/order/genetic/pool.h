// The population, ranked, with the similarity of its members.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "order/genetic/fitness.h"

namespace clearcut::order {

class Pool {
 public:
  Pool(std::vector<Individual> individuals, bool closed);

  int size() const { return static_cast<int>(individuals_.size()); }
  const Individual& at(int i) const { return individuals_[static_cast<std::size_t>(i)]; }
  /// The individual of a rank, 0 the best.
  int at_rank(int rank) const { return ranked_[static_cast<std::size_t>(rank)]; }
  const Individual& best() const { return at(at_rank(0)); }
  const Individual& worst() const { return at(at_rank(size() - 1)); }
  double mean_value() const;
  /// Values by rank.
  std::span<const double> values() const { return values_; }

  /// Puts `by` in the place of individual i; `by` receives the former individual.
  void replace(int i, Individual& by);

  /// In their places; the pool is empty then and of no more use.
  std::vector<Individual> take_individuals() { return std::move(individuals_); }

  /// Whether i and j share more than `most` of their edges; remembered until one of them is replaced.
  bool too_similar(int i, int j, double most);

 private:
  enum class Known : signed char { kNo, kSimilar, kDifferent };
  Known& known(int i, int j) {
    return known_[static_cast<std::size_t>(i) * individuals_.size() + static_cast<std::size_t>(j)];
  }
  void rank();

  bool closed_;
  std::vector<Individual> individuals_;
  std::vector<int> ranked_;
  std::vector<double> values_;
  std::vector<Known> known_;
};

}  // namespace clearcut::order
