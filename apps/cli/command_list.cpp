// The commands of `clearcut`: the product's own, and those handed over to clearcut-studies.
#include "commands/commands.h"
#include "commands/research.h"

namespace clearcut::cli {

void add_commands(CLI::App& app, int& exit_code, std::string_view named) {
  if (add_product_command(app, exit_code, named)) return;
  add_product_commands(app, exit_code, [](const RandomPockets&) { run_studies("compare"); });
  hand_over_research_commands(app);
}

}  // namespace clearcut::cli
