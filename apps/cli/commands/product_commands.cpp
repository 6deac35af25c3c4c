#include "commands/commands.h"

namespace clearcut::cli {

void add_product_commands(CLI::App& app, int& exit_code, void (*at_random)(const RandomPockets&)) {
  add_plan_command(app, exit_code);
  add_batch_command(app, exit_code);
  add_infill_command(app, exit_code);
  add_feeds_command(app, exit_code);
  add_resume_command(app, exit_code);
  add_setup_sheet_command(app, exit_code);
  add_serve_command(app, exit_code);
  add_verify_command(app, exit_code);
  add_check_command(app, exit_code);
  add_info_command(app, exit_code);
  add_init_command(app, exit_code);
  add_convert_command(app, exit_code);
  add_compare_command(app, exit_code, at_random);
  add_tools_command(app, exit_code);
  add_machines_command(app, exit_code);
}

}  // namespace clearcut::cli
