#include "arguments/solver_arguments.h"

namespace clearcut::cli {

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
  const VisitSolver solver{name_ && is_published_solver(*name_, "--solver"), published_};
  check_solver(solver);
  return name_ ? std::optional(solver) : std::nullopt;
}

void SolverArguments::refine(StepChoices& of_job) const {
  bool is_used = false;
  for (auto& [step, choices] : of_job) {
    if (!choices.solver || !choices.solver->is_published) continue;
    choices.solver->published.merge(published_);
    is_used = true;
  }
  if (!is_used) check_solver({false, published_});
}

}  // namespace clearcut::cli
