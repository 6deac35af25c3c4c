// The commands of research, contained in the program clearcut-studies, as listed by both programs, and the commands
// that `clearcut` leaves to that program.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace clearcut::cli {

struct ResearchCommand {
  const char* name;
  const char* group;     ///< group in the list of commands
  const char* sentence;  ///< description
};

inline constexpr ResearchCommand kElements{"elements", "Grids and tours",
                                           "Plan a job of design elements on a grid of squares"};
inline constexpr ResearchCommand kTour{"tour", "Grids and tours",
                                       "Order points: a TSPLIB file or a lattice such as 10x10"};
inline constexpr ResearchCommand kReproduce{"reproduce", "Research",
                                            "Print the published tables beside our figures"};
inline constexpr ResearchCommand kStudy{
    "study", "Research", "Repeat a Monte-Carlo study of the published genetic algorithm on square lattices"};

/// The subcommand with only its name, group and sentence.
inline CLI::App* add_research_command(CLI::App& app, const ResearchCommand& command) {
  auto* added = app.add_subcommand(command.name, command.sentence);
  added->group(command.group);
  return added;
}

/// The commands of research, and `generate`: each passes all arguments after its name to clearcut-studies.
void hand_over_research_commands(CLI::App& app);

/// Runs clearcut-studies in place of this program, with the same arguments. Does not return; throws InputError if
/// clearcut-studies is absent.
[[noreturn]] void run_studies(const std::string& command);

}  // namespace clearcut::cli
