#include "arguments/solver_arguments.h"

namespace clearcut::cli {
namespace {

const std::map<std::string, bool> kSolvers{{"modern", false}, {"published", true}};

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
  if (!is_published.value_or(false) && published_.is_set())
    throw InputError("--solver",
                     "is not published, but settings of that solver are given; add --solver published");
  if (!is_published) return std::nullopt;
  return VisitSolver{*is_published, published_};
}

}  // namespace clearcut::cli
