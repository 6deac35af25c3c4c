// clearcut batch: plans many parts, each in a process of its own.
#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/programs.h>
#include <clearcut/text.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <thread>

#include "arguments/plan_arguments.h"
#include "batch/batch_parts.h"
#include "commands/commands.h"
#include "process/child_process.h"
#include "process/own_process.h"
#include "ranks/distribute.h"
#include "terminal/output.h"
#include "terminal/progress.h"

namespace clearcut::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using process::ChildEnd;

struct BatchCommand {
  PlanArguments arguments;
  std::string output;
  int jobs = 0;
  double part_seconds = 600;
  double part_megabytes = 0;
  std::string share;
  bool is_mpi = false;
  bool again = false;
  bool quiet = false;
};

/// "3/8": every eighth part, beginning with the third; all by default.
struct Share {
  std::size_t number = 1, of = 1;
  bool holds(std::size_t index) const { return index % of == number - 1; }
};

Share share_of(const std::string& text) {
  if (text.empty()) return {};
  Share share;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%zu/%zu%c", &share.number, &share.of, &rest) != 2 || share.number < 1 ||
      share.number > share.of)
    throw InputError("--share", "'" + text + "' is no share; write 1/8 to 8/8 for eight of them");
  return share;
}

/// Sets the memory limit of each part's own command, unless the caller's environment states one: less than its
/// address space, so that the command refuses larger needs in one line.
void allow_parts(double megabytes) {
  constexpr double kShare = 0.9, kMegabytesInGigabyte = 1000;
  if (std::getenv("CLEARCUT_MEMORY") != nullptr) return;
  process::set_variable("CLEARCUT_MEMORY", trimmed(kShare * megabytes / kMegabytesInGigabyte, 6));
}

class Batch {
 public:
  /// `processes` share the machine, each with the number of jobs in the command; without this number a single process
  /// takes all cores.
  Batch(const BatchCommand& command, std::vector<BatchPart> parts, std::vector<std::string> plan_options,
        std::optional<int> processes = {})
      : command_(command),
        parts_(std::move(parts)),
        plan_options_(std::move(plan_options)),
        jobs_(jobs_of(command, processes.has_value())),
        rows_(parts_.size()) {
    limits_.seconds = command.part_seconds;
    limits_.bytes = command.part_megabytes > 0
                        ? static_cast<std::uint64_t>(command.part_megabytes * (1 << 20))
                        : process::memory_share(jobs_ * processes.value_or(1));
    if (command.part_megabytes > 0) allow_parts(command.part_megabytes);
  }

  void run() {
    const Share share = share_of(command_.share);
    for (std::size_t part = 0; part < parts_.size(); ++part) most_ += share.holds(part) ? 1 : 0;
    begin_progress();
    take_all(share);
    if (error_) std::rethrow_exception(error_);
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (!share.holds(part)) continue;
      chosen_.push_back(rows_[part]);
    }
  }

  /// The parts among the processes of an MPI job.
  ranks::Outcome run_on(ranks::Ranks& all) {
    ranks::Work work;
    work.tasks = [this] {
      std::vector<std::string> names;
      for (const BatchPart& part : parts_) names.push_back(part.name);
      most_ = names.size();
      begin_progress();  // on the process that distributes the work
      return names;
    };
    work.perform = [this](const std::string& name, const std::string&, const std::atomic<bool>& stop) {
      const Taken taken = take(index_of(name), &stop);
      return ranks::pack({taken.is_kept ? "kept" : "planned", ranks::pack(row_fields(taken.row))});
    };
    work.finished = [this](const std::string& name, const std::string& text) {
      const auto fields = ranks::unpack(text);
      note(index_of(name), {row_of_fields(ranks::unpack(fields.at(1))), fields.at(0) == "kept"});
    };
    work.say = complain;
    work.threads = jobs_;
    const ranks::Outcome outcome = ranks::distribute(all, work);
    line_.reset();
    chosen_ = rows_;
    return outcome;
  }

  const std::vector<BatchRow>& rows() const { return chosen_; }
  std::size_t kept() const { return kept_; }

 private:
  /// Result of a part: planned now, or kept from before.
  struct Taken {
    BatchRow row;
    bool is_kept = false;
  };

  /// A signal ends the running parts, and with them the batch; finished parts are kept.
  void take_all(const Share& share) {
    const SignalsHeld signals;
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> workers;
    for (int i = 0; i < jobs_; ++i) {
      workers.emplace_back([&] {
        for (std::size_t part = next++; part < parts_.size() && !SignalsHeld::any(); part = next++) {
          if (share.holds(part)) take_safely(part);
        }
      });
    }
    workers.clear();
    line_.reset();
  }

  /// Shows progress on a terminal; otherwise the lines of the parts suffice.
  void begin_progress() {
    if (command_.quiet || !is_watched()) return;
    line_.emplace("Ctrl-C stops; parts that are done are not planned again by the same command.");
    line_->count(0, most_, "parts");
  }

  static int jobs_of(const BatchCommand& command, bool is_one_of_many) {
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return command.jobs > 0 ? command.jobs : is_one_of_many ? 1 : cores;
  }

  std::string place(const BatchPart& part, const char* ending) const {
    return (fs::path(command_.output) / (part.name + ending)).generic_string();
  }

  /// Takes a part already done, or plans it. Faults of this command itself end the batch.
  void take_safely(std::size_t index) noexcept {
    try {
      const Taken taken = take(index);
      const std::lock_guard lock(mutex_);
      note(index, taken);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
    }
  }

  Taken take(std::size_t index, const std::atomic<bool>* stop = nullptr) const {
    const BatchPart& part = parts_[index];
    fs::create_directories(fs::path(place(part, "")).parent_path());
    std::string key;
    try {
      key = batch_key(part, plan_options_);
    } catch (const InputError&) {  // its file cannot be read: its run reports this
    }
    Taken taken;
    if (!command_.again && !key.empty() && is_done(part, key, taken.row)) taken.is_kept = true;
    if (!taken.is_kept) taken.row = planned(part, key, stop);
    return taken;
  }

  /// Stores the result of a part, and prints a line for it unless it was already done.
  void note(std::size_t index, const Taken& taken) {
    rows_[index] = taken.row;
    if (taken.is_kept) {
      ++kept_;
    } else if (!command_.quiet) {
      print_row(fmt::format("{:12} {}", taken.row.verdict, taken.row.name));
    }
    if (line_) line_->count(++done_, most_, "parts");
  }

  void print_row(const std::string& text) {
    if (line_) return line_->row(text);
    print_line(text);
    std::fflush(stdout);
  }

  /// All processes of a job have to see the same parts.
  std::size_t index_of(const std::string& name) const {
    const auto found = std::find_if(parts_.begin(), parts_.end(),
                                    [&name](const BatchPart& part) { return part.name == name; });
    if (found == parts_.end())
      throw InputError(name, "is no part on another machine; all have to see the same folder");
    return static_cast<std::size_t>(found - parts_.begin());
  }

  /// Whether its results are there and rest on the same question and the same files.
  bool is_done(const BatchPart& part, const std::string& key, BatchRow& row) const {
    if (!fs::exists(place(part, ".done"))) return false;
    const Json done = Json::parse(read_file(place(part, ".done")), nullptr, false);
    if (done.is_discarded() || done.value("key", "") != key) return false;
    row = row_of(part, ended(done));
    return !has_program(row) || fs::exists(place(part, ".ngc"));
  }

  static ChildEnd ended(const Json& done) {
    return {static_cast<ChildEnd::How>(done.value("how", 0)), done.value("code", 0)};
  }

  BatchRow planned(const BatchPart& part, const std::string& key, const std::atomic<bool>* stop) const {
    for (const char* ending : {".ngc", ".json", ".svg", ".done"}) fs::remove(place(part, ending));
    std::vector<std::string> words{own_program(), "plan", part.file, "--for-many"};
    const bool says_threads =
        std::find(plan_options_.begin(), plan_options_.end(), "--threads") != plan_options_.end();
    if (!says_threads) words.insert(words.end(), {"--threads", "1"});
    words.insert(words.end(), plan_options_.begin(), plan_options_.end());
    words.insert(words.end(), part.options.begin(), part.options.end());
    words.insert(words.end(), {"--output", place(part, ".ngc"), "--certificate", place(part, ".json"),
                               "--svg", place(part, ".svg"), "--quiet"});
    const ChildEnd end = process::run_child(words, {place(part, ".log"), "", "", false}, limits_,
                                            [stop] { return !is_stopped(stop); });
    if (is_stopped(stop)) {  // the part may have received the signal first, and ended by itself
      remove_begun(part);
      throw InputError(part.name, "was stopped, as the whole batch");
    }
    const Json done{{"key", key}, {"how", static_cast<int>(end.how)}, {"code", end.code}};
    write_files({{place(part, ".done"), done.dump() + "\n"}}, {part.file});
    return row_of(part, end);
  }

  static bool is_stopped(const std::atomic<bool>* stop) {
    return SignalsHeld::any() || (stop != nullptr && *stop);
  }

  /// Removes the files written by a stopped part, complete or not.
  void remove_begun(const BatchPart& part) const {
    std::vector<fs::path> begun;
    for (const auto& one : fs::directory_iterator(fs::path(place(part, "")).parent_path())) {
      const std::string path = one.path().generic_string();
      for (const char* ending : {".ngc", ".json", ".svg", ".log"}) {
        const std::string own = place(part, ending);
        if (path == own || (path.starts_with(own + ".") && path.ends_with(".tmp"))) begun.push_back(path);
      }
    }
    std::error_code ignored;
    for (const fs::path& path : begun) fs::remove(path, ignored);
  }

  BatchRow row_of(const BatchPart& part, const ChildEnd& end) const {
    BatchRow row;
    row.name = part.name;
    row.part = part.file;
    if (end.how == ChildEnd::How::kTimedOut) {
      row.verdict = "TIMED OUT";
      row.message = fmt::format("took more than {} s", trimmed(limits_.seconds, 3));
    } else if (end.how == ChildEnd::How::kSignalled || end.code > kUnusable) {
      row.verdict = "CRASHED";
      row.message =
          end.how == ChildEnd::How::kSignalled ? fmt::format("ended by signal {}", end.code) : said(part);
    } else if (end.code == kUnusable) {
      row.verdict = "UNUSABLE";
      row.message = said(part);
    } else {
      add_certificate(part, row);
    }
    return row;
  }

  /// The last line of the command's messages, without its name.
  std::string said(const BatchPart& part) const {
    std::istringstream lines(read_file(place(part, ".log")));
    std::string last;
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty()) last = line;
    }
    const std::string name = "clearcut: ";
    return last.starts_with(name) ? last.substr(name.size()) : last;
  }

  void add_certificate(const BatchPart& part, BatchRow& row) const {
    if (!fs::exists(place(part, ".json"))) {
      row.verdict = "CRASHED";
      row.message = "ended without a certificate";
      return;
    }
    const Json certificate = Json::parse(read_file(place(part, ".json")));
    row.verdict = certificate.at("verdict").get<std::string>();
    const auto figure = [&certificate](const char* name) {
      return certificate.contains(name) && certificate.at(name).is_number()
                 ? certificate.at(name).get<double>()
                 : 0;
    };
    row.time_s = figure("time_s");
    row.feed_mm = figure("feed_mm");
    row.rapid_mm = figure("rapid_mm");
    row.uncut_mm = figure("uncut_thickness_mm");
    row.gouge_mm = figure("gouge_mm");
    for (const Json& feature : certificate.at("features")) {
      if (feature.contains("load"))
        row.wear[feature.at("tool_number")] += feature.at("load").at("tool_wear").get<double>();
    }
    row.faults = certificate.at("faults").size();
    if (row.faults > 0) row.message = certificate.at("faults")[0].value("text", "");
  }

  const BatchCommand& command_;
  std::vector<BatchPart> parts_;
  std::vector<std::string> plan_options_;
  int jobs_;
  process::ChildLimits limits_;
  std::vector<BatchRow> rows_, chosen_;
  std::size_t kept_ = 0, done_ = 0, most_ = 0;
  std::optional<ProgressLine> line_;
  std::mutex mutex_;
  std::exception_ptr error_;
};

/// The typed options of plan, as passed to each part.
std::vector<std::string> typed_plan_options(const CLI::App& command,
                                            const std::vector<const CLI::Option*>& own) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || option->get_lnames().empty()) continue;
    if (std::find(own.begin(), own.end(), option) != own.end()) continue;
    const std::string name = "--" + option->get_lnames().front();
    if (option->get_items_expected_max() == 0) {
      words.push_back(name);
      continue;
    }
    for (const auto& value : option->results()) {
      words.push_back(name);
      words.push_back(value);
    }
  }
  return words;
}

/// Reports the results of all parts, in files and as a line. A share does not write the overview: the run without a
/// share, which finds all shares done, writes it.
int tell_results(const BatchCommand& command, const Batch& batch) {
  const auto& rows = batch.rows();
  const auto at = [&](const char* name) { return (fs::path(command.output) / name).string(); };
  if (command.share.empty()) {
    std::vector<std::string> inputs{command.arguments.input()};
    for (const BatchRow& row : rows) inputs.push_back(row.part);
    write_outputs({{at("results.csv"), batch_csv(rows)},
                   {at("results.json"), batch_json(rows)},
                   {at("index.html"), batch_page(rows, command.arguments.input())}},
                  inputs);
  }
  for (const std::string& line : tool_life_lines(rows)) print_line(line);
  print_line(batch_line(rows) + (batch.kept() > 0 ? fmt::format(" ({} as they were)", batch.kept()) : ""));
  const bool clean =
      std::all_of(rows.begin(), rows.end(), [](const BatchRow& row) { return row.verdict == "CLEAN"; });
  return clean ? kClean : kFault;
}

int run(const BatchCommand& command, const std::vector<std::string>& plan_options) {
  if (command.is_mpi && !command.share.empty())
    throw InputError("--share", "and --mpi are two ways to divide the parts; give one of them");
  auto parts = batch_parts(command.arguments.input(), command.output);
  fs::create_directories(command.output);
  if (!command.is_mpi) {
    Batch batch(command, std::move(parts), plan_options);
    batch.run();
    return tell_results(command, batch);
  }
  std::optional<Batch> batch;
  return ranks::on_mpi_ranks(
      [&](ranks::Ranks& all) {
        return batch.emplace(command, std::move(parts), plan_options, all.here()).run_on(all);
      },
      [&] { return tell_results(command, *batch); });
}

}  // namespace

void add_batch_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("batch", "Plan many parts, each in a process of its own");
  command->group("Planning");
  auto state = std::make_shared<BatchCommand>();
  state->arguments.add_plan_options(*command);
  command->get_option("INPUT")->description(
      "Folder of parts, or a list: one part a line, its own options after it");
  command->option_defaults()->group("Batch");
  std::vector<const CLI::Option*> own{
      command
          ->add_option("-o,--output", state->output,
                       "Folder for programs, certificates, pictures and overview")
          ->type_name("FOLDER")
          ->required(),
      command
          ->add_option("--jobs", state->jobs,
                       "Parts at once (default: all cores; with --mpi of each process, and 1 the default)")
          ->check(CLI::PositiveNumber),
      command
          ->add_option("--part-time", state->part_seconds,
                       "Longest time for a part, s (default 600; 0: none)")
          ->check(CLI::NonNegativeNumber),
      command
          ->add_option("--part-memory", state->part_megabytes,
                       "Most memory for a part, MB (default: the machine's by the number of jobs)")
          ->check(CLI::PositiveNumber),
      command->add_option(
          "--share", state->share,
          "K/N: the K-th of N shares of the parts; run once more without --share for the overview"),
      command->add_flag("--mpi", state->is_mpi,
                        "Share the parts with the other processes of an MPI job (mpirun, srun); needs the "
                        "package clearcut-mpi"),
      command->add_flag("--again", state->again, "Plan parts again that are done already"),
      command->add_flag("--quiet", state->quiet, "Print only the last line")};
  command->callback(
      [state, command, own, &exit_code] { exit_code = run(*state, typed_plan_options(*command, own)); });
}

}  // namespace clearcut::cli
