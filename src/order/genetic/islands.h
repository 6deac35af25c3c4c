// Populations of the genetic algorithm side by side, each with random numbers of its own, in a ring: now and then the best of each
// move to the next. An epoch is what one island does between two migrations; it rests on two states before it alone, so that epochs can
// be done in any order that gives these, on any number of threads and machines, with the same result.
#pragma once

#include <vector>

#include "order/genetic/genetic.h"

namespace clearcut::order {

struct IslandOptions {
  int islands = 1;
  long long migrate_every = 100;  ///< generations
  int migrants = 1;               ///< that each island sends; fewer than its individuals
};

/// Throws InputError for what makes no sense with these options of each island.
void check_islands(const IslandOptions& islands, const GeneticOptions& options);

/// How many epochs a run of `stop.rounds` generations has.
long long epoch_count(const IslandOptions& islands, const GeneticOptions& options);

/// The island whose best come to this one.
int island_before(int island, const IslandOptions& islands);

/// One epoch of one island.
struct Epoch {
  int island = 0;
  long long number = 1;  ///< from 1
};

/// What the epoch before left of the island and of the one whose best come to it; none of both before the first epoch, where the first
/// island has the seed of the options, as a run without islands, and the others draw theirs from it. `patience` of the options counts
/// for nothing: all islands have as many generations.
GeneticState run_epoch(const Problem& problem, const Objective& objective, const GeneticOptions& options,
                       const IslandOptions& islands, const Epoch& epoch, const GeneticState* own,
                       const GeneticState* before);

/// The best `migrants` of `from` take the places of the worst of `into`, from the best and the worst on, where they are better and no
/// copies of what is there.
void migrate(const GeneticState& from, GeneticState& into, int migrants);

/// All islands after their last epoch as one result: its samples are those of all individuals, its time that of all islands.
GeneticResult end_islands(std::vector<GeneticState> states);

}  // namespace clearcut::order
