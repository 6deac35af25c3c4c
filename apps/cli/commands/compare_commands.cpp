// compare and tools: several plans of a part, in one table.
#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/plan.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include "arguments/option_values.h"
#include "arguments/plan_arguments.h"
#include "commands/commands.h"
#include "terminal/json_tables.h"
#include "terminal/output.h"
#include "terminal/progress.h"

namespace clearcut::cli {

namespace {

/// Form of a command's printed answer.
struct Answer {
  bool as_markdown = false;
  bool as_json = false;
  void add_options(CLI::App& command) {
    command.option_defaults()->group("Output");
    auto* page = command.add_flag("--markdown", as_markdown, "Print a Markdown table");
    command.add_flag("--json", as_json, "Print JSON")->excludes(page);
  }
};

/// Options of compare in addition to the part.
struct CompareCommand {
  PlanArguments arguments;
  Answer answer;
  RandomPockets random;
};

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

void add_compare_command(CLI::App& app, int& exit_code, void (*at_random)(const RandomPockets&)) {
  auto* command =
      app.add_subcommand("compare", "Plan a part with every strategy and published method, in one table");
  command->group("Choosing");
  auto state = std::make_shared<CompareCommand>();
  state->arguments.add_plan_options(*command);
  command->get_option("INPUT")->required(false);
  state->answer.add_options(*command);
  command->option_defaults()->group("Study at random");
  command
      ->add_option("--random", state->random.count,
                   "Compare the contour methods on this number of random pockets instead")
      ->check(CLI::Range(1, 1'000'000));
  command
      ->add_option("--slower", state->random.slower,
                   "Folder for outlines on which a published method is faster than Clearcut's")
      ->type_name("FOLDER");
  command->callback([state, at_random, &exit_code] {
    exit_code = kClean;
    if (state->random.count > 0) {
      if (state->answer.as_json)
        throw InputError("--json", "is for the comparison of a part; leave out --random");
      state->random.options = state->arguments.options();
      state->random.as_markdown = state->answer.as_markdown;
      return at_random(state->random);
    }
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
  state->arguments.add_plan_options(*command);
  command->option_defaults()->group("Feeds and speeds");
  command->add_option("--cutting-speed", state->speeds.cutting_speed,
                      "Cutting speed, m/min, from which the spindle speed follows (default 100)");
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

}  // namespace clearcut::cli
