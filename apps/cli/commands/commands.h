// The subcommands. Each adds itself to the application; when it is chosen its callback sets `exit_code`.
#pragma once

#include <clearcut/verify.h>

#include <CLI/CLI.hpp>

namespace clearcut::cli {

inline constexpr int kClean = 0;     ///< done and certified clean
inline constexpr int kFault = 1;     ///< done, but the verdict is not CLEAN: a fault, or an open condition
inline constexpr int kUnusable = 2;  ///< unusable input or arguments; nothing written
inline constexpr int kInternal = 3;  ///< internal fault

inline int exit_code_of(const Findings& findings) {
  return verdict_of(findings) == Verdict::kClean ? kClean : kFault;
}

/// All of them; the web build has fewer (apps/web).
void add_commands(CLI::App& app, int& exit_code);

void add_plan_command(CLI::App& app, int& exit_code);
void add_verify_command(CLI::App& app, int& exit_code);
void add_feeds_command(CLI::App& app, int& exit_code);
void add_setup_sheet_command(CLI::App& app, int& exit_code);
void add_check_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
/// `print_reductions`: prints the published table of reductions beside ours; null in builds without studies.
void add_elements_command(CLI::App& app, int& exit_code, void (*print_reductions)());
void print_grid_reductions();
void add_compare_command(CLI::App& app, int& exit_code);
void add_tools_command(CLI::App& app, int& exit_code);
void add_machines_command(CLI::App& app, int& exit_code);
void add_reproduce_command(CLI::App& app, int& exit_code);
void add_convert_command(CLI::App& app, int& exit_code);
void add_init_command(CLI::App& app, int& exit_code);
void add_tour_command(CLI::App& app, int& exit_code);
void add_study_command(CLI::App& app, int& exit_code);
void add_generate_command(CLI::App& app, int& exit_code);
void add_serve_command(CLI::App& app, int& exit_code);
void add_batch_command(CLI::App& app, int& exit_code);

}  // namespace clearcut::cli
