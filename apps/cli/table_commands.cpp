// compare and reproduce: commands that print tables.
#include <memory>

#include "commands.h"
#include "output.h"
#include "pipeline/compare.h"
#include "pipeline/reproduce.h"
#include "plan_arguments.h"

namespace clearcut::cli {

void add_compare_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("compare", "Plan a part by every strategy and rival, in one table");
  auto state = std::make_shared<PlanArguments>();
  auto as_markdown = std::make_shared<bool>(false);
  state->add_part_options(*command, "INPUT");
  state->add_tool_options(*command);
  state->add_cutting_options(*command);
  command->add_flag("--markdown", *as_markdown, "Print a Markdown table");
  command->callback([state, as_markdown, &exit_code] {
    const auto table = compare(state->read(), state->options());
    print_line(*as_markdown ? markdown(table) : plain(table));
    exit_code = kClean;
  });
}

void add_reproduce_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("reproduce", "Print the published tables beside our figures");
  auto name = std::make_shared<std::string>();
  command->add_option("TABLE", *name, "One table; default all");
  command->callback([name, &exit_code] {
    const auto names = name->empty() ? reproducible_tables() : std::vector<std::string>{*name};
    for (const auto& table : names) print_line(plain(reproduce(table)));
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
