// Crossover of two parents to a new individual (Tour 4.3.3 ii), its operators in crossover/, and new genetic material
// by mutation (Tour 4.3.3 iii).
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

/// What pmx does with one stretch, positions low to high (Tour 3.6.2, b.2.1).
void map_stretch(const Genome& first, const Genome& second, int low, int high, Genome& child);
/// The genes next to `gene` in either closed tour, ascending: what erx draws from (Tour table 3.1).
std::vector<int> genetic_edges(const Genome& first, const Genome& second, int gene);

// The others of Tour 3.6.2, by the rules of [larranaga1999] and [abdoun2012].
/// OX1: a random stretch as in the second parent; from its end on and around, the rest in the order of the first from there.
std::unique_ptr<Crossover> ox1(const OperatorContext& context);
/// OX2: random genes stand in the places that they have in the first parent, in the order of the second.
std::unique_ptr<Crossover> ox2(const OperatorContext& context);
/// POS: random positions as in the second parent; the rest in the order of the first.
std::unique_ptr<Crossover> pos(const OperatorContext& context);
/// HX, HC: the shorter of the moves that both parents make from here; any where both lead to used genes.
std::unique_ptr<Crossover> hx(const OperatorContext& context);
/// SMX: a stretch that both parents run through between the same ends takes the shorter of its two orders.
std::unique_ptr<Crossover> smx(const OperatorContext& context);
/// MPX: 10 genes to half of them as they follow each other in the second parent, then the rest in the order of the first.
std::unique_ptr<Crossover> mpx(const OperatorContext& context);
/// VR: positions where the parents agree stay; all others are drawn.
std::unique_ptr<Crossover> vr(const OperatorContext& context);
/// AP: genes of one parent and the other in turn, used ones left out.
std::unique_ptr<Crossover> ap(const OperatorContext& context);
/// AER: moves of one parent and the other in turn; any where that leads to a used gene.
std::unique_ptr<Crossover> aer(const OperatorContext& context);
/// SCX: a random number of moves of one parent, then of the other; any where that leads to a used gene.
std::unique_ptr<Crossover> scx(const OperatorContext& context);
/// UPMX: pmx at single random positions, a third of all, instead of a stretch.
std::unique_ptr<Crossover> upmx(const OperatorContext& context);

const std::vector<std::string>& crossover_names();
/// Throws InputError for an unknown name.
std::unique_ptr<Crossover> crossover_named(const std::string& name, const OperatorContext& context);

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
