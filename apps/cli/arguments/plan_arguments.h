// The options that plan, compare and verify share, as the user types them.
#pragma once

#include <clearcut/part.h>
#include <clearcut/plan.h>
#include <clearcut/verify.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments/certificate_info.h"
#include "arguments/option_values.h"
#include "arguments/stock_arguments.h"

namespace clearcut::cli {

/// Which of several set-ups of a job is meant, and what is known of those before it.
struct ChosenSetup {
  int number = 0;                             ///< from 1; 0: none was chosen
  std::vector<std::string> earlier_programs;  ///< of the set-ups before, in order
  std::vector<MachinedSetup> machined;        ///< those that have been planned
  SetupPlace place;                           ///< of the set-up that was read
  std::optional<CarriedStock> carried;        ///< what the ones before leave to it
};

/// What a later set-up begins with.
enum class Block : unsigned char {
  kAsLeft,  ///< by the set-ups before
  kWhole    ///< nothing was cut yet
};

/// How many [[setup]] a job file has, or set-ups a STEP-NC program; 0 for other files and those of one set-up.
int setup_count_of(const std::string& input);

/// Raw option values; `options()` turns them into PlanOptions or throws InputError.
class PlanArguments {
 public:
  void add_part_options(CLI::App& command, const std::string& input_name);
  /// Which tools there are; add_tool_options adds these, too.
  void add_tool_list_options(CLI::App& command);
  void add_tool_options(CLI::App& command);
  void add_cutting_options(CLI::App& command);
  /// Which steps the work has: what goes before, narrower mills, finishing.
  void add_steps_options(CLI::App& command);

  /// Before options(), which tell where the values of a job stand only then.
  Part read(Block block = Block::kAsLeft) const;
  /// The names of all options that were typed, for the origins of values.
  void take_sources(const CLI::App& command);
  /// Of a drawing, without asking for depth or roles.
  Part read_overview(DrawingOverview& overview) const;
  PlanOptions options() const;
  /// The options are for many parts: one that has no effect on this part is none the worse.
  void let_options_be_idle() { refuses_idle_ = false; }
  /// What was typed of the options' table.
  StatedOptions stated() const { return {typed_, values_.names()}; }
  /// An option that was typed and serves planning alone; "" where none was.
  std::string typed_for_planning() const;
  /// The part with the tools of the library and of the command line, where there are any, in place of its own.
  Part with_given_tools(Part part) const;
  /// The part with the tools that were typed one by one in place of its own.
  Part with_typed_tools(Part part) const;
  /// Of a command that reads programs and writes none: --dialect, which control runs them.
  void add_dialect_option(CLI::App& command);
  /// As it was typed. Throws InputError for a name that no control has.
  std::optional<read::gcode::Dialect> dialect() const;
  const std::string& input() const { return input_; }
  /// The project file that the input lies in; "" where it lies in none.
  const std::string& project() const { return project_; }
  /// mm; of the material, where it was typed.
  std::optional<double> top() const { return typed_.input.top; }
  /// Every file that the options rest on, by its role, those that a job names included.
  std::vector<CertificateFileName> input_files() const;
  /// How a solid lies, as typed.
  SolidOptions solid() const;
  /// The job file, when the input is one; of several set-ups the chosen one.
  std::optional<JobFile> job() const;

  /// As --setup and --earlier-setup say, or a caller.
  ChosenSetup& setup() { return setup_; }
  const ChosenSetup& setup() const { return setup_; }

 private:
  Part read_setup(const JobFile& whole, Block block) const;
  Part read_program_setup(int number, SetupPlace& place) const;
  Part on_what_is_left(Part part, Block block) const;
  std::vector<MachinedSetup> machined_before() const;
  std::optional<read::gcode::Dialect> control(const PostOptions& of_job) const;
  ReadOptions read_options() const;
  std::vector<Tool> tools() const;
  ToolLibrary library() const;
  Machine machine(const Machine& of_job) const;
  /// What was typed, once the command line has been parsed.
  void take_values();
  /// Where the input is a project file: its part, and of its options those that nobody typed.
  void open_project();
  void take_solver(PlanOptions& options, bool has_job) const;
  void refuse_what_serves_other_inputs(const Part& part, const std::optional<JobFile>& from_job) const;

  std::string input_;
  std::string project_;
  bool refuses_idle_ = true;
  OptionValues values_;
  Asked typed_;  ///< what the values say by themselves
  mutable ChosenSetup setup_;
  StockArguments stock_;
  Sources sources_;
  mutable StepChoices step_published_;  ///< likewise
  mutable StepSources step_sources_;    ///< of the part that was read
  bool reads_programs_ = false;         ///< there is --dialect
  std::optional<std::string> dialect_;  ///< as it was typed
};

/// The paths alone.
std::vector<std::string> paths_of(const std::vector<CertificateFileName>& files);

}  // namespace clearcut::cli
