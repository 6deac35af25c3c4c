// The options that plan, compare and verify share, as the user types them.
#pragma once

#include <clearcut/part.h>
#include <clearcut/plan.h>
#include <clearcut/verify.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments/certificate_info.h"
#include "arguments/post_arguments.h"
#include "arguments/solver_arguments.h"
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

/// How many [[setup]] a job file has; 0 for other files and jobs of one set-up.
int setup_count_of(const std::string& input);

/// What is typed of that which holds what profiles cut free.
struct TabArguments {
  std::optional<int> count;
  std::optional<double> spacing, width, height, skin;
  std::optional<std::string> shape;
  std::vector<std::string> at;

  void take(TabOptions& tabs) const;
};

/// What is typed of strategies, passes and feeds.
struct CuttingArguments {
  std::optional<std::string> strategy;
  std::optional<std::string> stepover;
  std::optional<double> angle;
  std::optional<double> stepdown;
  std::optional<double> allowance;
  std::optional<double> allowance_floor;
  std::optional<double> engagement;
  std::optional<std::string> entry;
  std::optional<double> entry_angle;
  std::optional<double> lead;
  std::optional<double> lead_angle;
  std::optional<double> scallop;
  std::optional<std::string> direction;
  std::optional<std::string> order;
  std::optional<std::string> start;
  std::optional<double> feed;
  std::optional<double> plunge_feed;
  std::optional<double> ramp_feed;
  std::optional<double> slot_feed;
  std::optional<double> spindle;
  std::optional<std::string> coolant;
  std::optional<std::string> objective;

  /// Puts what was typed into `options`.
  void take(PlanOptions& options) const;
};

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
  void add_predrilled_option(CLI::App& command);

  /// Before options(), which tell where the values of a job stand only then.
  Part read(Block block = Block::kAsLeft) const;
  /// The names of all options that were typed, for the origins of values.
  void take_sources(const CLI::App& command);
  /// Of a drawing, without asking for depth or roles.
  Part read_overview(DrawingOverview& overview) const;
  PlanOptions options() const;
  /// Of a command that reads programs and writes none: --dialect, which control runs them.
  void add_dialect_option(CLI::App& command);
  /// As it was typed. Throws InputError for a name that no control has.
  std::optional<read::gcode::Dialect> dialect() const;
  const std::string& input() const { return input_; }
  /// mm; of the material, where it was typed.
  std::optional<double> top() const { return top_; }
  /// Every file that the options rest on, by its role, those that a job names included.
  std::vector<CertificateFileName> input_files() const;
  const SolidOptions& solid() const { return solid_; }
  /// The job file, when the input is one; of several set-ups the chosen one.
  std::optional<JobFile> job() const;

  /// As --setup and --earlier-setup say, or a caller.
  ChosenSetup& setup() { return setup_; }
  const ChosenSetup& setup() const { return setup_; }

 private:
  Part read_setup(const JobFile& whole, Block block) const;
  std::vector<MachinedSetup> machined_before(const JobFile& whole) const;
  std::optional<read::gcode::Dialect> control(const PostOptions& of_job) const;
  ReadOptions read_options() const;
  void add_drawing_options(CLI::App& command);
  std::vector<Tool> tools() const;
  ToolLibrary library() const;
  void add_strategy_options(CLI::App& command);
  void add_shop_options(CLI::App& command);
  void add_entry_options(CLI::App& command);
  void add_lead_options(CLI::App& command);
  void add_feed_options(CLI::App& command);
  void add_stage_options(CLI::App& command);
  void add_search_options(CLI::App& command);
  Machine machine(const Machine& of_job) const;
  ShopOptions shop(const ShopOptions& of_job) const;

  std::string input_;
  std::optional<std::string> zero_;
  mutable ChosenSetup setup_;
  Sources typed_;
  mutable StepChoices step_published_;  ///< likewise
  mutable StepSources step_sources_;    ///< of the part that was read
  std::vector<std::string> tools_;
  std::optional<std::string> unit_;
  std::vector<std::string> layers_;
  std::vector<std::string> operations_;
  std::optional<double> scale_;
  bool mirror_ = false;
  std::optional<double> join_gap_;
  std::optional<std::string> open_curves_;
  std::optional<std::string> strokes_;
  std::optional<std::string> text_;
  CuttingArguments cutting_;
  TabArguments tabs_;
  std::optional<double> top_;
  std::optional<double> depth_;
  SolidOptions solid_;
  std::optional<std::string> tool_library_;
  std::optional<std::string> machine_file_, machine_kind_;
  std::vector<std::string> accept_;
  std::vector<std::string> predrilled_;
  std::vector<std::string> keep_outs_;
  std::optional<double> lead_feed_;
  std::optional<double> link_feed_;
  StockArguments stock_;
  bool rest_ = false;
  ShopOptions shop_;
  std::optional<std::string> passage_;
  std::optional<std::string> grid_;
  SolverArguments solver_;
  std::optional<double> acceleration_;
  std::optional<double> junction_deviation_;
  std::optional<double> rapid_feed_;
  PostArguments post_;
  bool reads_programs_ = false;  ///< there is --dialect
  std::optional<std::string> dialect_;
  std::optional<double> clearance_z_;
  std::optional<double> time_;
  std::optional<std::uint64_t> seed_;
  int threads_ = 0;
};

/// The paths alone.
std::vector<std::string> paths_of(const std::vector<CertificateFileName>& files);

}  // namespace clearcut::cli
