// Selection of the parents (Tour 4.3.3 i). Replacement: the individuals that make room for new ones. The text says
// only that "the better solutions will survive while the poor performing solutions are killed off" (Tour 4.3.1);
// these are the usual readings.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/random.h"
#include "order/genetic/pool.h"

namespace clearcut::order {

class Selection {
 public:
  virtual ~Selection() = default;
  /// Place in `ranked`, the values of the selection pool, smallest (best) first; not empty.
  virtual int pick(std::span<const double> ranked, Random& random) const = 0;
};

/// All with equal chances.
std::unique_ptr<Selection> random_selection();
/// Chances reduced by a constant from rank to rank: N, N - 1, ..., 1.
std::unique_ptr<Selection> rank_selection();
/// p_i = f_i / sum f_j (eq. 4.12) with the fitness f = 1 / value (eq. 4.15); the published choice.
std::unique_ptr<Selection> roulette_selection();
/// The best of `size` drawn with equal chances.
std::unique_ptr<Selection> tournament_selection(int size = 3);
/// Equal chances among the best `share` of the pool, at least one.
std::unique_ptr<Selection> truncation_selection(double share = 0.5);

const std::vector<std::string>& selection_names();
/// Throws InputError for an unknown name.
std::unique_ptr<Selection> selection_named(const std::string& name);

class Replacement {
 public:
  virtual ~Replacement() = default;
  /// False if a child of this value would be rejected anyway.
  virtual bool wants(const Pool& pool, double value, int first_parent) const = 0;
  /// Takes the child in, or rejects it; `first_parent` is the place of the first parent in the pool.
  virtual void offer(Pool& pool, Individual& child, int first_parent) = 0;
  virtual void end_generation(Pool& /*pool*/) {}
};

/// The worst individual, when the child is no worse and no copy of an individual in the pool: duplicates are
/// eliminated, as in the method the text reviews in 3.6.2 (a).
std::unique_ptr<Replacement> replace_distinct();
/// The worst individual, when the child is better. Copies of the best soon fill the pool.
std::unique_ptr<Replacement> replace_worst();
/// The child's first parent, when the child is no worse: as many lines of descent as individuals.
std::unique_ptr<Replacement> replace_parent();
/// At the end of each generation all but the best individual, by the generation's best children.
std::unique_ptr<Replacement> replace_generation();

const std::vector<std::string>& replacement_names();
/// Throws InputError for an unknown name.
std::unique_ptr<Replacement> replacement_named(const std::string& name);

}  // namespace clearcut::order
