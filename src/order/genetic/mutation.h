// New genetic material (Tour 4.3.3 iii).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/random.h"
#include "order/genetic/operator_context.h"

namespace clearcut::order {

class Mutation {
 public:
  virtual ~Mutation() = default;
  /// A random rearrangement of free positions; its change of value is computed before it is applied.
  virtual Rearrangement choose(const Genome& genome, Random& random) const = 0;
};

/// Two random genes switch places.
std::unique_ptr<Mutation> exchange_mutation(const OperatorContext& context);
/// All genes from one random position to another are reversed.
std::unique_ptr<Mutation> inversion_mutation(const OperatorContext& context);
/// A random gene is exchanged with one of the nearest neighbours of the preceding gene: the two swap places and
/// all genes between them are reversed. The published choice.
///
/// If the neighbour comes earlier on the path than the preceding gene, the same new edge is made on the other side:
/// the genes between the two are reversed. The first gene of an open path has no preceding gene; there the genes up
/// to one of its own neighbours are reversed, so that the two become adjacent.
std::unique_ptr<Mutation> nearest_mutation(const OperatorContext& context);

// The others of Tour 3.6.2 (c) by their names: displacement, insertion, inverted-displacement (a stretch or one gene moves elsewhere;
// DM, ISM, IVM), scramble, partial-shuffle (SM, PSM), centre-inversion, three-successive, three-random (throas, thrors), shorter
// (Sengoku's). Simple inversion and the reversed sequence are `inversion`, twors is `exchange`.
const std::vector<std::string>& mutation_names();
/// Throws InputError for an unknown name.
std::unique_ptr<Mutation> mutation_named(const std::string& name, const OperatorContext& context);

}  // namespace clearcut::order
