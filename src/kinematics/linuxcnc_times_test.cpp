// Times of LinuxCNC's own trajectory planner (2.9, run by itself at 1 ms) against ours. What this cannot see: how task feeds the queue,
// which in the whole of LinuxCNC adds no more than 2 ms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "kinematics/planner.h"
#include "kinematics/sample_programs.h"

namespace clearcut::kinematics {
namespace {

/// A machine, with the feed that programs are run at on it.
struct MeasuredMachine {
  const char* name;
  double feed;              ///< mm/min
  AxisValues acceleration;  ///< mm/s2
  AxisValues speed;         ///< mm/min
};
constexpr MeasuredMachine kMachines[] = {{"A", 1000, {500, 500, 500}, {5000, 5000, 5000}},
                                         {"B", 3000, {500, 500, 500}, {5000, 5000, 5000}},
                                         {"C", 3000, {2000, 2000, 2000}, {10000, 10000, 10000}},
                                         {"slow Z", 2000, {500, 500, 250}, {5000, 5000, 2000}}};

/// What a program says of the path: G64 P0.0005, G64 P0.01, G61.
constexpr PathControl kPaths[] = {
    {PathMode::kTolerance, 0.0005, {}}, {PathMode::kTolerance, 0.01, {}}, {PathMode::kExactPath, {}, {}}};
constexpr const char* kPathNames[] = {"P0.0005", "P0.01", "G61"};

/// s, for each machine under each of kPaths.
struct MeasuredTimes {
  const char* program;
  double seconds[4][3];
};
const MeasuredTimes kMeasured[] = {
    {"square_spiral",
     {{25.511, 25.449, 25.504}, {11.115, 11.079, 11.276}, {8.960, 8.936, 8.972}, {14.666, 14.627, 14.744}}},
    {"zigzag",
     {{40.182, 40.114, 40.174},
      {15.967, 15.923, 16.116},
      {13.842, 13.814, 13.858},
      {21.972, 21.926, 22.043}}},
    {"noisy_rings",
     {{25.442, 21.540, 33.115}, {21.810, 14.102, 31.366}, {11.288, 8.062, 15.952}, {22.394, 14.882, 31.925}}},
    {"chords",
     {{7.356, 7.352, 18.448}, {3.348, 3.341, 18.070}, {2.662, 2.657, 9.214}, {4.642, 4.660, 18.501}}},
    {"round_slots",
     {{35.705, 35.656, 35.642},
      {13.729, 13.689, 13.761},
      {12.198, 12.176, 12.177},
      {19.230, 19.191, 19.219}}},
    {"arcs_with_corners",
     {{45.434, 43.921, 46.160},
      {25.129, 23.018, 26.624},
      {17.009, 15.940, 17.314},
      {28.967, 27.071, 30.191}}},
    {"there_and_back",
     {{84.676, 84.713, 84.788},
      {35.131, 35.191, 35.645},
      {29.398, 29.401, 29.497},
      {46.727, 46.779, 47.015}}},
    {"helices",
     {{40.493, 40.247, 40.515},
      {18.473, 18.995, 18.719},
      {14.406, 14.414, 14.492},
      {25.134, 24.969, 24.728}}},
    {"drilled_holes",
     {{38.670, 38.665, 39.106},
      {22.026, 22.021, 22.462},
      {15.154, 15.154, 15.378},
      {30.989, 31.042, 31.393}}},
    {"ramps",
     {{20.745, 20.745, 20.614}, {9.045, 9.045, 8.914}, {7.303, 7.303, 7.238}, {12.002, 12.002, 11.869}}},
    {"random_lines",
     {{31.657, 30.387, 33.580},
      {17.731, 15.856, 20.509},
      {11.829, 11.063, 12.998},
      {20.566, 18.852, 23.077}}},
    {"gentle_curve",
     {{19.710, 18.759, 22.019}, {10.913, 7.998, 15.018}, {7.398, 6.497, 8.771}, {12.681, 10.529, 16.308}}},
};

double time_of(const sample::Program& program, const MeasuredMachine& measured, const PathControl& path) {
  Machine machine;
  machine.axis_acceleration = measured.acceleration;
  machine.axis_rapid = measured.speed;
  return planned_time(program.moves(measured.feed), path, machine, MotionPlanner::kLinuxCnc).seconds();
}

TEST(LinuxCncTimes, AgreeWithItsOwnPlanner) {
  static_assert(std::size(kMeasured) == std::size(sample::kPrograms));
  for (std::size_t m = 0; m < std::size(kMachines); ++m) {
    for (std::size_t k = 0; k < std::size(kPaths); ++k) {
      std::vector<double> errors;
      for (std::size_t i = 0; i < std::size(kMeasured); ++i) {
        ASSERT_STREQ(kMeasured[i].program, sample::kPrograms[i].name);
        const double truth = kMeasured[i].seconds[m][k];
        const double error = time_of(sample::kPrograms[i], kMachines[m], kPaths[k]) / truth - 1;
        EXPECT_LT(std::abs(error), 0.035)
            << kMachines[m].name << " " << kPathNames[k] << " " << kMeasured[i].program;
        errors.push_back(std::abs(error));
      }
      std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2),
                       errors.end());
      EXPECT_LT(errors[errors.size() / 2], 0.002) << kMachines[m].name << " " << kPathNames[k];
    }
  }
}

}  // namespace
}  // namespace clearcut::kinematics
