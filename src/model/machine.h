// Abilities of the machine, used for kinematic times and checks of limits, and the families of controllers by how
// they plan speed along a path.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"

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

/// Places of the machine in its own coordinates, mm: with them nothing about offsets and reference points is open.
struct MachinePlaces {
  std::array<double, 3> start{};  ///< place of the tool's tip at the beginning of the program
  /// Origins of G54, G55 ... G59.3; the work is at the origin of G54.
  std::array<std::array<double, 3>, 9> origins{};
  int stated_origins = 9;             ///< number of known origins, in that order; later ones are unknown
  std::array<double, 3> reference{};  ///< G28
  std::array<double, 3> second_reference{};  ///< G30
};

/// Chip load for this machine, if the material's table states two values.
enum class MachineStiffness {
  kUnknown,  ///< woods and plastics as a hobby machine, metals as a stiff one
  kHobby,    ///< a light frame on belts or wheels
  kStiff
};

/// A small 3-axis mill. Defaults are those of the measured comparisons (Grbl-style cornering).
struct Machine {
  std::string name = "default";
  MmPerMin rapid = MmPerMin::of(5000);
  /// mm/s2; acceleration of the slower of X and Y if the axes differ.
  double acceleration = 500;
  double junction_deviation = 0.01;             ///< mm
  std::optional<MotionPlanner> planner;         ///< absent: the planner of the program's control
  std::optional<AxisValues> axis_rapid;         ///< mm/min; greatest speed of each axis; absent: `rapid`
  std::optional<AxisValues> axis_acceleration;  ///< mm/s2; absent: `acceleration`
  std::optional<double> jerk;                   ///< mm/s3; absent: acceleration is built up in 0.05 s
  /// mm/s; allowed instant change of an axis' speed: "classic jerk" of Marlin.
  std::optional<AxisValues> speed_jump;
  double arc_tolerance = 0.002;  ///< mm; Grbl's chords of arcs stay so near ($12)
  std::optional<double> max_spindle_rpm, min_spindle_rpm;
  std::optional<double> spindle_power_w;    ///< at the cutter, lasting
  std::optional<double> spindle_torque_nm;  ///< likewise
  std::optional<MmPerMin> max_feed;
  std::optional<double> cutting_force_n;  ///< lateral force at the cutter that the frame bears permanently
  MachineStiffness stiffness = MachineStiffness::kUnknown;
  std::optional<int> program_number;     ///< the O word of its programs, if no other one is requested
  double spindle_wait_s = 0;             ///< a program has to wait for so long after the spindle starts
  double tool_change_s = 0;              ///< s, for the times
  std::optional<double> path_tolerance;  ///< mm; greatest corner rounding if a program states no bound
  std::optional<MachinePlaces> places;
  /// Travel limits, mm: x, y, z as {min, max}; absent = unlimited. In machine coordinates if `places` states the
  /// work's position in them, else in workpiece coordinates.
  std::optional<std::array<std::array<double, 2>, 3>> travel;
};

/// mm/min, greatest speed of each axis.
inline AxisValues axis_speeds(const Machine& machine) {
  const double all = machine.rapid.mm_per_min();
  return machine.axis_rapid.value_or(AxisValues{all, all, all});
}

/// mm/s2, greatest acceleration of each axis.
inline AxisValues axis_accelerations(const Machine& machine) {
  const double all = machine.acceleration;
  return machine.axis_acceleration.value_or(AxisValues{all, all, all});
}

/// rpm; automatic values do not exceed this speed if the spindle's greatest speed is not stated.
inline constexpr double kUsualTopRpm = 24000;

/// mm, in workpiece coordinates; assumed as the machine's own Z zero if its travel is not known.
inline constexpr double kUsualHomeZ = 100;

/// mm; position of the work's zero in the coordinates of the machine's travel, along x, y or z.
inline double work_zero(const Machine& machine, std::size_t axis) {
  return machine.places ? machine.places->origins[0][axis] : 0;
}

/// mm, in workpiece coordinates; the machine's own Z zero is the top of its travel.
inline double home_z(const Machine& machine) {
  return machine.travel ? (*machine.travel)[2][1] - work_zero(machine, 2) : kUsualHomeZ;
}

}  // namespace clearcut::inline model
