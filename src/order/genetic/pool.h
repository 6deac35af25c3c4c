// The population, ranked, with the similarity of its members. The first one: nearest-neighbour paths from random
// points, with few common edges (Tour 4.3.2, fig. 4-13).
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "order/genetic/fitness.h"
#include "order/genetic/operator_context.h"

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
