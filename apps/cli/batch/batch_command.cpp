// clearcut batch: plans many parts, each in a process of its own.
#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/text.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "arguments/plan_arguments.h"
#include "batch/batch_overview.h"
#include "batch/batch_parts.h"
#include "commands/commands.h"
#include "process/child_process.h"
#include "terminal/output.h"

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
  bool again = false;
  bool quiet = false;
};

/// "3/8": every eighth part, beginning with the third; all where nothing is said.
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

class Batch {
 public:
  Batch(const BatchCommand& command, std::vector<BatchPart> parts, std::vector<std::string> plan_options)
      : command_(command),
        parts_(std::move(parts)),
        plan_options_(std::move(plan_options)),
        rows_(parts_.size()) {
    limits_.seconds = command.part_seconds;
    limits_.bytes = command.part_megabytes > 0
                        ? static_cast<std::uint64_t>(command.part_megabytes * (1 << 20))
                        : fair_share();
  }

  void run() {
    const Share share = share_of(command_.share);
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> workers;
    for (int i = 0; i < jobs(); ++i) {
      workers.emplace_back([&] {
        for (std::size_t part = next++; part < parts_.size(); part = next++) {
          if (share.holds(part)) take(part);
        }
      });
    }
    workers.clear();
    if (error_) std::rethrow_exception(error_);
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (!share.holds(part)) continue;
      chosen_.push_back(rows_[part]);
    }
  }

  const std::vector<BatchRow>& rows() const { return chosen_; }
  std::size_t kept() const { return kept_; }

 private:
  int jobs() const {
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return command_.jobs > 0 ? command_.jobs : cores;
  }

  /// The machine's memory by the number of jobs.
  std::uint64_t fair_share() const {
    const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / static_cast<std::uint64_t>(jobs());
  }

  std::string place(const BatchPart& part, const char* ending) const {
    return (fs::path(command_.output) / (part.name + ending)).string();
  }

  /// A part that is done, or is now. Faults of this command itself end the batch.
  void take(std::size_t index) noexcept {
    try {
      const BatchPart& part = parts_[index];
      fs::create_directories(fs::path(place(part, "")).parent_path());
      std::string key;
      try {
        key = batch_key(part, plan_options_);
      } catch (const InputError&) {  // its file cannot be read: its run says so
      }
      if (!command_.again && !key.empty() && is_done(part, key, rows_[index])) {
        ++kept_;
        return;
      }
      rows_[index] = planned(part, key);
      if (!command_.quiet) {
        const std::lock_guard lock(mutex_);
        print_line(fmt::format("{:12} {}", rows_[index].verdict, part.name));
        std::fflush(stdout);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
    }
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

  BatchRow planned(const BatchPart& part, const std::string& key) const {
    for (const char* ending : {".ngc", ".json", ".svg", ".done"}) fs::remove(place(part, ending));
    std::vector<std::string> words{fs::read_symlink("/proc/self/exe").string(), "plan", part.file};
    const bool says_threads =
        std::find(plan_options_.begin(), plan_options_.end(), "--threads") != plan_options_.end();
    if (!says_threads) words.insert(words.end(), {"--threads", "1"});
    words.insert(words.end(), plan_options_.begin(), plan_options_.end());
    words.insert(words.end(), part.options.begin(), part.options.end());
    words.insert(words.end(), {"--output", place(part, ".ngc"), "--certificate", place(part, ".json"),
                               "--svg", place(part, ".svg"), "--quiet"});
    const ChildEnd end = process::run_child(words, {place(part, ".log"), "", "", false}, limits_);
    const Json done{{"key", key}, {"how", static_cast<int>(end.how)}, {"code", end.code}};
    write_files({{place(part, ".done"), done.dump() + "\n"}}, {part.file});
    return row_of(part, end);
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

  /// The last line that the command said, without its name.
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
    row.faults = certificate.at("faults").size();
    if (row.faults > 0) row.message = certificate.at("faults")[0].value("text", "");
  }

  const BatchCommand& command_;
  std::vector<BatchPart> parts_;
  std::vector<std::string> plan_options_;
  process::ChildLimits limits_;
  std::vector<BatchRow> rows_, chosen_;
  std::atomic<std::size_t> kept_ = 0;
  std::mutex mutex_;
  std::exception_ptr error_;
};

/// The options of plan that were typed, as they go to each part.
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

int run(const BatchCommand& command, const std::vector<std::string>& plan_options) {
  Batch batch(command, batch_parts(command.arguments.input(), command.output), plan_options);
  fs::create_directories(command.output);
  batch.run();
  const auto& rows = batch.rows();
  const auto at = [&](const char* name) { return (fs::path(command.output) / name).string(); };
  // A share is not the whole: the run without one, which finds all shares done, writes the overview.
  if (command.share.empty()) {
    std::vector<std::string> inputs{command.arguments.input()};
    for (const BatchRow& row : rows) inputs.push_back(row.part);
    write_outputs({{at("results.csv"), batch_csv(rows)},
                   {at("results.json"), batch_json(rows)},
                   {at("index.html"), batch_page(rows, command.arguments.input())}},
                  inputs);
  }
  print_line(batch_line(rows) + (batch.kept() > 0 ? fmt::format(" ({} as they were)", batch.kept()) : ""));
  const bool clean =
      std::all_of(rows.begin(), rows.end(), [](const BatchRow& row) { return row.verdict == "CLEAN"; });
  return clean ? kClean : kFault;
}

}  // namespace

void add_batch_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("batch", "Plan many parts, each in a process of its own");
  command->group("Planning");
  auto state = std::make_shared<BatchCommand>();
  state->arguments.add_part_options(*command, "INPUT");
  command->get_option("INPUT")->description(
      "Folder of parts, or a list: one part a line, its own options after it");
  state->arguments.add_tool_options(*command);
  state->arguments.add_cutting_options(*command);
  command->option_defaults()->group("Batch");
  std::vector<const CLI::Option*> own{
      command
          ->add_option("-o,--output", state->output,
                       "Folder for programs, certificates, pictures and overview")
          ->type_name("FOLDER")
          ->required(),
      command->add_option("--jobs", state->jobs, "Parts at once (default: all cores)")
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
          "K/N: the K-th of N shares of the parts; run once more without it for the overview"),
      command->add_flag("--again", state->again, "Plan also what is done already"),
      command->add_flag("--quiet", state->quiet, "Print the last line alone")};
  command->callback(
      [state, command, own, &exit_code] { exit_code = run(*state, typed_plan_options(*command, own)); });
}

}  // namespace clearcut::cli
