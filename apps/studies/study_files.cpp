#include "study_files.h"

#include <clearcut/error.h>
#include <clearcut/file.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

#include "ranks/distribute.h"
#include "terminal/output.h"

namespace clearcut::cli {

namespace fs = std::filesystem;

void append_to_file(const std::string& path, const std::string& lines) {
  std::ofstream file(fs::path(path), std::ios::app | std::ios::binary);
  file << lines << std::flush;
  if (!file) throw InputError(path, "cannot be appended to; see that it is writable and the disk not full");
}

StudyProgress::StudyProgress(const StudyCommand& command, int done, int total) {
  if (command.quiet || !is_watched()) return;
  const bool keeps = !command.csv.empty() && command.csv != "-";
  line_.emplace(keeps ? "Ctrl-C stops; runs that are done are kept." : kStops);
  show(done, total);
}

void StudyProgress::show(int done, int total) {
  if (line_) line_->count(static_cast<std::size_t>(done), static_cast<std::size_t>(total), "runs");
}

RowFile::RowFile(const StudyCommand& command, const studies::GeneticStudy& study)
    : command_(command), study_(study), is_file_(!command.csv.empty() && command.csv != "-") {}

std::string RowFile::begin() const {
  if (!is_file_) return "";
  const std::string before = fs::exists(command_.csv) ? read_file(command_.csv) : "";
  const auto rows = studies::study_rows(study_, command_.options, before);
  std::string complete = studies::study_csv(study_, command_.options, rows);
  if (complete != before) write_outputs({{command_.csv, complete}}, {});
  return complete;
}

void RowFile::append(const std::string& lines) const {
  if (is_file_) append_to_file(command_.csv, lines);
}

std::vector<std::string> StateFolder::names() const {
  std::vector<std::string> all;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder_, none))
    all.push_back(entry.path().filename().string());
  std::sort(all.begin(), all.end());
  return all;
}

std::optional<std::string> StateFolder::read(const std::string& name) const {
  const fs::path path = folder_ / name;
  if (!fs::exists(path)) return {};
  return read_file(path.string());
}

void StateFolder::write(const std::string& name, const std::string& text) {
  std::error_code error;
  fs::create_directories(folder_, error);
  write_files({{(folder_ / name).string(), text}});
}

/// With the last one goes the folder, and what a process left there that was killed while it wrote.
void StateFolder::erase(const std::string& name) {
  std::error_code ignored;
  fs::remove(folder_ / name, ignored);
  const std::vector<std::string> left = names();
  if (std::all_of(left.begin(), left.end(), [](const std::string& one) { return one.ends_with(".tmp"); }))
    fs::remove_all(folder_, ignored);
}

namespace {

std::string task_of(const studies::StudyRun& run) {
  return fmt::format("{} {}", run.level, run.run);
}

studies::StudyRun run_of(const std::string& task) {
  studies::StudyRun run;
  std::istringstream(task) >> run.level >> run.run;
  return run;
}

/// One of the processes.
class StudyRank {
 public:
  StudyRank(StudyCommand& command, const studies::GeneticStudy& study)
      : command_(command), study_(study), file_(command, study), states_(command.csv) {
    command.options.finished = [this](const std::vector<studies::StudyRow>& rows) {
      finish_run(studies::study_lines(study_, command_.options, rows));
    };
  }
  StudyRank(const StudyRank&) = delete;
  StudyRank& operator=(const StudyRank&) = delete;
  ~StudyRank() { command_.options.finished = nullptr; }

  ranks::Outcome run(ranks::Ranks& all) {
    ranks::Work work = command_.options.islands.islands > 1 ? islands() : whole_runs();
    work.say = complain;
    work.threads = command_.threads.value_or(1);
    work.ahead = work.threads;
    const ranks::Outcome outcome = ranks::distribute(all, work);
    progress_.reset();
    return outcome;
  }

  std::vector<studies::StudyRow> rows() const {
    return studies::study_rows(study_, command_.options, file_.begin());
  }

 private:
  ranks::Work whole_runs() {
    ranks::Work work;
    work.tasks = [this] {
      std::vector<std::string> tasks;
      for (const auto& run : studies::missing_study_runs(study_, command_.options, file_.begin()))
        tasks.push_back(task_of(run));
      begin_counting(static_cast<int>(tasks.size()));
      return tasks;
    };
    work.perform = [this](const std::string& task, const std::string&, const std::atomic<bool>& stop) {
      return studies::study_lines(study_, command_.options,
                                  studies::run_study_once(study_, command_.options, run_of(task), stop));
    };
    work.finished = [this](const std::string&, const std::string& lines) { finish_run(lines); };
    return work;
  }

  /// For runs with islands, an epoch of one island is a task.
  ranks::Work islands() {
    ranks::Work work;
    work.tasks = [this] {
      runs_.emplace(study_, command_.options, file_.begin(), states_);
      begin_counting(runs_->missing_runs());
      return runs_->tasks();
    };
    work.input = [this](const std::string& task) { return runs_->input(task); };
    work.perform = [this](const std::string& task, const std::string& input, const std::atomic<bool>& stop) {
      return studies::run_island_task(study_, command_.options, task, input, stop);
    };
    work.finished = [this](const std::string& task, const std::string& state) {
      next_ = runs_->finish(task, state);
    };
    work.next = [this](const std::string&) { return std::exchange(next_, {}); };
    return work;
  }

  void begin_counting(int missing) {
    total_ = static_cast<int>(study_.levels.size()) * study_.runs;
    done_ = total_ - missing;
    progress_.emplace(command_, done_, total_);
  }

  void finish_run(const std::string& lines) {
    file_.append(lines);
    progress_->show(++done_, total_);
  }

  StudyCommand& command_;
  const studies::GeneticStudy& study_;
  RowFile file_;
  StateFolder states_;
  std::optional<studies::IslandRuns> runs_;  ///< on the distributing process
  std::vector<std::string> next_;            ///< tasks possible after a finished task
  int done_ = 0, total_ = 0;
  std::optional<StudyProgress> progress_;  ///< likewise
};

}  // namespace

int run_study_on_ranks(StudyCommand& command, const studies::GeneticStudy& study,
                       const std::function<int(const std::vector<studies::StudyRow>& rows)>& write) {
  if (command.csv.empty() || command.csv == "-")
    throw InputError("--mpi", "appends finished runs to a file; add --output FILE");
  if (command.threads == 0)
    command.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  StudyRank rank(command, study);
  return ranks::on_mpi_ranks([&](ranks::Ranks& all) { return rank.run(all); },
                             [&] { return write(rank.rows()); });
}

}  // namespace clearcut::cli
