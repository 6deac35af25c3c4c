// Job files: part, stock, tools, machine and operations in one TOML; see docs/input.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/machine.h"
#include "model/options/end_position.h"
#include "model/options/origin.h"
#include "model/options/published_solver.h"
#include "model/options/resolved_plan.h"
#include "model/options/shop_options.h"
#include "model/options/tab_options.h"
#include "model/options/work_offset.h"
#include "model/part.h"
#include "read/moved_part.h"
#include "read/read_options.h"
#include "read/tools/tool_library.h"

namespace clearcut::read {

/// How to cut, for all operations ([plan]) or those of some features ([[operation]]). Absent values are
/// left to what stands above them: operation, plan, the part's file, the planner's defaults.
struct CutSettings {
  std::optional<std::string> strategy;  ///< name
  std::optional<std::string> stepover;  ///< "0.4" (fraction of the diameter), "3.5mm", "lom", "rho"
  std::optional<double> stepdown;       ///< mm
  std::optional<double> allowance;      ///< mm, on walls
  std::optional<double> allowance_floor;
  std::optional<double> scallop;      ///< mm
  std::optional<double> lead;         ///< mm, radius or length; 0: none
  std::optional<Radians> lead_angle;  ///< of straight leads
  std::optional<EntryKind> entry;
  std::optional<Radians> entry_angle;
  std::optional<CutDirection> direction;
  std::optional<int> tool;  ///< number
  std::optional<OperationKind> kind;
  std::optional<MmPerMin> feed, plunge_feed, ramp_feed, slot_feed;
  std::optional<double> spindle_rpm;
  std::optional<Coolant> coolant;
  PublishedChoices published;
  Sources sources;  ///< "job.toml:12" of each key
};

/// [[operation]]: settings for the workingsteps of all features that match.
struct OperationRule {
  std::string feature = "*";  ///< name, * for anything, any case
  bool skip = false;          ///< not machined at all
  CutSettings settings;
  int line = 0;
};

/// What is to be written, as given; relative to the job's folder.
struct JobOutput {
  std::optional<std::string> program, post, certificate, svg, report, setup_sheet, result;
  std::optional<bool> inch;
  std::optional<WorkOffset> work_offset;
  std::optional<EndPosition> end_position;
  // Switches of the post.
  std::optional<int> decimals;
  std::optional<bool> arcs, tool_change, length_offset, exact_stop;
  std::optional<double> spindle_wait;  ///< s
  std::optional<int> program_number;
  std::optional<bool> block_numbers, optional_stop;
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
  JobOutput output;
  // For the planner as a whole.
  ShopOptions shop;
  TabOptions tabs;
  std::optional<std::filesystem::path> after;  ///< program that has run before, found from the job's folder
  std::vector<KeepOut> keep_outs;              ///< [[keep_out]]
  std::vector<PredrilledHole> predrilled;      ///< [[predrilled]]
  std::optional<double> engagement_deg;
  std::optional<double> angle_deg;  ///< of zigzag lines against x
  std::optional<ContourOrder> order;
  std::optional<Vec2> start;
  std::optional<std::string> objective;
  std::optional<double> time_s;
  std::optional<std::uint64_t> seed;
  std::optional<ZeroPoint> zero;  ///< absent: that of the part's file
  std::string setup_name;         ///< of one of several set-ups
  int setup_number = 0;           ///< from 1; 0: the job is one set-up
  bool has_own_stock = false;     ///< the set-up states where its block lies
  std::vector<JobFile>
      setups;  ///< [[setup]]: each a job of its own; the job itself is then as the first of them
  std::vector<std::string> accept;  ///< conditions that hold at the machine, by name
  Sources sources;  ///< of the keys of [plan], [machine] and [output], and of its machine file
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

/// A commented job for `part`, read from `part_file`: valid as it stands, with every key and its default. `solid`: how the
/// part was read.
std::string job_text(const Part& part, const std::string& part_file, const SolidOptions& solid = {});

}  // namespace clearcut::read
