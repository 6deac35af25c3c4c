// The words of Klartext's path blocks.
#pragma once

#include <optional>
#include <vector>

#include "geometry/edge.h"
#include "read/gcode/motion/builder.h"

namespace clearcut::read::gcode {

/// What the words of a path block say. mm and degrees.
struct PathWords {
  Target absolute;
  Target incremental;
  std::optional<double> polar_angle, polar_step, polar_radius, radius, feed;
  std::optional<Turn> turn;
  bool rapid = false;
  bool machine_frame = false;
  std::vector<int> m;
};

}  // namespace clearcut::read::gcode
