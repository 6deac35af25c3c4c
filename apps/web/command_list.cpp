// The commands of the web build: those needed by a page. Studies, batches and the server need a real machine.
#include "commands/commands.h"
#include "research_commands.h"

namespace clearcut::cli {
namespace {

void add_whole(CLI::App& app, int& exit_code) {
  add_plan_command(app, exit_code);
  add_verify_command(app, exit_code);
  add_setup_sheet_command(app, exit_code);
  add_check_command(app, exit_code);
  add_info_command(app, exit_code);
  add_init_command(app, exit_code);
  add_convert_command(app, exit_code);
  add_elements_command(app, exit_code, nullptr);
  add_tour_command(app, exit_code);
  add_generate_command(app, exit_code, add_whole);
}

}  // namespace

void add_commands(CLI::App& app, int& exit_code, std::string_view /*named*/) {
  add_whole(app, exit_code);
}

}  // namespace clearcut::cli
