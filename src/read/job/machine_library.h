// Machines that people have, as their makers and controls state them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/machine.h"

namespace clearcut::read {

struct LibraryMachine {
  std::string_view name;   ///< as --machine takes it: "shapeoko-3"
  std::string_view title;  ///< maker and model
  MotionPlanner planner = MotionPlanner::kGrbl;
  AxisValues speed{};                ///< mm/min
  AxisValues acceleration{};         ///< mm/s2; 0: its maker does not publish it
  double junction_deviation = 0.01;  ///< mm
  double min_rpm = 0, max_rpm = 0;   ///< 0: not stated
  double power_w = 0;                ///< 0: not stated
  std::string_view source;           ///< where the values are stated
};

/// In the order of their names.
const std::vector<LibraryMachine>& machine_library();

/// The machine of that name; what its maker does not publish is that of the default machine.
std::optional<Machine> library_machine(std::string_view name);

}  // namespace clearcut::read
