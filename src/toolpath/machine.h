// What the machine can do; used for kinematic times and limit checks.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "base/units.h"

namespace clearcut {

/// A small 3-axis mill. Defaults are those of the measured comparisons (Grbl-style cornering).
struct Machine {
  std::string name = "default";
  MmPerMin rapid = MmPerMin::of(5000);
  double acceleration = 500;         ///< mm/s2, along the path
  double junction_deviation = 0.01;  ///< mm
  std::optional<double> max_spindle_rpm;
  std::optional<MmPerMin> max_feed;
  /// Travel limits in workpiece coordinates, mm: x, y, z as {min, max}; absent = unlimited.
  std::optional<std::array<std::array<double, 2>, 3>> travel;
};

}  // namespace clearcut
