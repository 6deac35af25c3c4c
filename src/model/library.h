// Tools and machines of libraries.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "model/machine.h"
#include "model/tool.h"

namespace clearcut::inline model {

/// Feeds and speeds of a library for a tool in one material.
struct CuttingPreset {
  std::string name;
  CuttingData cutting;
  std::optional<double> stepdown;  ///< mm
  std::optional<double> stepover;  ///< fraction of the diameter
};

struct LibraryTool {
  Tool tool;
  std::vector<CuttingPreset> presets;
};

struct ToolLibrary {
  std::vector<LibraryTool> tools;  ///< in the order of the file; numbers are unique
  Diagnostics diagnostics;         ///< dropped tools and values, with reasons
  std::vector<std::string> files;  ///< paths of files read in addition to the library's own
};

struct ToolOptions {
  /// Unit of LinuxCNC tables, which do not state it: absent, mm with a warning.
  std::optional<std::string> unit;
};

struct LibraryMachine {
  std::string_view name;   ///< name for --machine: "shapeoko-3"
  std::string_view title;  ///< maker and model
  MotionPlanner planner = MotionPlanner::kGrbl;
  AxisValues speed{};                ///< mm/min
  AxisValues acceleration{};         ///< mm/s2; 0: its maker does not publish it
  double junction_deviation = 0.01;  ///< mm
  double min_rpm = 0, max_rpm = 0;   ///< 0: not stated
  double power_w = 0;                ///< 0: not stated
  std::string_view source;           ///< source of the values
};

}  // namespace clearcut::inline model
