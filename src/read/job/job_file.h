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
#include "read/moved_part.h"
#include "read/read_options.h"
#include "read/tools/tool_library.h"

namespace clearcut::read {

/// How to cut, for all operations ([plan]) or those of some features ([[operation]]). Absent values are
/// left to what stands above them: operation, plan, the part's file, the planner's defaults.
struct CutSettings {
  PlanOptions asked;        ///< of the options that operations may have
  std::optional<int> tool;  ///< number
  std::optional<OperationKind> kind;
  Sources sources;  ///< "job.toml:12" of each key
};

/// [[operation]]: settings for the workingsteps of all features that match.
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
  std::optional<double> margin;                  ///< mm around the features where x or y is absent
};

/// A job as its file says it; nothing else read yet.
struct JobFile {
  std::string file;
  std::filesystem::path part_file;  ///< found from the job's folder
  ReadOptions read;
  std::optional<JobStock> stock;
  std::optional<double> clearance_z;
  std::vector<LibraryTool> tools;  ///< [[tool]]
  std::optional<std::filesystem::path> tool_library;
  ToolOptions tool_options;
  std::vector<int> tool_numbers;  ///< of the library, in order; empty: all
  std::string preset;             ///< name of the library's preset; "": the first
  std::optional<std::filesystem::path> machine_file;
  Machine machine;
  CutSettings plan;
  std::vector<OperationRule> operations;
  std::vector<std::string> sequence;  ///< names of features (with *) in the order of work; empty: free
  JobOutput output;
  PlanOptions whole;  ///< what [plan], [machine] and [output] ask of the plan as a whole
  std::optional<std::filesystem::path> after;  ///< program that has run before, found from the job's folder
  std::optional<std::filesystem::path> stock_from;  ///< what the part is made of, likewise
  std::vector<std::string> stated_keep_outs,
      stated_predrilled;                   ///< of [plan], in the words of the command line
  std::vector<KeepOut> keep_outs;          ///< [[keep_out]]
  std::vector<PredrilledHole> predrilled;  ///< [[predrilled]]
  std::optional<ZeroPoint> zero;           ///< absent: that of the part's file
  std::string setup_name;                  ///< of one of several set-ups
  int setup_number = 0;                    ///< from 1; 0: the job is one set-up
  bool has_own_stock = false;              ///< the set-up states where its block lies
  std::vector<JobFile>
      setups;            ///< [[setup]]: each a job of its own; the job itself is then as the first of them
  Sources sources;       ///< of the keys of [plan], [machine] and [output], and of its machine file
  Sources part_sources;  ///< of the keys of [part]
};

/// Throws  InputError "file:line: ..." for bad TOML, unknown keys (with the nearest known one) and
///         impossible values.
JobFile read_job_text(std::string_view text, const std::string& file_name);
JobFile read_job(const std::filesystem::path& file);

/// The part of a job: its file read, stock and tools set, operations chosen. All of job.plan is in the operations afterwards,
/// with where it stands in their sources; machine, output and the planner's
/// values are left to the caller. `over`: options that go before the job's own (command line). Throws as
/// read_part and read_tool_library, and when a tool number or a feature name matches nothing.
Part part_of_job(const JobFile& job, const ReadOptions& over);

/// The same; `sources` are afterwards those of every value that the job or its tool library states, `published` what it chooses
/// as published.
Part part_of_job(const JobFile& job, const ReadOptions& over, StepSources& sources, StepChoices& published);
/// The job's own tools, then those of its library that it uses: the tools of its part, in their order.
std::vector<LibraryTool> tools_of_job(const JobFile& job);

/// Options that somebody has stated, by the names of their rows.
struct StatedOptions {
  Asked asked;
  std::set<std::string> names;
};

/// A commented job for `part`, read from `part_file`: valid as it stands, with every key and its default; what is `stated` stands in
/// it as keys, so that a plan of the job is the plan by those options.
std::string job_text(const Part& part, const std::string& part_file, const StatedOptions& stated = {});

}  // namespace clearcut::read
