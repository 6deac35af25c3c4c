#include "studies/genetic/study_run.h"

#include <time.h>

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "order/lattice.h"
#include "pipeline/tour/tour.h"

namespace clearcut::studies {
namespace {

/// Of an open path through the whole lattice; the proofs are in docs/tour.md.
double lattice_optimum(const StudyLevel& level) {
  const int n = level.side;
  if (level.objective == "length") return n * n - 1;
  if (level.objective == "turns") return 2 * n - 2;
  return 90.0 * (2 * n - 2);
}

/// Runs of the same number share their seed whatever the level.
std::uint64_t seed_of_run(std::uint64_t seed, int run) {
  return seed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(run);
}

/// Processor time of this thread, s, which other work on the machine does not lengthen; by the clock where there is none.
double thread_seconds() {
  timespec now{};
#ifdef CLOCK_THREAD_CPUTIME_ID
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
#else
  timespec_get(&now, TIME_UTC);
#endif
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

order::GeneticState study_epoch(const GeneticStudy& study, std::uint64_t seed, const StudyRun& run,
                                const order::Epoch& epoch, const order::GeneticState* own,
                                const order::GeneticState* before, const std::atomic<bool>& stop) {
  const StudyLevel& level = level_of(study, run);
  order::Problem problem = order::lattice_problem(level.side, level.side);
  problem.shape = order::Shape::kOpenPath;
  order::GeneticOptions options = level.genetic;
  options.seed = seed_of_run(seed, run.run);
  options.stop.cancel = &stop;
  const double began_s = thread_seconds();
  const auto objective = pipeline::objective_named(level.objective, 1000);
  auto state = order::run_epoch(problem, *objective, options, level.islands, epoch, own, before);
  state.reached.seconds = (own == nullptr ? 0 : own->reached.seconds) + thread_seconds() - began_s;
  return state;
}

std::vector<StudyRow> rows_of_islands(const GeneticStudy& study, const StudyRun& run,
                                      std::vector<order::GeneticState> states) {
  const StudyLevel& level = level_of(study, run);
  const auto result = order::end_islands(std::move(states));
  std::vector<StudyRow> rows;
  for (const auto& sample : result.samples) {
    StudyRow row{.level = run.level, .run = run.run, .generation = sample.generation, .best = sample.best};
    row.mean = sample.mean;
    row.worst = sample.worst;
    row.fitness = 100 * lattice_optimum(level) / sample.best;
    rows.push_back(row);
  }
  rows.back().improved =
      100 * static_cast<double>(result.improved) / static_cast<double>(std::max(1LL, result.children));
  if (study.metric == StudyMetric::kSeconds) rows.back().seconds = result.seconds;
  return rows;
}

std::vector<StudyRow> run_study_once(const GeneticStudy& study, const GeneticStudyOptions& options,
                                     const StudyRun& run, const std::atomic<bool>& stop) {
  const StudyLevel& level = level_of(study, run);
  std::vector<order::GeneticState> before, states;
  for (long long epoch = 1; epoch <= order::epoch_count(level.islands, level.genetic); ++epoch) {
    before = std::exchange(states, {});
    states.resize(static_cast<std::size_t>(level.islands.islands));
    const auto state_before = [&](int island) {
      return before.empty() ? nullptr : &before[static_cast<std::size_t>(island)];
    };
    isolated_parallel_for(0, level.islands.islands, [&](int island) {
      states[static_cast<std::size_t>(island)] =
          study_epoch(study, options.seed, run, {island, epoch}, state_before(island),
                      state_before(order::island_before(island, level.islands)), stop);
    });
  }
  return rows_of_islands(study, run, std::move(states));
}

}  // namespace clearcut::studies
