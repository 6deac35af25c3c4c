// Job files: part, stock, tools, machine and operations in one TOML; see docs/input.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "model/machine.h"
#include "model/options/origin.h"
#include "model/part.h"
#include "options/plan_options.h"
#include "options/row.h"
#include "read/common/moved_part.h"
#include "read/common/read_options.h"
#include "read/tools/tool_library.h"

namespace clearcut::read {

/// Settings for cutting, for all operations ([plan]) or those of some features ([[operation]]). Absent values are
/// taken from the next source: operation, plan, the part's file, the planner's defaults.
struct CutSettings {
  PlanOptions asked;        ///< options permitted in operations
  std::optional<int> tool;  ///< number
  std::optional<OperationKind> kind;
  Sources sources;  ///< "job.toml:12" of each key
};

/// [[operation]]: settings for the workingsteps of all matching features.
struct OperationRule {
  std::string feature = "*";  ///< name, * for anything, any case
  bool skip = false;          ///< not machined at all
  CutSettings settings;
  int line = 0;
};

/// Files to be written, as given; relative to the job's folder.
struct JobOutput {
  std::optional<std::string> program, certificate, svg, report, setup_sheet, result, witness;
};

struct JobStock {
  std::optional<std::array<double, 2>> x, y, z;  ///< mm
  std::optional<double> margin;                  ///< mm around the features if x or y is absent
};

/// A job as stated in its file; no other file is read yet.
struct JobFile {
  std::string file;
  std::filesystem::path part_file;  ///< found from the job's folder
  ReadOptions read;
  std::optional<JobStock> stock;
  std::optional<double> clearance_z;
  std::vector<LibraryTool> tools;  ///< [[tool]]
  std::optional<std::filesystem::path> tool_library;
  ToolOptions tool_options;
  std::vector<int> tool_numbers;  ///< tool numbers of the library, in order; empty: all
  std::string preset;             ///< name of the library's preset; "": the first
  std::optional<std::filesystem::path> machine_file;
  Machine machine;
  CutSettings plan;
  std::vector<OperationRule> operations;
  std::vector<std::string> sequence;  ///< names of features (with *) in the order of work; empty: free
  JobOutput output;
  PlanOptions whole;  ///< options of [plan], [machine] and [output] for the whole plan
  std::optional<std::filesystem::path> after;       ///< earlier program, relative to the job's folder
  std::optional<std::filesystem::path> stock_from;  ///< file of the stock, likewise
  std::vector<std::string> stated_keep_outs,
      stated_predrilled;                   ///< predrilled holes of [plan], in the words of the command line
  std::vector<KeepOut> keep_outs;          ///< [[keep_out]]
  std::vector<PredrilledHole> predrilled;  ///< [[predrilled]]
  std::optional<ZeroPoint> zero;           ///< absent: the zero of the part's file
  std::string setup_name;                  ///< name of one of several set-ups
  int setup_number = 0;                    ///< from 1; 0: the job is one set-up
  bool has_own_stock = false;              ///< the set-up states the place of its block
  /// [[setup]]: each a job of its own; the job itself is then as the first of them.
  std::vector<JobFile> setups;
  Sources sources;       ///< sources of the keys of [plan], [machine] and [output], and of its machine file
  Sources part_sources;  ///< sources of the keys of [part]
};

/// Throws  InputError "file:line: ..." for bad TOML, unknown keys (with the nearest known one) and
///         impossible values.
JobFile read_job_text(std::string_view text, const std::string& file_name);
JobFile read_job(const std::filesystem::path& file);

/// The part of a job: its file read, stock and tools set, operations chosen. All of job.plan is in the operations
/// afterwards, with their places as sources; machine, output and the planner's values are left to the caller. `over`:
/// options with precedence over the job's own (command line). Throws as read_part and read_tool_library, and if a
/// tool number or a feature name has no match.
Part part_of_job(const JobFile& job, const ReadOptions& over);

/// The same; afterwards `sources` contains the sources of all values stated by the job or its tool library,
/// `published` the job's choices of published methods.
Part part_of_job(const JobFile& job, const ReadOptions& over, StepSources& sources, StepChoices& published);
/// The job's own tools, then the used ones of its library: the tools of its part, in their order.
std::vector<LibraryTool> tools_of_job(const JobFile& job);

/// Stated options, by the names of their rows.
struct StatedOptions {
  Asked asked;
  std::set<std::string> names;
};

/// A commented job for `part`, read from `part_file`: valid without changes, with every key and its default; `stated`
/// options are written as keys, so that a plan of the job equals the plan with those options.
std::string job_text(const Part& part, const std::string& part_file, const StatedOptions& stated = {});

}  // namespace clearcut::read
