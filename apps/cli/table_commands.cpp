// compare, tools and reproduce: commands that print tables.
#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/plan.h>
#include <clearcut/studies.h>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "commands.h"
#include "json_tables.h"
#include "output.h"
#include "plan_arguments.h"
#include "progress.h"
#include "suggest.h"

namespace clearcut::cli {

namespace {

const std::string kStops = "Ctrl-C stops.";

/// How the answer of a command is printed.
struct Answer {
  bool as_markdown = false;
  bool as_json = false;
  void add_options(CLI::App& command) {
    command.option_defaults()->group("Output");
    auto* page = command.add_flag("--markdown", as_markdown, "Print a Markdown table");
    command.add_flag("--json", as_json, "Print JSON")->excludes(page);
  }
};

/// What compare is asked for besides a part.
struct CompareCommand {
  PlanArguments arguments;
  Answer answer;
  int random = 0;
  std::string slower;
};

/// A pocket on which a rival is faster than ours, as an outline whose name says by how much.
void write_slower(const studies::StudyCase& one, const std::string& folder) {
  Part part = one.part;
  part.name +=
      fmt::format(", endmill:{}, contour {:.2f} s, {} {:.2f} s", part.tools.front().diameter,
                  one.outcomes.at("contour").time_s, *one.faster, one.outcomes.at(*one.faster).time_s);
  std::filesystem::create_directories(folder);
  write_outputs({{folder + "/" + std::to_string(one.seed) + ".json", write_outline_json(part)}});
}

void compare_at_random(const CompareCommand& command) {
  const auto options = command.arguments.options();
  if (command.answer.as_json)
    throw InputError("--json", "is for the comparison of a part; leave out --random");
  ProgressLine line(kStops);
  std::size_t done = 0;
  const auto study =
      studies::study_methods(command.random, options.seed, options, [&](const studies::StudyCase& one) {
        if (one.faster && !command.slower.empty()) write_slower(one, command.slower);
        line.count(++done, static_cast<std::size_t>(command.random), "pockets");
      });
  line.end();
  print_table(studies::study_table(study), command.answer.as_markdown);
}

void compare_part(const CompareCommand& command) {
  const Part part = command.arguments.read();
  const PlanOptions options = command.arguments.options();
  ProgressLine line(kStops);
  const auto runs = run_strategies(
      part, options, [&](std::size_t done, std::size_t of) { line.count(done, of, "strategies"); });
  line.end();
  if (command.answer.as_json) return print_line(strategies_json(part, runs));
  print_table(strategy_table(part, options, runs), command.answer.as_markdown);
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("compare", "Plan a part by every strategy and rival, in one table");
  command->group("Choosing");
  auto state = std::make_shared<CompareCommand>();
  state->arguments.add_part_options(*command, "INPUT");
  state->arguments.add_tool_options(*command);
  state->arguments.add_cutting_options(*command);
  command->get_option("INPUT")->required(false);
  state->answer.add_options(*command);
  command->option_defaults()->group("Study at random");
  command
      ->add_option("--random", state->random, "Compare the contour methods on so many random pockets instead")
      ->check(CLI::Range(1, 1'000'000));
  command
      ->add_option("--slower", state->slower,
                   "Folder for outlines on which a published method is faster than ours")
      ->type_name("FOLDER");
  command->callback([state, &exit_code] {
    exit_code = kClean;
    if (state->random > 0) return compare_at_random(*state);
    if (state->arguments.input().empty())
      throw InputError("compare", "give a part, or --random and how many");
    compare_part(*state);
  });
}

namespace {

struct ToolsCommand {
  PlanArguments arguments;
  ToolSpeeds speeds;
  Answer answer;
};

void compare_cutters(const ToolsCommand& command) {
  const Part part = command.arguments.read();
  const PlanOptions options = command.arguments.options();
  ProgressLine line(kStops);
  const auto comparison = compare_tools(part, command.speeds, options, [&](std::size_t done, std::size_t of) {
    line.count(done, of, "plans");
  });
  line.end();
  if (command.answer.as_json) return print_line(tools_json(part, comparison));
  print_table(tool_table(part, command.speeds, comparison), command.answer.as_markdown);
}

}  // namespace

void add_tools_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("tools", "Plan a part with each of several cutters, in one table");
  command->group("Choosing");
  auto state = std::make_shared<ToolsCommand>();
  state->arguments.add_part_options(*command, "INPUT");
  state->arguments.add_tool_options(*command);
  state->arguments.add_cutting_options(*command);
  command->option_defaults()->group("Feeds and speeds");
  command->add_option("--cutting-speed", state->speeds.cutting_speed,
                      "At the circumference, m/min: gives the spindle (default 100)");
  command->add_option("--feed-per-tooth", state->speeds.feeds_per_tooth,
                      "mm, one for each tool or one for all: gives the feed");
  command->add_option("--tool-change", state->speeds.tool_change_s, "Time of a tool change in a sequence, s")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  state->answer.add_options(*command);
  command->callback([state, &exit_code] {
    compare_cutters(*state);
    exit_code = kClean;
  });
}

namespace {

/// Each table is printed as soon as it is there.
void reproduce_all(const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    ProgressLine line(i == 0 ? kStops : "");
    line.count(i, names.size(), "tables");
    const TextTable table = studies::reproduce(names[i]);
    line.end();
    print_table(table);
  }
}

}  // namespace

void add_reproduce_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("reproduce", "Print the published tables beside our figures");
  command->group("Research");
  auto name = std::make_shared<std::string>();
  command->add_option("TABLE", *name, "One table; default all")
      ->check(one_of(studies::reproducible_tables()));
  command->callback([name, &exit_code] {
    const auto names = name->empty() ? studies::reproducible_tables() : std::vector<std::string>{*name};
    reproduce_all(names);
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
