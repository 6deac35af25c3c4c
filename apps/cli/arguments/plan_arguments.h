// The options common to plan, compare and verify, as typed by the user.
#pragma once

#include <clearcut/part.h>
#include <clearcut/plan.h>
#include <clearcut/verify.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments/certificate_info.h"
#include "arguments/option_values.h"
#include "arguments/stock_arguments.h"

namespace clearcut::cli {

/// In the place of a program: nothing was cut in the set-up.
inline constexpr const char* kNoProgram = "none";

/// The chosen one of several set-ups of a job, and data of earlier ones.
struct ChosenSetup {
  int number = 0;                             ///< from 1; 0: none was chosen
  std::vector<std::string> earlier_programs;  ///< programs of the earlier set-ups, in order, or kNoProgram
  std::vector<MachinedSetup> machined;        ///< set-ups already planned
  SetupPlace place;                           ///< place of the set-up read
  std::optional<CarriedStock> carried;        ///< stock left by earlier set-ups
};

/// The initial block of a later set-up.
enum class Block : unsigned char {
  kAsLeft,  ///< as left by the earlier set-ups
  kWhole    ///< nothing was cut yet
};

/// Number of [[setup]] tables of a job file, or of set-ups of a STEP-NC program; 0 for other files and those of one
/// set-up.
int setup_count_of(const std::string& input);

/// Raw option values; `options()` turns them into PlanOptions or throws InputError.
class PlanArguments {
 public:
  /// Every option of a plan.
  void add_plan_options(CLI::App& command);
  /// The options on the part and the tools at hand.
  void add_info_options(CLI::App& command);
  /// The options on the outlines of the part's areas: without stock, tabs and tools.
  void add_area_options(CLI::App& command);
  /// The part that a program makes, as --part, and the options that a check of the program takes.
  void add_check_options(CLI::App& command);

  /// Must be called before options(); only then do these contain the sources of a job's values.
  Part read(Block block = Block::kAsLeft) const;
  /// Stores the names of all typed options, for the origins of values.
  void take_sources(const CLI::App& command);
  /// Reads a drawing's overview, without asking for depth or roles.
  Part read_overview(DrawingOverview& overview) const;
  PlanOptions options() const;
  /// The options are for many parts: an option without effect on this part is permitted.
  void let_options_be_idle() { refuses_idle_ = false; }
  /// The typed options of the table of options.
  StatedOptions stated() const { return {typed_, values_.names()}; }
  /// A typed option that only serves planning; "" if there is none.
  std::string typed_for_planning() const;
  /// The part with the tools of the library and of the command line, where there are any, in place of its own.
  Part with_given_tools(Part part) const;
  /// The part with the tools that were typed one by one in place of its own.
  Part with_typed_tools(Part part) const;
  /// For a command that reads programs and writes none: --dialect, the control that runs them.
  void add_dialect_option(CLI::App& command);
  /// The typed dialect. Throws InputError for an unknown name.
  std::optional<Dialect> dialect() const;
  const std::string& input() const { return input_; }
  /// The project file that the input lies in; "" where it lies in none.
  const std::string& project() const { return project_; }
  /// mm; of the material, where it was typed.
  std::optional<double> top() const { return typed_.input.top; }
  /// All files on which the options are based, with their roles, including files named in a job.
  std::vector<CertificateFileName> input_files() const;
  /// Orientation of a solid, as typed.
  SolidOptions solid() const;
  /// The job file, when the input is one; of several set-ups the chosen one.
  std::optional<JobFile> job() const;

  /// The set-up chosen by --setup and --earlier-setup, or by a caller.
  ChosenSetup& setup() { return setup_; }
  const ChosenSetup& setup() const { return setup_; }

 private:
  void add_options(CLI::App& command, const std::string& input_name, const std::string& sentence,
                   const std::function<bool(const Row&)>& wanted);
  Part read_setup(const JobFile& whole, Block block) const;
  Part read_program_setup(int number, SetupPlace& place) const;
  Part on_what_is_left(Part part, Block block) const;
  std::vector<NestedPart> nested(const PlanOptions& options, const std::optional<JobFile>& from_job) const;
  std::vector<MachinedSetup> machined_before() const;
  std::optional<Dialect> control(const PostOptions& of_job) const;
  ReadOptions read_options() const;
  std::vector<Tool> tools() const;
  ToolLibrary library() const;
  Machine machine(const Machine& of_job) const;
  /// Takes the typed values, after the command line has been parsed.
  void take_values();
  /// Where the input is a project file: its part, and of its options those that nobody typed.
  void open_project();
  void take_solver(PlanOptions& options, bool has_job) const;
  void refuse_what_serves_other_inputs(const Part& part, const std::optional<JobFile>& from_job) const;

  std::string input_;
  std::string project_;
  bool refuses_idle_ = true;
  OptionValues values_;
  Asked typed_;  ///< options from the typed values only
  mutable ChosenSetup setup_;
  StockArguments stock_;
  Sources sources_;
  mutable StepChoices step_published_;  ///< likewise
  mutable StepSources step_sources_;    ///< sources of the part read
  bool reads_programs_ = false;         ///< the command has the option --dialect
  std::optional<std::string> dialect_;  ///< as typed
};

/// Only the paths.
std::vector<std::string> paths_of(const std::vector<CertificateFileName>& files);

}  // namespace clearcut::cli
