// Common machines, with values stated by their makers and controls.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/machine.h"

namespace clearcut::read {

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

/// In the order of their names.
const std::vector<LibraryMachine>& machine_library();

/// The machine of this name; unpublished values are those of the default machine.
std::optional<Machine> library_machine(std::string_view name);

}  // namespace clearcut::read
