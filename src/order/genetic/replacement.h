// Replacement: the individuals that make room for new ones. The text says only that "the better solutions will
// survive while the poor performing solutions are killed off" (Tour 4.3.1); these are the usual readings.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "order/genetic/pool.h"

namespace clearcut::order {

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
