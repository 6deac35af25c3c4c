#include "arguments/solver_arguments.h"

namespace clearcut::cli {
namespace {

const std::map<std::string, bool> kSolvers{{"modern", false}, {"published", true}};

[[noreturn]] void refuse_settings() {
  throw InputError("--solver",
                   "is not published, but settings of that solver are given; add --solver published");
}

/// What `typed` sets goes before `solver`.
void lay_over(PublishedSolver& solver, const PublishedSolver& typed) {
  const auto take = [](auto& own, const auto& theirs) {
    if (theirs) own = theirs;
  };
  take(solver.generations, typed.generations);
  take(solver.population, typed.population);
  take(solver.selection, typed.selection);
  take(solver.crossover, typed.crossover);
  take(solver.mutation, typed.mutation);
  take(solver.crossover_rate, typed.crossover_rate);
  take(solver.mutation_rate, typed.mutation_rate);
  take(solver.most_shared, typed.most_shared);
}

}  // namespace

void SolverArguments::add_options(CLI::App& command) {
  const std::string group = "Published solver";
  command.add_option("--solver", name_,
                     "Orders visits: modern, or published (the genetic algorithm of the text)");
  command
      .add_option("--generations", published_.generations,
                  "Of the published solver (until 1000 bring no gain)")
      ->check(CLI::PositiveNumber)
      ->group(group);
  command.add_option("--population", published_.population, "Individuals (25)")
      ->check(CLI::PositiveNumber)
      ->group(group);
  command.add_option("--selection", published_.selection, "random, rank, roulette, tournament or truncation")
      ->group(group);
  command.add_option("--crossover", published_.crossover, "pmx, ox, erx, cx or eax")->group(group);
  command.add_option("--mutation", published_.mutation, "exchange, inversion or nearest")->group(group);
  command.add_option("--crossover-rate", published_.crossover_rate, "Chance of two parents")->group(group);
  command.add_option("--mutation-rate", published_.mutation_rate, "Chance of a mutation")->group(group);
  command
      .add_option("--most-shared", published_.most_shared, "Share of edges that makes two too similar (0.2)")
      ->group(group);
}

std::optional<VisitSolver> SolverArguments::solver() const {
  const auto is_published = named(kSolvers, name_, "--solver");
  if (!is_published.value_or(false) && published_.is_set()) refuse_settings();
  if (!is_published) return std::nullopt;
  return VisitSolver{*is_published, published_};
}

void SolverArguments::refine(StepChoices& of_job) const {
  bool is_used = false;
  for (auto& [step, choices] : of_job) {
    if (!choices.solver || !choices.solver->is_published) continue;
    lay_over(choices.solver->published, published_);
    is_used = true;
  }
  if (!is_used) refuse_settings();
}

}  // namespace clearcut::cli
