// What a check of a program is told beside the part: what was stated for tools, what the control held, what ran before.
#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/tolerances.h"
#include "model/control.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/work_material.h"
#include "verify/program/load_reference.h"

namespace clearcut::verify {

/// What somebody stated for a tool, beside what operations state for it.
struct ToolLimits {
  std::optional<double> stepdown;  ///< mm
  std::optional<MmPerMin> plunge_feed;
  bool is_clockwise = true;  ///< which way it cuts
};

/// How somebody stated that a tool is driven, over all operations with it; 0: at least one says nothing.
struct StatedDrive {
  double most_feed = 0;  ///< mm/min
  double least_rpm = 0, most_rpm = 0;
};

struct VerifyOptions {
  Tolerances tol;
  Machine machine;
  std::optional<double> engagement_limit_deg;
  int threads = 1;
  /// A program that ran before on the same stock. What it cut is cut and what it spoiled is reported; its
  /// lengths and times are not in the figures.
  const Toolpath* earlier = nullptr;
  /// What the control held at each move of `earlier`; absent: it is unknown.
  const ControlTable* earlier_control = nullptr;
  /// What the control held at each move; absent: it is unknown, and nothing about it is checked.
  const ControlTable* control = nullptr;
  bool speed_may_be_power = false;  ///< small S words say how strongly the spindle is driven, not its turns
  bool needs_tool_length = false;  ///< without the tool's length (G43) the control would cut at wrong heights
  bool changes_tools_alone = false;   ///< a changer puts tools in while nobody stands at the machine
  std::vector<std::string> accepted;  ///< conditions that somebody has stated to hold: they give no faults
  /// For tools that no workingstep uses, by number. Other tools have to keep to what their operations state.
  std::map<int, ToolLimits> tool_limits;
  std::map<int, StatedDrive> stated;       ///< by number of the tool
  std::optional<WorkMaterial> material;    ///< absent: no forces and no wear are computed
  std::optional<LoadReference> reference;  ///< absent: feeds do not go by the load
  std::stop_token cancel;                  ///< asked between moves and layers
  ProgressCallback progress;               ///< told how far it is, as Stage::kCertifying; may be empty
};

}  // namespace clearcut::verify
