// The subcommands. Each adds itself to the application; if it is chosen its callback sets `exit_code`.
#pragma once

#include <clearcut/plan.h>
#include <clearcut/verify.h>

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace clearcut::cli {

inline constexpr int kClean = 0;     ///< done and certified clean
inline constexpr int kFault = 1;     ///< done, but the verdict is not CLEAN: a fault, or an open condition
inline constexpr int kUnusable = 2;  ///< unusable input or arguments; nothing written
inline constexpr int kInternal = 3;  ///< internal fault

inline int exit_code_of(const Findings& findings) {
  return verdict_of(findings) == Verdict::kClean ? kClean : kFault;
}

/// The commands of a program: clearcut (command_list.cpp), clearcut-studies (apps/studies) or the page (apps/web).
/// `named`: the command that was called, "" if none; others may be left out then, since their options take longer to
/// declare than small parts to read.
void add_commands(CLI::App& app, int& exit_code, std::string_view named);

void add_plan_command(CLI::App& app, int& exit_code);
void add_verify_command(CLI::App& app, int& exit_code);
void add_feeds_command(CLI::App& app, int& exit_code);
void add_resume_command(CLI::App& app, int& exit_code);
void add_setup_sheet_command(CLI::App& app, int& exit_code);
void add_check_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
/// Options of `compare --random`.
struct RandomPockets {
  int count = 0;       ///< 0: a part is compared
  std::string slower;  ///< folder for pockets on which a published method is faster than Clearcut's; "": none
  PlanOptions options;
  bool as_markdown = false;
};
/// `at_random`: compares the methods on random pockets, for research.
void add_compare_command(CLI::App& app, int& exit_code, void (*at_random)(const RandomPockets&));
void add_tools_command(CLI::App& app, int& exit_code);
void add_machines_command(CLI::App& app, int& exit_code);
void add_convert_command(CLI::App& app, int& exit_code);
void add_infill_command(CLI::App& app, int& exit_code);
void add_init_command(CLI::App& app, int& exit_code);
/// All commands of `clearcut` but research. `at_random` as add_compare_command.
void add_product_commands(CLI::App& app, int& exit_code, void (*at_random)(const RandomPockets&));
/// Adds one of them by its name; false if there is no such command that needs nothing else.
bool add_product_command(CLI::App& app, int& exit_code, std::string_view name);
/// Hidden. `add_whole`: adds all commands described in pages, completions and the list of options.
void add_generate_command(CLI::App& app, int& exit_code, void (*add_whole)(CLI::App&, int&));
void add_serve_command(CLI::App& app, int& exit_code);
void add_batch_command(CLI::App& app, int& exit_code);

}  // namespace clearcut::cli
