#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/studies.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <thread>

#include "arguments/suggest.h"
#include "commands/commands.h"
#include "ranks/distribute.h"
#include "terminal/output.h"

namespace clearcut::cli {
namespace {

struct StudyCommand {
  std::string name;
  std::string csv;
  std::string svg;
  studies::GeneticStudyOptions options;
  std::optional<int> threads;
  bool is_mpi = false;
  bool as_markdown = false;
  bool quiet = false;
};

/// The file of the rows while the study runs: every finished run is appended at once, so that a study that was stopped goes on where
/// it was. At the end it is written anew, sorted.
class RowFile {
 public:
  RowFile(const StudyCommand& command, const studies::GeneticStudy& study)
      : command_(command), study_(study), is_file_(!command.csv.empty() && command.csv != "-") {}

  /// What was in it; now it holds the complete runs of that, or none.
  std::string begin() const {
    if (!is_file_) return "";
    const std::string before = std::filesystem::exists(command_.csv) ? read_file(command_.csv) : "";
    const auto rows = studies::study_rows(study_, command_.options, before);
    std::string complete = studies::study_csv(study_, command_.options, rows);
    if (complete != before) write_outputs({{command_.csv, complete}}, {});
    return complete;
  }

  /// In one piece: a reader sees whole runs.
  void append(const std::string& lines) const {
    if (!is_file_) return;
    const int file = open(command_.csv.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    const ssize_t written = file < 0 ? -1 : write(file, lines.data(), lines.size());
    if (file >= 0) close(file);
    if (written != static_cast<ssize_t>(lines.size()))
      throw InputError(command_.csv, "cannot be appended to; see that it is writable and the disk not full");
  }

 private:
  const StudyCommand& command_;
  const studies::GeneticStudy& study_;
  bool is_file_;
};

void show_progress(const StudyCommand& command, int done, int total) {
  const bool shows = !command.quiet && isatty(STDERR_FILENO) != 0;
  if (shows) std::fprintf(stderr, "\r%d of %d runs%s", done, total, done == total ? "\n" : "");
}

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
  command.options.progress = [&](int done, int total, const auto&) { show_progress(command, done, total); };
  write_results(command, study, studies::run_genetic_study(study, command.options, earlier));
}

std::string task_of(const studies::StudyRun& run) {
  return fmt::format("{} {}", run.level, run.run);
}

studies::StudyRun run_of(const std::string& task) {
  studies::StudyRun run;
  std::istringstream(task) >> run.level >> run.run;
  return run;
}

/// The runs among the processes of an MPI job, one of which hands them out and has the file.
ranks::Outcome run_on_ranks(const StudyCommand& command, const studies::GeneticStudy& study,
                            const RowFile& file, ranks::Ranks& all) {
  int done = 0, total = 0;
  ranks::Work work;
  work.tasks = [&] {
    std::vector<std::string> tasks;
    for (const auto& run : studies::missing_study_runs(study, command.options, file.begin()))
      tasks.push_back(task_of(run));
    total = static_cast<int>(study.levels.size()) * study.runs;
    done = total - static_cast<int>(tasks.size());
    return tasks;
  };
  work.perform = [&](const std::string& task, const std::atomic<bool>& stop) {
    return studies::study_lines(study, command.options,
                                studies::run_study_once(study, command.options, run_of(task), stop));
  };
  work.finished = [&](const std::string&, const std::string& lines) {
    file.append(lines);
    show_progress(command, ++done, total);
  };
  work.say = complain;
  work.threads = command.threads.value_or(1);
  work.ahead = work.threads;
  return ranks::distribute(all, work);
}

int run(StudyCommand& command) {
  const studies::GeneticStudy study = studies::genetic_study(command.name, command.options);
  if (!command.is_mpi) {
    run(command, study);
    return kClean;
  }
  if (command.csv.empty() || command.csv == "-")
    throw InputError("--mpi", "appends finished runs to a file; add --output FILE");
  if (command.threads == 0)
    command.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const RowFile file(command, study);
  return ranks::on_mpi_ranks([&](ranks::Ranks& all) { return run_on_ranks(command, study, file, all); },
                             [&] {
                               const auto rows = studies::study_rows(study, command.options, file.begin());
                               write_results(command, study, rows);
                               return kClean;
                             });
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
  command
      ->add_option("--threads", state->threads,
                   "Threads; 0: all cores (the default; with --mpi of each process, and 1 the default)")
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
