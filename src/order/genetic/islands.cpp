#include "order/genetic/islands.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "order/genetic/pool.h"

namespace clearcut::order {
namespace {

/// The first island has the run's own seed; the others draw theirs.
std::uint64_t seed_of_island(std::uint64_t seed, int island) {
  std::uint64_t drawn = seed;
  Random random(seed);
  for (int i = 0; i < island; ++i) drawn = random.next();
  return drawn;
}

bool has_genes(const Pool& pool, const Tour& genes) {
  for (int i = 0; i < pool.size(); ++i)
    if (pool.at(i).genome.genes() == genes) return true;
  return false;
}

/// The samples present in all islands: after an early stop, some islands have fewer.
std::vector<GenerationSample> samples_of_all(const std::vector<GeneticResult>& results) {
  std::vector<GenerationSample> all = results.front().samples;
  for (const GeneticResult& one : results) all.resize(std::min(all.size(), one.samples.size()));
  const auto count = static_cast<double>(results.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].mean = 0;
    for (const GeneticResult& one : results) {
      const GenerationSample& sample = one.samples[i];
      all[i].best = std::min(all[i].best, sample.best);
      all[i].mean += sample.mean / count;
      all[i].worst = std::max(all[i].worst, sample.worst);
    }
  }
  return all;
}

}  // namespace

void check_islands(const IslandOptions& islands, const GeneticOptions& options) {
  if (islands.islands < 1) throw InputError("islands", "needs at least 1");
  if (islands.migrate_every < 1) throw InputError("migrate-every", "needs at least 1 generation");
  if (islands.migrants < 0 || islands.migrants >= options.population)
    throw InputError("migrants", "lies between 0 and one less than the individuals of an island");
}

long long epoch_count(const IslandOptions& islands, const GeneticOptions& options) {
  const long long rounds = std::max(1LL, options.stop.rounds);
  return islands.islands == 1 ? 1 : (rounds - 1) / islands.migrate_every + 1;
}

int island_before(int island, const IslandOptions& islands) {
  return (island + islands.islands - 1) % islands.islands;
}

GeneticState run_epoch(const Problem& problem, const Objective& objective, const GeneticOptions& options,
                       const IslandOptions& islands, const Epoch& epoch, const GeneticState* own,
                       const GeneticState* before) {
  GeneticOptions settings = options;
  settings.patience = std::numeric_limits<long long>::max();
  settings.seed = seed_of_island(options.seed, epoch.island);
  if (epoch.number < epoch_count(islands, options))
    settings.stop.rounds = epoch.number * islands.migrate_every;
  GeneticState state = own == nullptr ? begin_genetic(problem, objective, settings) : *own;
  if (own != nullptr && before != nullptr) migrate(*before, state, islands.migrants);
  return continue_genetic(problem, objective, settings, std::move(state));
}

void migrate(const GeneticState& from, GeneticState& into, int migrants) {
  const Pool senders(from.individuals, false);
  Pool pool(std::move(into.individuals), false);
  for (int rank = 0; rank < migrants; ++rank) {
    Individual migrant = senders.at(senders.at_rank(rank));
    if (migrant.value < pool.worst().value && !has_genes(pool, migrant.genome.genes()))
      pool.replace(pool.at_rank(pool.size() - 1), migrant);
  }
  into.individuals = pool.take_individuals();
}

GeneticResult end_islands(std::vector<GeneticState> states) {
  std::vector<GeneticResult> results;
  for (GeneticState& state : states) results.push_back(end_genetic(std::move(state)));
  const auto best = std::min_element(results.begin(), results.end(),
                                     [](const auto& a, const auto& b) { return a.value < b.value; });
  GeneticResult all = *best;
  all.children = all.improved = all.records = 0;
  all.seconds = 0;
  for (const GeneticResult& one : results) {
    all.children += one.children;
    all.improved += one.improved;
    all.records += one.records;
    all.seconds += one.seconds;
  }
  all.samples = samples_of_all(results);
  return all;
}

}  // namespace clearcut::order
