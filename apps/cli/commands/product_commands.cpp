#include <span>

#include "commands/commands.h"

namespace clearcut::cli {
namespace {

struct ProductCommand {
  const char* name;
  void (*add)(CLI::App& app, int& exit_code);
};

/// All but `compare`, which needs a function for its studies; in the order of the list of commands.
constexpr ProductCommand kBeforeCompare[] = {
    {"plan", add_plan_command},   {"batch", add_batch_command},   {"infill", add_infill_command},
    {"feeds", add_feeds_command}, {"resume", add_resume_command}, {"setup-sheet", add_setup_sheet_command},
    {"serve", add_serve_command}, {"verify", add_verify_command}, {"check", add_check_command},
    {"info", add_info_command},   {"init", add_init_command},     {"convert", add_convert_command}};
constexpr ProductCommand kAfterCompare[] = {{"tools", add_tools_command}, {"machines", add_machines_command}};

}  // namespace

void add_product_commands(CLI::App& app, int& exit_code, void (*at_random)(const RandomPockets&)) {
  for (const ProductCommand& command : kBeforeCompare) command.add(app, exit_code);
  add_compare_command(app, exit_code, at_random);
  for (const ProductCommand& command : kAfterCompare) command.add(app, exit_code);
}

bool add_product_command(CLI::App& app, int& exit_code, std::string_view name) {
  const auto add_from = [&](std::span<const ProductCommand> commands) {
    for (const ProductCommand& command : commands)
      if (name == command.name) {
        command.add(app, exit_code);
        return true;
      }
    return false;
  };
  return add_from(kBeforeCompare) || add_from(kAfterCompare);
}

}  // namespace clearcut::cli
