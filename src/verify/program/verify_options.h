// Input of a program's check in addition to the part: values stated for tools, the reference load for feeds, states
// of the control, earlier programs.
#pragma once

#include <algorithm>
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
#include "model/options/shop_options.h"
#include "model/work_material.h"

namespace clearcut::verify {

/// mm/min; feed at the reference: stated by the rule, else for the tool, else the feed of the workingstep.
struct LoadReference {
  FeedRule rule;
  std::vector<MmPerMin> feed_of_step = {};
  std::map<int, MmPerMin> feed_of_tool = {};  ///< feed by number of the tool

  /// 0 if not stated. Moves without a workingstep are compared with the least of all feeds.
  double feed(int workingstep, int tool) const {
    if (rule.feed) return rule.feed->mm_per_min();
    if (const auto own = feed_of_tool.find(tool); own != feed_of_tool.end()) return own->second.mm_per_min();
    if (feed_of_step.empty()) return 0;
    const auto step = static_cast<std::size_t>(workingstep);
    if (workingstep >= 0 && step < feed_of_step.size()) return feed_of_step[step].mm_per_min();
    return std::min_element(feed_of_step.begin(), feed_of_step.end())->mm_per_min();
  }
  double cap(int workingstep, int tool) const {
    return rule.cap ? rule.cap->mm_per_min() : kUsualCap * feed(workingstep, tool);
  }

  /// Default cap as a multiple of the reference's feed.
  static constexpr double kUsualCap = 2;
};

/// Limits stated for a tool, in addition to those of operations.
struct ToolLimits {
  std::optional<double> stepdown;  ///< mm
  std::optional<MmPerMin> plunge_feed;
  bool is_clockwise = true;  ///< direction in which the tool cuts
};

/// Cutting data stated for a tool, over all operations with it; 0: at least one operation states none.
struct StatedDrive {
  double most_feed = 0;  ///< mm/min
  double least_rpm = 0, most_rpm = 0;
};

struct VerifyOptions {
  Tolerances tol;
  Machine machine;
  std::optional<double> engagement_limit_deg;
  int threads = 1;
  /// A program run before on the same stock. Its cuts count and its faults are reported; its lengths and times are
  /// not in the figures.
  const Toolpath* earlier = nullptr;
  /// State of the control at each move of `earlier`; absent: unknown.
  const ControlTable* earlier_control = nullptr;
  /// State of the control at each move; absent: unknown and not checked.
  const ControlTable* control = nullptr;
  bool speed_may_be_power = false;  ///< small S words say how strongly the spindle is driven, not its turns
  bool needs_tool_length = false;  ///< without the tool's length (G43) the control would cut at wrong heights
  bool changes_tools_alone = false;   ///< a changer loads tools without an operator at the machine
  std::vector<std::string> accepted;  ///< confirmed conditions: they cause no faults
  /// Limits for tools without a workingstep, by number. Other tools are limited by their operations.
  std::map<int, ToolLimits> tool_limits;
  std::map<int, StatedDrive> stated;       ///< stated cutting data by number of the tool
  std::optional<WorkMaterial> material;    ///< absent: no forces and no wear are computed
  std::optional<LoadReference> reference;  ///< absent: feeds do not go by the load
  std::stop_token cancel;                  ///< asked between moves and layers
  ProgressCallback progress;               ///< receives the progress, as Stage::kCertifying; may be empty
};

}  // namespace clearcut::verify
