#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/studies.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "arguments/suggest.h"
#include "commands/commands.h"
#include "terminal/output.h"

namespace clearcut::cli {
namespace {

struct StudyCommand {
  std::string name;
  std::string csv;
  std::string svg;
  studies::GeneticStudyOptions options;
  bool as_markdown = false;
  bool quiet = false;
};

constexpr auto kEvery = std::chrono::seconds(5);

/// Saves what there is every few seconds, so that a study that was stopped goes on where it was.
auto saver(const StudyCommand& command, const studies::GeneticStudy& study) {
  using Clock = std::chrono::steady_clock;
  auto saved = std::make_shared<Clock::time_point>(Clock::now());
  const bool shows = !command.quiet && isatty(STDERR_FILENO) != 0;
  return [&command, &study, saved, shows](int done, int total,
                                          const std::function<std::vector<studies::StudyRow>()>& rows) {
    if (shows) std::fprintf(stderr, "\r%d of %d runs%s", done, total, done == total ? "\n" : "");
    if (command.csv.empty() || command.csv == "-" || Clock::now() - *saved < kEvery) return;
    write_outputs({{command.csv, studies::study_csv(study, command.options, rows())}}, {});
    *saved = Clock::now();
  };
}

void run(StudyCommand& command) {
  const studies::GeneticStudy study = studies::genetic_study(command.name, command.options);
  const bool resumes = !command.csv.empty() && command.csv != "-" && std::filesystem::exists(command.csv);
  const std::string earlier = resumes ? read_file(command.csv) : "";
  command.options.progress = saver(command, study);
  const auto rows = studies::run_genetic_study(study, command.options, earlier);
  std::vector<OutputFile> files;
  if (!command.csv.empty()) files.push_back({command.csv, studies::study_csv(study, command.options, rows)});
  if (!command.svg.empty()) files.push_back({command.svg, studies::study_svg(study, rows)});
  write_outputs(files, {});
  const auto table = studies::study_table(study, rows);
  if (!command.quiet && command.csv != "-") print_table(table, command.as_markdown);
}

}  // namespace

void add_study_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand(
      "study", "Repeat a Monte-Carlo study of the published genetic algorithm on square lattices");
  command->group("Research");
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
  command->add_flag("--published", options.published_size,
                    "Runs, generations and lattices of the text: days");
  command->add_option("--seed", options.seed, "Seed of the first run")->capture_default_str();
  command->add_option("--threads", options.threads, "Threads; 0: all cores")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command->option_defaults()->group("Output");
  command->add_flag("--markdown", state->as_markdown, "Print a Markdown table");
  command->add_flag("--quiet", state->quiet, "Print nothing but errors");
  command->callback([state, &exit_code] {
    run(*state);
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
