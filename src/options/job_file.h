// Jobs and project files as read: part, stock, tools, machine and operations with their sources; see docs/input.md.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/library.h"
#include "model/machine.h"
#include "model/options/origin.h"
#include "model/part.h"
#include "options/plan_options.h"
#include "options/read_options.h"
#include "options/row.h"

namespace clearcut::inline options {

/// Requested place of the program's zero.
struct ZeroPoint {
  std::string place;              ///< "corner", "centre" of the top of the block; "": the point
  std::array<double, 3> point{};  ///< mm, in the coordinates of the file
};

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

/// Stated options, by the names of their rows.
struct StatedOptions {
  Asked asked;
  std::set<std::string> names;
};

/// What is asked in a project file. The files themselves are read by their paths within it: "a.clearcut.json/plate.dxf".
struct ProjectFile {
  std::string file;
  std::string input;  ///< path of the part or job within the project file
  /// Values of options by the names of their rows; a flag has none. Names of files within the project file are paths to them.
  std::map<std::string, std::vector<std::string>> options;
};

}  // namespace clearcut::inline options
