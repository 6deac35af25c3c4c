// The options of the solver that orders visits, as the user types them.
#pragma once

#include <clearcut/error.h>
#include <clearcut/plan.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace clearcut::cli {

/// --solver and what belongs to the published one, for every command that orders visits.
class SolverArguments {
 public:
  void add_options(CLI::App& command);
  /// Absent: not given. Throws InputError for an unknown solver, and for settings without the published one.
  std::optional<VisitSolver> solver() const;
  /// Puts the settings that were typed without a solver's name over those of a job. Throws InputError where the job has no
  /// published solver for them.
  void refine(StepChoices& of_job) const;
  bool has_settings_alone() const { return !name_ && published_.is_set(); }

 private:
  std::optional<std::string> name_;
  PublishedSolver published_;
};

}  // namespace clearcut::cli
