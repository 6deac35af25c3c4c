#include "read/job/machine_library.h"

#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "read/job/machine_file.h"

namespace clearcut::read {
namespace {

std::string refusal(const std::string& text) {
  try {
    read_machine_text(text, "mill");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string kDump =
    "Grbl 1.1h ['$' for help]\n$0=10\n$11=0.020 (junction deviation, "
    "mm)\n$12=0.002\n$30=24000\n$31=8000\n$32=0\n"
    "$110=8000.000\n$111=7000.000\n$112=500.000\n$120=500.000\n$121=400.000\n$122=50.000\n$130=790.000\nok\n";

TEST(MachineSettings, GrblDump) {
  const Machine machine = read_machine_text(kDump, "dump.txt");
  EXPECT_EQ(machine.planner, MotionPlanner::kGrbl);
  EXPECT_EQ(machine.axis_rapid, (AxisValues{8000, 7000, 500}));
  EXPECT_EQ(machine.axis_acceleration, (AxisValues{500, 400, 50}));
  EXPECT_DOUBLE_EQ(machine.rapid.mm_per_min(), 7000);
  EXPECT_DOUBLE_EQ(machine.acceleration, 400);
  EXPECT_DOUBLE_EQ(machine.junction_deviation, 0.02);
  EXPECT_EQ(machine.max_spindle_rpm, 24000);
  EXPECT_EQ(machine.min_spindle_rpm, 8000);
}

TEST(MachineSettings, GrblsUnsetSpindleSaysNothing) {
  std::string text = kDump;
  text.replace(text.find("$30=24000"), 9, "$30=1000.");
  EXPECT_FALSE(read_machine_text(text, "dump.txt").max_spindle_rpm);
}

TEST(MachineSettings, GrblRefusals) {
  EXPECT_EQ(refusal("$110=1\n$111=2\n"),
            "mill: $112 is missing: the greatest speed of an axis; give all settings of the control");
  EXPECT_EQ(refusal("$110=fast\n"), "mill:1: $110 is 'fast', which is no number; correct it");
  EXPECT_EQ(refusal("$32=1\n$110=0\n"),
            "mill:1: $32=1 is laser mode, in which the spindle stops at every rapid; set $32=0 for milling");
  EXPECT_EQ(refusal("$110=0\n"), "mill:1: $110 must be above zero; correct it");
}

TEST(MachineSettings, LinuxCncIniInInches) {
  const Machine machine = read_machine_text(
      "[EMC]\nMACHINE = Mill\n[TRAJ]\nLINEAR_UNITS = inch\nMAX_LINEAR_VELOCITY = 1.5\n"
      "[AXIS_X]\nMAX_VELOCITY = 2\nMAX_ACCELERATION = 9 # a comment\n[JOINT_0]\nMAX_VELOCITY = "
      "1\nMAX_ACCELERATION = "
      "10\n"
      "[JOINT_1]\nMAX_VELOCITY = 2\nMAX_ACCELERATION = 9\n[AXIS_Z]\nMAX_VELOCITY = 1\nMAX_ACCELERATION = 6\n",
      "mill.ini");
  EXPECT_EQ(machine.name, "Mill");
  EXPECT_EQ(machine.planner, MotionPlanner::kLinuxCnc);
  const AxisValues speeds{1524, 2286, 1524}, accelerations{228.6, 228.6, 152.4};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR((*machine.axis_rapid)[axis], speeds[axis], 1e-9);
    EXPECT_NEAR((*machine.axis_acceleration)[axis], accelerations[axis], 1e-9);
  }
  EXPECT_EQ(
      refusal("[TRAJ]\n[AXIS_X]\nMAX_VELOCITY = 2\n"),
      "mill: [AXIS_X]MAX_ACCELERATION is missing: what the axis can do; give all settings of the control");
}

TEST(MachineSettings, MarlinReport) {
  const std::string report =
      "echo:; Maximum feedrates (units/s):\necho:  M203 X300.00 Y300.00 Z5.00 E25.00\n"
      "echo:  M201 X3000.00 Y2000.00 Z100.00 E10000.00\necho:  M204 P1000.00 R1000.00 T1500.00\n";
  const Machine deviated =
      read_machine_text(report + "echo:  M205 B20000.00 S0.00 T0.00 J0.01\n", "m503.txt");
  EXPECT_EQ(deviated.planner, MotionPlanner::kMarlin);
  EXPECT_EQ(deviated.axis_rapid, (AxisValues{18000, 18000, 300}));
  EXPECT_DOUBLE_EQ(deviated.acceleration, 1000);
  EXPECT_FALSE(deviated.speed_jump);
  const Machine jerked = read_machine_text(report + "  M205 S0 T0 X10.00 Y10.00 Z0.30 E5.00\n", "m503.txt");
  EXPECT_EQ(jerked.speed_jump, (AxisValues{10, 10, 0.3}));
  EXPECT_EQ(refusal("G20 ; Units in inches\nM203 X1 Y1 Z1\n"),
            "mill:1: G20: the settings are in inches; send G21, then M503 again");
}

TEST(MachineSettings, AxesInToml) {
  const Machine machine = read_machine_text(
      "rapid = [5000, 5000, 500]\nacceleration = [500, 400, 50]\nplanner = \"mach\"\njerk = 9000\n",
      "mill.toml");
  EXPECT_EQ(machine.axis_rapid, (AxisValues{5000, 5000, 500}));
  EXPECT_DOUBLE_EQ(machine.acceleration, 400);
  EXPECT_EQ(machine.planner, MotionPlanner::kMach);
  EXPECT_EQ(machine.jerk, 9000);
  EXPECT_FALSE(read_machine_text("rapid = 3000\n", "mill.toml").axis_rapid);
  EXPECT_NE(refusal("rapid = [1, 2]\n"), "");
  EXPECT_NE(refusal("acceleration = [1, 2, -3]\n"), "");
  EXPECT_NE(refusal("planner = \"grlb\"\n"), "");
}

TEST(MachineKinds, FillWhatTheMachineDoesNotState) {
  const Machine router = read_machine_text("kind = \"router\"\n", "m.toml");
  EXPECT_EQ(router.max_feed, MmPerMin::of(3000));
  EXPECT_EQ(router.cutting_force_n, 80);
  EXPECT_EQ(router.stiffness, MachineStiffness::kHobby);
  const Machine own = read_machine_text(
      "kind = \"router\"\nmax_feed = 1200\nspindle_power = 300\ncutting_force = 40\nprogram_number = 77\n",
      "m.toml");
  EXPECT_EQ(own.max_feed, MmPerMin::of(1200));
  EXPECT_EQ(own.spindle_power_w, 300);
  EXPECT_EQ(own.cutting_force_n, 40);
  EXPECT_EQ(own.program_number, 77);
  EXPECT_EQ(read_machine_text("kind = \"mill\"\n", "m.toml").stiffness, MachineStiffness::kStiff);
  EXPECT_FALSE(read_machine_text("kind = \"mill\"\n", "m.toml").max_feed);
  EXPECT_THROW(read_machine_text("program_number = 1.5\n", "m.toml"), InputError);
  EXPECT_THROW(read_machine_text("kind = \"lathe\"\n", "m.toml"), InputError);
}

TEST(MachineLibrary, KnowsMachinesByUniqueNames) {
  std::set<std::string_view> names;
  for (const LibraryMachine& one : machine_library()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_FALSE(one.source.empty()) << one.name;
    const auto machine = library_machine(one.name);
    ASSERT_TRUE(machine) << one.name;
    EXPECT_GT(machine->rapid.mm_per_min(), 0) << one.name;
    EXPECT_GT(machine->acceleration, 0) << one.name;
  }
  EXPECT_GE(names.size(), 25U);
  EXPECT_EQ(read_machine("x-carve-1000").axis_acceleration, (AxisValues{500, 500, 50}));
  EXPECT_THROW(read_machine("no-such-mill"), InputError);
}

}  // namespace
}  // namespace clearcut::read
