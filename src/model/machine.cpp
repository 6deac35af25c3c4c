#include "model/machine.h"

#include <algorithm>

namespace clearcut::inline model {
namespace {

struct PlannerName {
  std::string_view name, title;
};

constexpr std::array<PlannerName, 5> kPlannerNames{{
    {"grbl", "Grbl 1.1, grblHAL"},
    {"linuxcnc", "LinuxCNC 2.9"},
    {"marlin", "Marlin 2"},
    {"mach", "Mach3, Mach4"},
    {"jerk-limited", "Fanuc, Haas, Heidenhain, Siemens"},
}};

const PlannerName& row_of(MotionPlanner planner) {
  return kPlannerNames[static_cast<std::size_t>(planner)];
}

}  // namespace

std::string_view name_of(MotionPlanner planner) {
  return row_of(planner).name;
}

std::string_view title_of(MotionPlanner planner) {
  return row_of(planner).title;
}

const std::vector<std::string>& motion_planner_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const PlannerName& row : kPlannerNames) all.emplace_back(row.name);
    return all;
  }();
  return names;
}

std::optional<MotionPlanner> motion_planner_named(std::string_view name) {
  const auto found = std::find_if(kPlannerNames.begin(), kPlannerNames.end(),
                                  [&](const PlannerName& row) { return row.name == name; });
  if (found == kPlannerNames.end()) return std::nullopt;
  return static_cast<MotionPlanner>(found - kPlannerNames.begin());
}

}  // namespace clearcut::inline model
