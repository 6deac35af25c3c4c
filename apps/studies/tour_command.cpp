#include <clearcut/file.h>
#include <clearcut/order.h>

#include <memory>

#include "arguments/option_values.h"
#include "commands/commands.h"
#include "commands/research.h"
#include "research_commands.h"
#include "terminal/output.h"
#include "terminal/progress.h"

namespace clearcut::cli {
namespace {

struct TourCommand {
  std::string input;
  TourOptions options;
  bool open = false;
  bool closed = false;
  std::string json;
  std::string svg;
};

/// Operators of the published genetic algorithm; defaults are the text's.
void add_genetic_options(CLI::App& command, TourOptions& options) {
  auto& genetic = options.genetic;
  const std::string group = "Published solver";
  command.add_option("--population", genetic.population, "Individuals (default 25)")->group(group);
  command.add_option("--selection", genetic.selection, "random, rank, roulette, tournament or truncation")
      ->capture_default_str()
      ->check(one_of({"random", "rank", "roulette", "tournament", "truncation"}))
      ->group(group);
  command
      .add_option("--crossover", genetic.crossover,
                  "pmx, ox, erx, cx, eax, ox1, ox2, pos, hx, smx, mpx, vr, ap, aer, scx or upmx")
      ->capture_default_str()
      ->check(one_of(order::crossover_names()))
      ->group(group);
  command
      .add_option("--mutation", genetic.mutation,
                  "exchange, inversion, nearest or one of the others of docs/tour.md")
      ->capture_default_str()
      ->check(one_of(order::mutation_names()))
      ->group(group);
  command.add_option("--replacement", genetic.replacement, "distinct, worst, parent or generation")
      ->capture_default_str()
      ->check(one_of({"distinct", "worst", "parent", "generation"}))
      ->group(group);
  command.add_option("--crossover-rate", genetic.crossover_rate, "Probability of crossover")
      ->capture_default_str()
      ->group(group);
  command.add_option("--mutation-rate", genetic.mutation_rate, "Probability of mutation")
      ->capture_default_str()
      ->group(group);
  command.add_option("--again-rate", genetic.again_rate, "Probability of one more mutation after each")
      ->capture_default_str()
      ->group(group);
  command.add_option("--children", genetic.children, "New individuals in a generation (default 25)")
      ->group(group);
  command
      .add_option("--most-shared", genetic.most_shared,
                  "Share of common edges above which two individuals are too similar (default 0.2)")
      ->group(group);
  command
      .add_option("--neighbours", options.genetic_neighbours,
                  "Nearest points a mutation draws from; 0: all (default 24)")
      ->group(group);
  command
      .add_option("--patience", genetic.patience, "Generations without gain that end the run (default 1000)")
      ->group(group);
  command
      .add_option("--generations", genetic.stop.rounds, "Greatest number of generations (default: no limit)")
      ->capture_default_str()
      ->group(group);
}

/// Searches with a line showing the best value so far.
TourResult solved(const TourCommand& command) {
  ProgressLine line(kCancel);
  TourOptions options = command.options;
  options.improved = [&line, &options](const TourSample& sample) {
    line.search({sample.best, sample.seconds, options.time_s});
  };
  return solve_tour(command.input, options);
}

void run(TourCommand command) {
  if (command.open || command.closed) command.options.closed = command.closed;
  const auto result = solved(command);
  std::vector<OutputFile> files;
  if (!command.json.empty()) files.push_back({command.json, tour_json(result)});
  if (!command.svg.empty()) files.push_back({command.svg, tour_svg(result)});
  write_outputs(files, {command.input});
  if (command.json != "-") print_line(tour_line(result));
}

}  // namespace

void add_tour_command(CLI::App& app, int& exit_code) {
  auto* command = add_research_command(app, kTour);
  auto state = std::make_shared<TourCommand>();
  command->option_defaults()->group("Search");
  command->add_option("INPUT", state->input, "TSPLIB file (EUC_2D) or COLUMNSxROWS")->required();
  command
      ->add_option("--objective", state->options.objective,
                   "length, turns, angle, time, engagement, engagement-inverse, engagement-exact, or "
                   "weights 1:length,20:turns")
      ->capture_default_str()
      ->check(for_example(
          {"length", "turns", "angle", "time", "engagement", "engagement-inverse", "engagement-exact"}));
  auto* open = command->add_flag("--open", state->open, "An open path with free ends (default for lattices)");
  command->add_flag("--closed", state->closed, "A closed tour (default for files)")->excludes(open);
  command->add_option("--time", state->options.time_s, "Longest time of the search, s")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command->add_option("--seed", state->options.seed, "Seed of the search")
      ->capture_default_str()
      ->check(is_seed());
  command->add_option("--threads", state->options.threads, "Threads of the computer; 0: all cores")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command->add_option("--feed", state->options.feed, "Feed for the objective time, mm/min")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--diameter", state->options.diameter,
                   "Diameter of the cutter for engagement, mm (default: two pitches of the points)")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--engagement", state->options.engagement_percent,
                   "Wanted share of the cutter's leading half in material, percent (default 50)")
      ->check(CLI::Range(0.0, 100.0));
  command
      ->add_option("--solver", state->options.solver,
                   "modern (default), or published: the genetic algorithm of the text")
      ->check(one_of({"modern", "published"}));
  add_genetic_options(*command, state->options);
  command->option_defaults()->group("Output");
  command->add_option("--json", state->json, "Result to write (- for standard output)")->type_name("FILE");
  command->add_option("--svg", state->svg, "Picture to write")->type_name("FILE");
  command->callback([state, &exit_code] {
    run(*state);
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
