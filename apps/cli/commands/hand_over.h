// What `clearcut` leaves to the program clearcut-studies, which lies beside it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace clearcut::cli {

/// The commands of research, and `generate`: each takes whatever stands behind its name, and runs clearcut-studies with it.
void hand_over_research_commands(CLI::App& app);

/// Runs clearcut-studies in place of this program, with the arguments that this one was given. Does not come back; throws
/// InputError where that program is absent.
[[noreturn]] void run_studies(const std::string& command);

}  // namespace clearcut::cli
