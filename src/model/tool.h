// Cutters and how they are driven.
#pragma once

#include <optional>
#include <string>

#include "base/units.h"

namespace clearcut::inline model {

enum class ToolKind { kEndMill, kFaceMill, kBallEndMill, kBullNoseEndMill, kDrill, kReamer, kOther };
/// "endmill", "facemill", "ball", "bullnose", "drill", "reamer", "other": as on the command line.
const char* name_of(ToolKind kind);
std::optional<ToolKind> tool_kind_named(const std::string& name);

/// A rotating tool. Lengths in mm.
struct Tool {
  int number = 1;    ///< T word
  std::string name;  ///< as in the source ("T3"), for messages and headers
  ToolKind kind = ToolKind::kEndMill;
  double diameter = 0;
  double corner_radius = 0;  ///< 0 flat
  int teeth = 2;
  std::optional<double> flute_length;
  bool center_cutting = true;  ///< may plunge straight down
  double radius() const { return diameter / 2; }
};

/// Feeds and speeds of one operation. Absent values take the documented defaults (see defaults_for).
struct CuttingData {
  std::optional<MmPerMin> feed;
  std::optional<MmPerMin> plunge_feed;
  std::optional<MmPerMin> ramp_feed;
  std::optional<MmPerMin> slot_feed;
  std::optional<double> spindle_rpm;  ///< > 0; direction apart
  bool spindle_clockwise = true;      ///< M3
  bool coolant = false;
};

}  // namespace clearcut::inline model
