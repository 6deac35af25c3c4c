// The families of controllers by how they plan speed along a path.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::inline model {

/// Controller whose rules decide the speed of the axes; `kinematics/` has one planner for each.
enum class MotionPlanner : unsigned char { kGrbl, kLinuxCnc, kMarlin, kMach, kJerkLimited };

/// Name in machine files and certificates: "grbl", "linuxcnc", "marlin", "mach", "jerk-limited".
std::string_view name_of(MotionPlanner planner);
/// For people: "Grbl 1.1, grblHAL".
std::string_view title_of(MotionPlanner planner);
/// The names of all, in the order of the enumeration.
const std::vector<std::string>& motion_planner_names();
std::optional<MotionPlanner> motion_planner_named(std::string_view name);

/// One value for each of X, Y and Z.
using AxisValues = std::array<double, 3>;

}  // namespace clearcut::inline model
