// The commands of clearcut-studies. It also prints the man page, the completions and the list of options, since it is
// the only program with the options of every command.
#include "commands/commands.h"
#include "research_commands.h"

namespace clearcut::cli {
namespace {

void add_research(CLI::App& app, int& exit_code) {
  add_elements_command(app, exit_code, print_grid_reductions);
  add_tour_command(app, exit_code);
  add_reproduce_command(app, exit_code);
  add_study_command(app, exit_code);
}

/// All commands of `clearcut`, with all options.
void add_whole(CLI::App& app, int& exit_code) {
  add_product_commands(app, exit_code, compare_at_random);
  add_research(app, exit_code);
}

}  // namespace

void add_commands(CLI::App& app, int& exit_code, std::string_view /*named*/) {
  add_compare_command(app, exit_code, compare_at_random);
  add_research(app, exit_code);
  add_generate_command(app, exit_code, add_whole);
}

}  // namespace clearcut::cli
