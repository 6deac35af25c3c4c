#include <clearcut/error.h>
#include <clearcut/file.h>

#include <memory>
#include <optional>

#include "arguments/option_values.h"
#include "commands/commands.h"
#include "commands/research.h"
#include "research_commands.h"
#include "study_files.h"
#include "terminal/output.h"

namespace clearcut::cli {
namespace {

void write_results(const StudyCommand& command, const studies::GeneticStudy& study,
                   const std::vector<studies::StudyRow>& rows) {
  std::vector<OutputFile> files;
  if (!command.csv.empty()) files.push_back({command.csv, studies::study_csv(study, command.options, rows)});
  if (!command.svg.empty()) files.push_back({command.svg, studies::study_svg(study, rows)});
  write_outputs(files, {});
  const auto table = studies::study_table(study, rows);
  if (!command.quiet && command.csv != "-") print_table(table, command.as_markdown);
}

void run(StudyCommand& command, const studies::GeneticStudy& study) {
  const RowFile file(command, study);
  const std::string earlier = file.begin();
  command.options.threads = command.threads.value_or(0);
  command.options.finished = [&](const std::vector<studies::StudyRow>& rows) {
    file.append(studies::study_lines(study, command.options, rows));
  };
  const auto total = static_cast<int>(study.levels.size()) * study.runs;
  const auto missing = static_cast<int>(studies::missing_study_runs(study, command.options, earlier).size());
  std::optional<StudyProgress> progress(std::in_place, command, total - missing, total);
  command.options.progress = [&](int done, int all, const auto&) { progress->show(done, all); };
  const auto rows = studies::run_genetic_study(study, command.options, earlier);
  progress.reset();
  write_results(command, study, rows);
}

int run(StudyCommand& command) {
  const studies::GeneticStudy study = studies::genetic_study(command.name, command.options);
  if (!command.is_mpi) {
    run(command, study);
    return kClean;
  }
  return run_study_on_ranks(command, study, [&](const std::vector<studies::StudyRow>& rows) {
    write_results(command, study, rows);
    return kClean;
  });
}

void add_island_options(CLI::App& command, order::IslandOptions& options) {
  command
      .add_option(
          "--islands", options.islands,
          "Populations in each run, side by side in a ring; the best individuals of each move to the next")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--migrate-every", options.migrate_every, "Generations between two migrations")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command
      .add_option("--migrants", options.migrants,
                  "Number of individuals that migrate; they replace the worst")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
}

}  // namespace

void add_study_command(CLI::App& app, int& exit_code) {
  auto* command = add_research_command(app, kStudy);
  auto state = std::make_shared<StudyCommand>();
  auto& options = state->options;
  command->option_defaults()->group("Study");
  command
      ->add_option("NAME", state->name,
                   "population, selection, crossover, mutation, crossover-rate, mutation-rate, neighbours, "
                   "sensitivity, "
                   "size, time or spread")
      ->required()
      ->check(one_of({"population", "selection", "crossover", "mutation", "crossover-rate", "mutation-rate",
                      "neighbours", "sensitivity", "size", "time", "spread"}));
  command
      ->add_option("-o,--output,--csv", state->csv,
                   "Rows to write (CSV); rows already in it are kept and not run again")
      ->type_name("FILE");
  command->add_option("--svg", state->svg, "Box plots and curves to write")->type_name("FILE");
  command->add_option("--runs", options.runs, "Runs of each level")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command->add_option("--generations", options.generations, "Generations of each run")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command->add_option("--side", options.side, "Points along a side of the lattice")->capture_default_str();
  command->add_option("--objective", options.objective, "length, turns or angle")
      ->capture_default_str()
      ->check(one_of({"length", "turns", "angle"}));
  auto* minutes =
      command->add_flag("--minutes", options.middle_size,
                        "Runs and generations that take minutes of a core; the findings show from there on");
  command
      ->add_flag("--published", options.published_size,
                 "Runs, generations and lattices of the paper (takes days)")
      ->excludes(minutes);
  command->add_option("--seed", options.seed, "Seed of the first run")
      ->capture_default_str()
      ->check(is_seed());
  add_island_options(*command, options.islands);
  command
      ->add_option("--threads", state->threads,
                   "Threads of the computer; 0: all cores (the default; with --mpi of each process, and 1 "
                   "the default)")
      ->check(CLI::NonNegativeNumber);
  command->add_flag(
      "--mpi", state->is_mpi,
      "Share the runs with the other processes of an MPI job (mpirun, srun); needs the package clearcut-mpi");
  command->option_defaults()->group("Output");
  command->add_flag("--markdown", state->as_markdown, "Print a Markdown table");
  command->add_flag("--quiet", state->quiet, "Print nothing but errors");
  command->callback([state, &exit_code] { exit_code = run(*state); });
}

}  // namespace clearcut::cli
