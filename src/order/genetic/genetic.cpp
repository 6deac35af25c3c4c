#include "order/genetic/genetic.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "order/genetic/operators.h"
#include "order/genetic/pool.h"
#include "order/genetic/selection.h"

namespace clearcut::order {

namespace {

void check_options(const GeneticOptions& o) {
  if (o.population < 2) throw InputError("population", "needs at least 2 individuals");
  if (o.children < 1) throw InputError("children", "a generation needs at least 1 new individual");
  if (!(o.crossover_rate >= 0 && o.crossover_rate <= 1 && o.mutation_rate >= 0 && o.mutation_rate <= 1 &&
        o.again_rate >= 0 && o.again_rate < 1))
    throw InputError("rate",
                     "rates of crossover and mutation lie between 0 and 1, that of another mutation below 1");
  if (o.patience < 1) throw InputError("patience", "needs at least 1 generation");
}

/// Whether the values of a generation are recorded: those of 0 and of n 10^i with n = 1..9 (eq. 5.1).
bool is_sampled(long long generation) {
  while (generation >= 10 && generation % 10 == 0) generation /= 10;
  return generation < 10;
}

GenerationSample sample_of(const Pool& pool, long long generation) {
  return {generation, pool.best().value, pool.mean_value(), pool.worst().value};
}

class Evolution {
 public:
  /// Starts a new run if `state` holds no individuals.
  Evolution(const Moves& moves, const Objective& objective, const GeneticOptions& options, GeneticState state)
      : options_(options),
        moves_(moves),
        context_(moves, options.neighbours),
        fitness_(moves, objective),
        has_rules_(!moves.problem().precedence.empty()),
        random_(state.random),
        selection_(selection_named(options.selection)),
        crossover_(crossover_named(options.crossover, context_)),
        mutation_(mutation_named(options.mutation, context_)),
        replacement_(replacement_named(options.replacement)),
        pool_(state.individuals.empty() ? first_individuals() : std::move(state.individuals),
              moves.problem().closed()),
        watch_(options.stop),
        idle_(state.idle),
        result_(std::move(state.reached)) {
    if (!result_.samples.empty()) return;
    sample();
    report();
  }

  GeneticState run() {
    while (idle_ < options_.patience && !is_over()) {
      const bool gained = one_generation();
      idle_ = gained ? 0 : idle_ + 1;
      ++result_.generations;
      if (is_sampled(result_.generations)) sample();
      if (gained) report();
    }
    return state();
  }

  GeneticState state() {
    result_.tour = pool_.best().genome.genes();
    result_.value = pool_.best().value;
    result_.seconds += watch_.seconds();
    return {pool_.take_individuals(), random_, idle_, std::move(result_)};
  }

 private:
  struct Parents {
    int first = 0;
    int second = 0;
  };

  std::vector<Individual> first_individuals() {
    std::vector<Individual> individuals;
    for (Genome& genome :
         first_population(context_, options_.population, options_.most_shared, options_.breadth, random_)) {
      individuals.push_back({.genome = std::move(genome)});
      fitness_.evaluate(individuals.back());
    }
    return individuals;
  }

  bool is_over() const {
    return result_.generations >= options_.stop.rounds || context_.free_count() < 2 || watch_.over();
  }

  /// Whether the best individual became better.
  bool one_generation() {
    const double before = pool_.best().value;
    for (int i = 0; i < options_.children; ++i) one_child();
    replacement_->end_generation(pool_);
    return pool_.best().value < before - kSameValue * std::abs(before);
  }

  /// A child is priced before its genes are written: most are no better and cost no copy.
  void one_child() {
    const Parents parents = select();
    const bool crosses = random_.unit() < options_.crossover_rate;
    const bool mutates = random_.unit() < options_.mutation_rate;
    const Individual& first = pool_.at(parents.first);
    ++result_.children;
    if (crosses) {
      crossover_->cross(first.genome, pool_.at(parents.second).genome, random_, child_.genome);
      child_.local = fitness_.local_after(first, child_.genome);
    }
    bool is_written = crosses;
    Rearrangement change =
        mutates ? mutation_->choose(crosses ? child_.genome : first.genome, random_) : Rearrangement{};
    while (mutates && options_.again_rate > 0 && random_.unit() < options_.again_rate) {
      if (!is_written) child_ = first;
      is_written = true;
      child_.local += fitness_.change(child_.genome, change);
      child_.genome.apply(change);
      change = mutation_->choose(child_.genome, random_);
    }
    const Individual& before = is_written ? child_ : first;
    const double local = before.local + fitness_.change(before.genome, change);
    if (fitness_.is_local()) {
      const double value = fitness_.value_of(local);
      if (!has_rules_) count(parents, value);
      if (!replacement_->wants(pool_, value, parents.first)) return;
    }
    if (!is_written) child_ = first;
    child_.local = local;
    child_.genome.apply(change);
    if (has_rules_ && !is_valid(moves_.problem(), child_.genome.genes())) return;
    fitness_.complete(child_);
    if (has_rules_ || !fitness_.is_local()) count(parents, child_.value);
    replacement_->offer(pool_, child_, parents.first);
  }

  /// The second parent comes from the rest of the pool; one too similar to the first is discarded and another
  /// drawn, which amounts to drawing among the less similar ones. If all are too similar, any of the rest is taken:
  /// 4.3.3 i leaves this case open.
  Parents select() {
    const int first = pool_.at_rank(selection_->pick(pool_.values(), random_));
    fill_mates(first, options_.most_shared);
    if (mates_.empty()) fill_mates(first, 1);
    return {first, mates_[static_cast<std::size_t>(selection_->pick(mate_values_, random_))]};
  }

  void fill_mates(int first, double most_shared) {
    mates_.clear();
    mate_values_.clear();
    for (int rank = 0; rank < pool_.size(); ++rank) {
      const int mate = pool_.at_rank(rank);
      if (mate == first || pool_.too_similar(first, mate, most_shared)) continue;
      mates_.push_back(mate);
      mate_values_.push_back(pool_.at(mate).value);
    }
  }

  void count(const Parents& parents, double value) {
    const double better = std::min(pool_.at(parents.first).value, pool_.at(parents.second).value);
    const double enough = kSameValue * std::abs(better);
    result_.improved += value < better - enough ? 1 : 0;
    result_.records += value < pool_.best().value - enough ? 1 : 0;
  }

  void sample() { result_.samples.push_back(sample_of(pool_, result_.generations)); }
  void report() const {
    if (options_.progress)
      options_.progress({pool_.best().genome.genes(), pool_.best().value, watch_.seconds()});
  }

  const GeneticOptions& options_;
  const Moves& moves_;
  OperatorContext context_;
  Fitness fitness_;
  bool has_rules_;  ///< precedence: children may be invalid
  Random random_;
  std::unique_ptr<Selection> selection_;
  std::unique_ptr<Crossover> crossover_;
  std::unique_ptr<Mutation> mutation_;
  std::unique_ptr<Replacement> replacement_;
  Pool pool_;
  StopWatch watch_;
  Individual child_;
  std::vector<int> mates_;  // possible mates, by rank
  std::vector<double> mate_values_;
  long long idle_;  ///< generations since the last gain
  GeneticResult result_;
};

}  // namespace

GeneticState begin_genetic(const Problem& problem, const Objective& objective,
                           const GeneticOptions& options) {
  check(problem);
  check_options(options);
  const Moves moves(problem);
  return Evolution(moves, objective, options, {.random = Random(options.seed)}).state();
}

GeneticState continue_genetic(const Problem& problem, const Objective& objective,
                              const GeneticOptions& options, GeneticState state) {
  check(problem);
  check_options(options);
  const Moves moves(problem);
  return Evolution(moves, objective, options, std::move(state)).run();
}

GeneticResult end_genetic(GeneticState state) {
  GeneticResult& reached = state.reached;
  if (reached.samples.back().generation != reached.generations)
    reached.samples.push_back(sample_of(Pool(std::move(state.individuals), false), reached.generations));
  return std::move(reached);
}

GeneticResult run_genetic(const Problem& problem, const Objective& objective, const GeneticOptions& options) {
  check(problem);
  check_options(options);
  const Moves moves(problem);
  return end_genetic(Evolution(moves, objective, options, {.random = Random(options.seed)}).run());
}

Solution solve_genetic(const Problem& problem, const Objective& objective, const GeneticOptions& options) {
  const StopWatch watch(options.stop);
  const GeneticResult result = run_genetic(problem, objective, options);
  const Moves moves(problem);
  Solution solution;
  set_result(solution, moves, result.tour, evaluate(objective, moves, result.tour),
             lower_bound(problem, objective, result.tour, watch));
  solution.seconds = watch.seconds();
  solution.seed = options.seed;
  solution.rounds = result.generations;
  solution.method = "genetic, " + options.selection + ", " + options.crossover + ", " + options.mutation;
  return solution;
}

}  // namespace clearcut::order
