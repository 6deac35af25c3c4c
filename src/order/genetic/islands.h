// Populations of the genetic algorithm side by side, each with random numbers of its own, in a ring: now and then the
// best of each move to the next. An epoch is the work of one island between two migrations; it depends only on two
// states of the previous epoch. Epochs can therefore be done in any order that provides these states, on any number
// of threads and machines, with the same result.
//
// State of a run of the genetic algorithm as text, exact to the bit: for files and for other processes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "order/genetic/genetic.h"

namespace clearcut::order {

struct IslandOptions {
  int islands = 1;
  long long migrate_every = 100;  ///< generations
  int migrants = 1;               ///< number of individuals sent by each island; fewer than its size
};

/// Throws InputError for settings inconsistent with these options of each island.
void check_islands(const IslandOptions& islands, const GeneticOptions& options);

/// Number of epochs of a run of `stop.rounds` generations.
long long epoch_count(const IslandOptions& islands, const GeneticOptions& options);

/// The island that sends its best to this one.
int island_before(int island, const IslandOptions& islands);

/// One epoch of one island.
struct Epoch {
  int island = 0;
  long long number = 1;  ///< from 1
};

/// Runs one epoch from the states after the previous epoch of the island and of the island that sends to it; both are
/// empty before the first epoch. In the first epoch the first island has the seed of the options, like a run without
/// islands, and the others derive their seeds from it. `patience` of the options is ignored: all islands have equally
/// many generations.
GeneticState run_epoch(const Problem& problem, const Objective& objective, const GeneticOptions& options,
                       const IslandOptions& islands, const Epoch& epoch, const GeneticState* own,
                       const GeneticState* before);

/// The best `migrants` of `from` take the places of the worst of `into`, beginning with the best and the worst, if
/// they are better and not copies of individuals in `into`.
void migrate(const GeneticState& from, GeneticState& into, int migrants);

/// All islands after their last epoch as one result: its samples cover all individuals, its time is the sum of all
/// islands.
GeneticResult end_islands(std::vector<GeneticState> states);

/// One line, without its end.
std::string text_of_state(const GeneticState& state);

/// Nothing if `text` is no complete state with these numbers of individuals and points.
std::optional<GeneticState> state_of_text(const std::string& text, int individuals, int points);

}  // namespace clearcut::order
