// What the machine can do; used for kinematic times and limit checks.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "base/units.h"
#include "model/motion_planner.h"

namespace clearcut::inline model {

/// Places of the machine in its own coordinates, mm: with them nothing about offsets and reference points is open.
struct MachinePlaces {
  std::array<double, 3> start{};                   ///< of the tool's tip when the program begins
  std::array<std::array<double, 3>, 9> origins{};  ///< of G54, G55 ... G59.3; the work is at that of G54
  int stated_origins = 9;                          ///< of them, in that order; those beyond are not known
  std::array<double, 3> reference{};               ///< G28
  std::array<double, 3> second_reference{};        ///< G30
};

/// Which chips a machine takes, where its material's table states two.
enum class MachineStiffness {
  kUnknown,  ///< woods and plastics as a hobby machine, metals as a stiff one
  kHobby,    ///< a light frame on belts or wheels
  kStiff
};

/// A small 3-axis mill. Defaults are those of the measured comparisons (Grbl-style cornering).
struct Machine {
  std::string name = "default";
  MmPerMin rapid = MmPerMin::of(5000);
  double acceleration = 500;                    ///< mm/s2; of the slower of X and Y where the axes differ
  double junction_deviation = 0.01;             ///< mm
  std::optional<MotionPlanner> planner;         ///< absent: that of the control that the program is for
  std::optional<AxisValues> axis_rapid;         ///< mm/min; greatest speed of each axis; absent: `rapid`
  std::optional<AxisValues> axis_acceleration;  ///< mm/s2; absent: `acceleration`
  std::optional<double> jerk;                   ///< mm/s3; absent: acceleration is built up in 0.05 s
  std::optional<AxisValues>
      speed_jump;                ///< mm/s by which an axis may change at once: "classic jerk" of Marlin
  double arc_tolerance = 0.002;  ///< mm; Grbl's chords of arcs stay so near ($12)
  std::optional<double> max_spindle_rpm, min_spindle_rpm;
  std::optional<double> spindle_power_w;    ///< at the cutter, lasting
  std::optional<double> spindle_torque_nm;  ///< likewise
  std::optional<MmPerMin> max_feed;
  std::optional<double> cutting_force_n;  ///< sideways at the cutter, lasting, that the frame bears
  MachineStiffness stiffness = MachineStiffness::kUnknown;
  std::optional<int> program_number;     ///< the O word of its programs, where nobody asks for another
  double spindle_wait_s = 0;             ///< a program has to wait for so long after the spindle starts
  double tool_change_s = 0;              ///< s, for the times
  std::optional<double> path_tolerance;  ///< mm; rounds corners by no more, where a program states no bound
  std::optional<MachinePlaces> places;
  /// Travel limits, mm: x, y, z as {min, max}; absent = unlimited. In the machine's own coordinates where `places` says where the
  /// work lies in them, else in those of the work.
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

/// rpm; no spindle is asked for more by itself where its greatest speed is not stated.
inline constexpr double kUsualTopRpm = 24000;

/// mm, in workpiece coordinates; taken for the machine's own Z zero where its travel is not known.
inline constexpr double kUsualHomeZ = 100;

/// mm; where the work's zero lies in the coordinates of the machine's travel, along x, y or z.
inline double work_zero(const Machine& machine, std::size_t axis) {
  return machine.places ? machine.places->origins[0][axis] : 0;
}

/// mm, in workpiece coordinates; the machine's own Z zero is the top of its travel.
inline double home_z(const Machine& machine) {
  return machine.travel ? (*machine.travel)[2][1] - work_zero(machine, 2) : kUsualHomeZ;
}

}  // namespace clearcut::inline model
