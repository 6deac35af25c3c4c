// compare and reproduce: commands that print tables.
#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/plan.h>
#include <clearcut/studies.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "commands.h"
#include "output.h"
#include "plan_arguments.h"

namespace clearcut::cli {

namespace {

/// What compare is asked for besides a part.
struct CompareCommand {
  PlanArguments arguments;
  bool as_markdown = false;
  int random = 0;
  std::string slower;
};

void print_table(const TextTable& table, bool as_markdown) {
  print_line(as_markdown ? markdown(table) : plain(table));
}

/// A pocket on which a rival is faster than ours, as an outline whose name says by how much.
void write_slower(const studies::StudyCase& one, const std::string& folder) {
  Part part = one.part;
  part.name +=
      fmt::format(", endmill:{}, contour {:.2f} s, {} {:.2f} s", part.tools.front().diameter,
                  one.outcomes.at("contour").time_s, *one.faster, one.outcomes.at(*one.faster).time_s);
  std::filesystem::create_directories(folder);
  write_outputs({{folder + "/" + std::to_string(one.seed) + ".json", write_outline_json(part)}}, {});
}

void compare_at_random(const CompareCommand& command) {
  const auto options = command.arguments.options();
  const auto study =
      studies::study_methods(command.random, options.seed, options, [&](const studies::StudyCase& one) {
        if (one.faster && !command.slower.empty()) write_slower(one, command.slower);
      });
  print_table(studies::study_table(study), command.as_markdown);
}

/// What reproduce is asked for.
struct ReproduceCommand {
  std::vector<std::string> names;
  bool list = false;
  bool all = false;
  bool quiet = false;
  bool resume = false;
  std::string json;
  std::string html;
};

/// Says on standard error every few seconds that a table is still being made.
class SignOfLife {
 public:
  explicit SignOfLife(std::string what) : what_(std::move(what)), thread_([this] { tell(); }) {}
  ~SignOfLife() {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }
  SignOfLife(const SignOfLife&) = delete;
  SignOfLife& operator=(const SignOfLife&) = delete;

 private:
  void tell() {
    constexpr int kEverySeconds = 3;
    std::unique_lock lock(mutex_);
    for (int seconds = kEverySeconds;; seconds += kEverySeconds) {
      if (changed_.wait_for(lock, std::chrono::seconds(kEverySeconds), [this] { return done_; })) return;
      fmt::print(stderr, "{}: {} s\n", what_, seconds);
    }
  }
  std::string what_;
  bool done_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;  // last: it uses the others
};

TextTable list_of_tables() {
  TextTable table;
  table.columns = {
      {"name", report::Align::kLeft}, {"in the texts", report::Align::kLeft}, {"seconds of a core"}};
  for (const auto& one : studies::reproducible_tables())
    table.add({one.name + (one.is_long ? " *" : ""), one.place, fmt::format("{:g}", one.cost_s)});
  table.notes.emplace_back("*: runs by name or with --all");
  return table;
}

std::vector<const studies::ReproducibleTable*> chosen_tables(const ReproduceCommand& command) {
  std::vector<const studies::ReproducibleTable*> tables;
  for (const auto& name : command.names) tables.push_back(&studies::reproducible_table(name));
  if (!tables.empty()) return tables;
  for (const auto& table : studies::reproducible_tables())
    if (command.all || !table.is_long) tables.push_back(&table);
  return tables;
}

/// Made now, or kept from an earlier run.
studies::NamedReproduction reproduction(const studies::ReproducibleTable& table,
                                        const std::vector<studies::NamedReproduction>& kept, bool is_quiet) {
  for (const auto& one : kept)
    if (one.name == table.name) return one;
  std::optional<SignOfLife> sign;
  if (!is_quiet) sign.emplace(fmt::format("reproduce {}, about {:g} s", table.name, table.cost_s));
  return {table.name, table.place, table.make()};
}

/// Tables of an earlier run that was asked to write the same file; none where there is no such file yet.
std::vector<studies::NamedReproduction> kept_tables(const ReproduceCommand& command) {
  if (!command.resume) return {};
  if (command.json.empty() || command.json == "-")
    throw InputError("--resume", "takes up the tables of a file; add --json FILE");
  if (!std::filesystem::exists(command.json)) return {};
  return studies::read_reproduction_json(read_file(command.json), command.json);
}

bool is_among(const std::vector<const studies::ReproducibleTable*>& tables, const std::string& name) {
  return std::any_of(tables.begin(), tables.end(), [&](const auto* table) { return table->name == name; });
}

void print_reproduction(const studies::Reproduction& reproduction) {
  auto text = reproduction.table;
  if (!reproduction.compared.empty()) text.notes.push_back(reproduction.summary());
  print_line(plain(text));
  std::fflush(stdout);
}

/// The JSON file is there after every table, so that a run that is broken off can be taken up again.
void reproduce_tables(const ReproduceCommand& command) {
  if (command.list) return print_line(plain(list_of_tables()));
  const bool is_file = !command.json.empty() && command.json != "-";
  const auto kept = kept_tables(command);
  const auto tables = chosen_tables(command);
  std::vector<studies::NamedReproduction> made;
  for (const auto& one : kept)
    if (!is_among(tables, one.name)) made.push_back(one);
  for (const auto* table : tables) {
    made.push_back(reproduction(*table, kept, command.quiet));
    if (command.json != "-" && command.html != "-") print_reproduction(made.back().reproduction);
    if (is_file) write_outputs({{command.json, studies::reproduction_json(made)}}, {});
  }
  if (command.json == "-") write_outputs({{command.json, studies::reproduction_json(made)}}, {});
  if (!command.html.empty()) write_outputs({{command.html, studies::reproduction_page(made)}}, {});
  if (command.quiet || !command.names.empty() || command.all) return;
  for (const auto& table : studies::reproducible_tables())
    if (table.is_long) fmt::print(stderr, "not run, it is long: clearcut reproduce {}\n", table.name);
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("compare", "Plan a part by every strategy and rival, in one table");
  auto state = std::make_shared<CompareCommand>();
  state->arguments.add_part_options(*command, "INPUT");
  state->arguments.add_tool_options(*command);
  state->arguments.add_cutting_options(*command);
  command->get_option("INPUT")->required(false);
  command->add_flag("--markdown", state->as_markdown, "Print a Markdown table");
  command
      ->add_option("--random", state->random, "Compare the contour methods on so many random pockets instead")
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--slower", state->slower,
                      "Folder for outlines on which a published method is faster than ours");
  command->callback([state, &exit_code] {
    exit_code = kClean;
    if (state->random > 0) return compare_at_random(*state);
    if (state->arguments.input().empty())
      throw InputError("compare", "give a part, or --random and how many");
    print_table(compare_strategies(state->arguments.read(), state->arguments.options()), state->as_markdown);
  });
}

void add_tools_command(CLI::App& app, int& exit_code) {
  struct ToolsCommand {
    PlanArguments arguments;
    ToolSpeeds speeds;
    bool as_markdown = false;
  };
  auto* command = app.add_subcommand("tools", "Plan a part with each of several cutters, in one table");
  auto state = std::make_shared<ToolsCommand>();
  state->arguments.add_part_options(*command, "INPUT");
  state->arguments.add_tool_options(*command);
  state->arguments.add_cutting_options(*command);
  command->add_option("--cutting-speed", state->speeds.cutting_speed,
                      "At the circumference, m/min: gives the spindle");
  command->add_option("--feed-per-tooth", state->speeds.feeds_per_tooth,
                      "mm, one for each tool or one for all: gives the feed");
  command->add_option("--tool-change", state->speeds.tool_change_s, "Time of a tool change in a sequence, s")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--markdown", state->as_markdown, "Print a Markdown table");
  command->callback([state, &exit_code] {
    print_table(tool_table(state->arguments.read(), state->speeds, state->arguments.options()),
                state->as_markdown);
    exit_code = kClean;
  });
}

void add_reproduce_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("reproduce", "Print the published tables beside our figures");
  auto state = std::make_shared<ReproduceCommand>();
  command->add_option("TABLE", state->names, "Tables by name; default all but the long ones");
  command->add_flag("--list", state->list, "List the tables and what each costs, and run nothing");
  command->add_flag("--all", state->all, "The long ones, too");
  command->add_option("--json", state->json, "Tables with every printed cell judged to write (JSON)");
  command->add_option("--html", state->html, "The same as one page to write");
  command->add_flag("--resume", state->resume,
                    "Keep the tables that the file of --json has already, make the others");
  command->add_flag("--quiet", state->quiet, "No progress");
  command->callback([state, &exit_code] {
    reproduce_tables(*state);
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
