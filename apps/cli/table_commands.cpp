// compare and reproduce: commands that print tables.
#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/plan.h>
#include <clearcut/studies.h>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

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
  auto name = std::make_shared<std::string>();
  command->add_option("TABLE", *name, "One table; default all");
  command->callback([name, &exit_code] {
    const auto names = name->empty() ? studies::reproducible_tables() : std::vector<std::string>{*name};
    for (const auto& table : names) print_line(plain(studies::reproduce(table)));
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
