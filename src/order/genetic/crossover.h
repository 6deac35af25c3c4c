// Crossover of two parents to a new individual (Tour 4.3.3 ii). Each operator is one file in crossover/.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/random.h"
#include "order/genetic/operator_context.h"

namespace clearcut::order {

/// Leaves fixed ends unchanged. Keeps work space: not for several threads at once.
class Crossover {
 public:
  virtual ~Crossover() = default;
  /// `child` becomes a mix of both; each operator's comment states the origin of the genes. `context` has at least
  /// two free positions.
  virtual void cross(const Genome& first, const Genome& second, Random& random, Genome& child) = 0;
};

/// Partially mapped: a copy of the first parent in which a random stretch of positions holds the genes of the
/// second; the displaced genes take the former places of the genes that displaced them. The published choice.
std::unique_ptr<Crossover> pmx(const OperatorContext& context);
/// Order: a random stretch as in the second parent; all other genes in the order of the first, closed up from
/// the left to make room.
std::unique_ptr<Crossover> ox(const OperatorContext& context);
/// Edge recombination: from a random gene on, the next gene is drawn among the unused neighbours of the current gene
/// in both parents, legal moves first; if none is left, among all unused genes.
std::unique_ptr<Crossover> erx(const OperatorContext& context);
/// Cycle: every gene keeps its position in one of the parents: one random cycle of positions from the
/// second parent, all others from the first.
std::unique_ptr<Crossover> cx(const OperatorContext& context);
/// Edge assembly [nagata2013]: the first parent with the edges of one random AB-cycle exchanged, subtours joined at
/// the shortest place; not in the text's implementation, named in its review.
std::unique_ptr<Crossover> eax(const OperatorContext& context);

const std::vector<std::string>& crossover_names();
/// Throws InputError for an unknown name.
std::unique_ptr<Crossover> crossover_named(const std::string& name, const OperatorContext& context);

}  // namespace clearcut::order
