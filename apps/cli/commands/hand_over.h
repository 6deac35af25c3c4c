// Commands that `clearcut` leaves to the program clearcut-studies beside it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace clearcut::cli {

/// The commands of research, and `generate`: each passes all arguments after its name to clearcut-studies.
void hand_over_research_commands(CLI::App& app);

/// Runs clearcut-studies in place of this program, with the same arguments. Does not return; throws InputError if
/// clearcut-studies is absent.
[[noreturn]] void run_studies(const std::string& command);

}  // namespace clearcut::cli
