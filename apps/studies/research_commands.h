// The commands of research with their options. The web build contains those needed by a page.
#pragma once

#include <CLI/CLI.hpp>

#include "commands/commands.h"

namespace clearcut::cli {

/// `print_reductions`: prints the published table of reductions beside Clearcut's; null in builds without studies.
void add_elements_command(CLI::App& app, int& exit_code, void (*print_reductions)());
void print_grid_reductions();
void add_tour_command(CLI::App& app, int& exit_code);
void add_reproduce_command(CLI::App& app, int& exit_code);
void add_study_command(CLI::App& app, int& exit_code);
void compare_at_random(const RandomPockets& command);

}  // namespace clearcut::cli
