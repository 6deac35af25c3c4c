// Feeds a tooth beside what makers of cutters and guides for machines state: each row a window of theirs that ours lies in.
#include <gtest/gtest.h>

#include <string>

#include "base/units.h"
#include "model/work_material.h"
#include "resolve/values/cutting_values.h"

namespace clearcut::resolve {
namespace {

/// Addresses are in docs/feeds.md, under the same names.
struct Window {
  const char* source;
  MachineStiffness machine;
  const char* material;
  double diameter;   ///< inches
  double low, high;  ///< inches a tooth
};

constexpr MachineStiffness kStiff = MachineStiffness::kStiff, kHobby = MachineStiffness::kHobby;

constexpr Window kWindows[] = {
    {"AST Tooling", kStiff, "mdf", 0.125, 0.004, 0.007},
    {"AST Tooling", kStiff, "mdf", 0.25, 0.012, 0.015},
    {"AST Tooling", kStiff, "mdf", 0.5, 0.020, 0.025},
    {"AST Tooling", kStiff, "hardwood", 0.125, 0.002, 0.004},
    {"AST Tooling", kStiff, "hardwood", 0.25, 0.005, 0.007},
    {"AST Tooling", kStiff, "hardwood", 0.5, 0.017, 0.019},
    {"AST Tooling", kStiff, "softwood", 0.125, 0.003, 0.005},
    {"AST Tooling", kStiff, "softwood", 0.25, 0.006, 0.008},
    {"AST Tooling", kStiff, "softwood", 0.5, 0.019, 0.021},
    {"AST Tooling, soft", kStiff, "plastic", 0.125, 0.003, 0.005},
    {"AST Tooling, soft", kStiff, "plastic", 0.25, 0.006, 0.009},
    {"AST Tooling, soft", kStiff, "plastic", 0.5, 0.011, 0.014},
    {"AST Tooling, hard", kStiff, "plastic", 0.125, 0.002, 0.004},
    {"AST Tooling, hard", kStiff, "plastic", 0.25, 0.005, 0.008},
    {"AST Tooling, hard", kStiff, "plastic", 0.5, 0.010, 0.013},
    {"AST Tooling", kStiff, "plywood", 0.125, 0.003, 0.005},
    {"AST Tooling", kStiff, "plywood", 0.25, 0.006, 0.009},
    {"AST Tooling", kStiff, "plywood", 0.5, 0.018, 0.021},
    {"Cutter Shop", kStiff, "hardwood", 0.125, 0.003, 0.005},
    {"Cutter Shop", kStiff, "plywood", 0.125, 0.004, 0.006},
    {"Cutter Shop", kStiff, "mdf", 0.125, 0.004, 0.007},
    {"Cutter Shop", kStiff, "mdf", 0.25, 0.013, 0.016},
    {"Cutter Shop, hard", kStiff, "plastic", 0.125, 0.002, 0.004},
    {"Cutter Shop, hard", kStiff, "plastic", 0.25, 0.006, 0.009},
    {"Cutter Shop, hard", kStiff, "plastic", 0.5, 0.010, 0.012},
    {"Cutter Shop, soft", kStiff, "plastic", 0.125, 0.003, 0.006},
    {"Cutter Shop, soft", kStiff, "plastic", 0.25, 0.007, 0.010},
    {"Amana Tool", kStiff, "softwood", 0.125, 0.003, 0.005},
    {"Amana Tool", kStiff, "softwood", 0.25, 0.005, 0.007},
    {"Amana Tool", kStiff, "hardwood", 0.125, 0.003, 0.005},
    {"Amana Tool", kStiff, "hardwood", 0.25, 0.005, 0.007},
    {"HIT Tooling", kStiff, "aluminium", 0.125, 0.0005, 0.0012},
    {"HIT Tooling", kStiff, "aluminium", 0.25, 0.001, 0.0022},
    {"HIT Tooling", kStiff, "aluminium", 0.375, 0.0015, 0.0035},
    {"HIT Tooling", kStiff, "aluminium", 0.5, 0.002, 0.0045},
    {"HIT Tooling", kStiff, "aluminium", 0.75, 0.003, 0.007},
    {"HIT Tooling", kStiff, "steel", 0.125, 0.0004, 0.0011},
    {"HIT Tooling", kStiff, "steel", 0.25, 0.0008, 0.0028},
    {"HIT Tooling", kStiff, "steel", 0.5, 0.0018, 0.0055},
    {"HIT Tooling", kStiff, "steel", 0.75, 0.0025, 0.008},
    {"HIT Tooling", kStiff, "alloy-steel", 0.125, 0.0003, 0.0007},
    {"HIT Tooling", kStiff, "alloy-steel", 0.25, 0.0006, 0.0012},
    {"HIT Tooling", kStiff, "alloy-steel", 0.5, 0.001, 0.003},
    {"HIT Tooling", kStiff, "alloy-steel", 0.75, 0.0018, 0.004},
    {"HIT Tooling", kStiff, "stainless", 0.125, 0.0003, 0.0007},
    {"HIT Tooling", kStiff, "stainless", 0.25, 0.0006, 0.0012},
    {"HIT Tooling", kStiff, "stainless", 0.75, 0.0018, 0.004},
    {"HITCARB", kStiff, "titanium", 0.125, 0.0003, 0.0006},
    {"HITCARB", kStiff, "titanium", 0.25, 0.0005, 0.0012},
    {"Shapeoko A to Z, soft wood", kHobby, "softwood", 0.0625, 0.001, 0.0015},
    {"Shapeoko A to Z, soft wood", kHobby, "softwood", 0.125, 0.001, 0.0025},
    {"Shapeoko A to Z, soft wood", kHobby, "softwood", 0.25, 0.001, 0.005},
    {"Shapeoko A to Z, soft wood", kHobby, "mdf", 0.125, 0.001, 0.0025},
    {"Shapeoko A to Z, soft wood", kHobby, "mdf", 0.25, 0.001, 0.005},
    {"Shapeoko A to Z, soft wood", kHobby, "plywood", 0.125, 0.001, 0.0025},
    {"Shapeoko A to Z, soft wood", kHobby, "plywood", 0.25, 0.001, 0.005},
    {"Shapeoko A to Z, soft plastics", kHobby, "plastic", 0.125, 0.002, 0.005},
    {"Shapeoko A to Z, soft plastics", kHobby, "plastic", 0.25, 0.004, 0.01},
    {"Shapeoko A to Z, hard plastics", kHobby, "plastic", 0.125, 0.001, 0.0025},
    {"Shapeoko A to Z, hard plastics", kHobby, "plastic", 0.25, 0.001, 0.005},
    {"Shapeoko A to Z, hard wood", kHobby, "hardwood", 0.0625, 0.0005, 0.001},
    {"Shapeoko A to Z, hard wood", kHobby, "hardwood", 0.125, 0.0005, 0.001},
    {"Shapeoko A to Z, hard wood", kHobby, "hardwood", 0.25, 0.001, 0.002},
    {"Shapeoko A to Z, metals", kHobby, "aluminium", 0.0625, 0.0005, 0.001},
    {"Shapeoko A to Z, metals", kHobby, "aluminium", 0.125, 0.0005, 0.001},
    {"Shapeoko A to Z, metals", kHobby, "aluminium", 0.25, 0.001, 0.002},
    {"Shapeoko A to Z, metals", kHobby, "brass", 0.125, 0.0005, 0.001},
    {"Shapeoko A to Z, metals", kHobby, "brass", 0.25, 0.001, 0.002},
};

Operation filled(const Tool& tool, const PlanOptions& options, double depth, Sources& sources) {
  Operation operation;
  fill_cutting_values(operation, tool, depth, options.shop.material.value_or(""), options, sources);
  return operation;
}

/// Inches a tooth of a mill, as deep as it is wide, on a machine that limits nothing.
double ours(const Window& window) {
  Tool tool;
  tool.diameter = window.diameter * kMmPerInch;
  PlanOptions options;
  options.shop.material = window.material;
  options.machine.stiffness = window.machine;
  options.machine.rapid = MmPerMin::of(1e6);
  Sources sources;
  const Operation operation = filled(tool, options, tool.diameter, sources);
  const double rpm = *operation.cutting.spindle_rpm;
  return operation.cutting.feed->mm_per_min() / (rpm * tool.teeth) / kMmPerInch;
}

TEST(FeedTables, LieWithinTheWindowsOfMakersAndGuides) {
  constexpr double kRounded = 2e-6;  // inches a tooth: feeds are whole mm/min
  for (const Window& window : kWindows) {
    const double chip = ours(window);
    EXPECT_GE(chip, window.low - kRounded)
        << window.source << ": " << window.material << ", " << window.diameter;
    EXPECT_LE(chip, window.high + kRounded)
        << window.source << ": " << window.material << ", " << window.diameter;
  }
}

PlanOptions on_hobby_router(const char* material) {
  PlanOptions options;
  options.shop.material = material;
  Machine& machine = options.machine;
  machine.stiffness = MachineStiffness::kHobby;
  machine.min_spindle_rpm = 8000;
  machine.max_spindle_rpm = 24000;
  machine.spindle_power_w = 450;
  machine.cutting_force_n = 80;
  machine.max_feed = MmPerMin::of(3000);
  return options;
}

Tool mill(double diameter) {
  Tool tool;
  tool.diameter = diameter;
  return tool;
}

TEST(FeedTables, KeepAHobbyRoutersBitWhole) {
  Sources sources;
  const Operation soft = filled(mill(3.175), on_hobby_router("softwood"), 1.59, sources);
  EXPECT_EQ(soft.cutting.spindle_rpm, 24000);
  EXPECT_EQ(soft.cutting.feed, MmPerMin::of(2496));  // 0.052 * 2 * 24000
  EXPECT_EQ(soft.cutting.slot_feed, MmPerMin::of(1747));
  // The greatest feed rules, and the spindle turns more slowly so that the chip stays.
  Sources of_mdf;
  const Operation mdf = filled(mill(6), on_hobby_router("mdf"), 3, of_mdf);
  EXPECT_EQ(mdf.cutting.spindle_rpm, 14430);  // 3000 / (2 * 0.1039)
  EXPECT_LE(mdf.cutting.feed, MmPerMin::of(3000));
  EXPECT_NEAR(mdf.cutting.feed->mm_per_min() / (2 * 14430), 0.1039, 2e-4);
}

TEST(FeedTables, FeedNoFasterThanTheMachinesRapid) {
  PlanOptions options;
  options.shop.material = "mdf";
  options.machine.stiffness = MachineStiffness::kStiff;
  options.machine.axis_rapid = AxisValues{4000, 2000, 500};
  Sources sources;
  const Operation operation = filled(mill(6), options, 3, sources);
  EXPECT_LE(operation.cutting.feed, MmPerMin::of(2000));
  EXPECT_LE(operation.cutting.plunge_feed, MmPerMin::of(500));
  EXPECT_NE(sources.find("spindle")->text.find("the machine's rapid keeps the chip"), std::string::npos);
  EXPECT_NE(sources.find("plunge-feed")->text.find("rapid"), std::string::npos);
}

TEST(FeedTables, TakeTheForceThatMachineAndCutterBear) {
  PlanOptions options = on_hobby_router("aluminium");
  options.machine.cutting_force_n = 20;
  Sources sources;
  const Operation weak = filled(mill(6), options, 3, sources);
  EXPECT_NE(sources.find("feed")->text.find("the force that the machine bears"), std::string::npos);
  options.machine.cutting_force_n = 40;
  Sources of_stronger;
  EXPECT_GT(filled(mill(6), options, 3, of_stronger).cutting.feed, weak.cutting.feed);
  // A long thin cutter bends.
  PlanOptions stiff;
  stiff.shop.material = "hardwood";
  stiff.machine.stiffness = MachineStiffness::kStiff;
  Tool slim = mill(2);
  slim.stickout = 40;
  Sources of_slim, of_short;
  const Operation bent = filled(slim, stiff, 2, of_slim);
  EXPECT_NE(of_slim.find("feed")->text.find("bends the cutter"), std::string::npos);
  slim.stickout = 8;
  EXPECT_GT(filled(slim, stiff, 2, of_short).cutting.feed, bent.cutting.feed);
}

TEST(FeedTables, ThinTheChipsOfDeepCutsInWood) {
  PlanOptions options;
  options.shop.material = "hardwood";
  options.machine.stiffness = MachineStiffness::kStiff;
  options.machine.rapid = MmPerMin::of(1e6);
  const auto feed = [&](double depth) {
    Sources sources;
    return filled(mill(6.35), options, depth, sources).cutting.feed->mm_per_min();
  };
  EXPECT_EQ(feed(3), feed(6.35));
  EXPECT_NEAR(feed(12.7), 0.75 * feed(6.35), 1);
  EXPECT_NEAR(feed(19.05), 0.5 * feed(6.35), 1);
  EXPECT_NEAR(feed(40), 0.5 * feed(6.35), 1);
}

TEST(FeedTables, MeasureConesWhereTheyCut) {
  Tool v_bit = mill(32);
  v_bit.kind = ToolKind::kVBit;
  v_bit.tip_angle = Radians::of_degrees(90);
  Sources shallow, deep;
  const Operation fine = filled(v_bit, on_hobby_router("softwood"), 1, shallow);
  const Operation wide = filled(v_bit, on_hobby_router("softwood"), 16, deep);
  EXPECT_EQ(fine.cutting.spindle_rpm, 24000);  // 2 mm across, not 32
  EXPECT_LT(*wide.cutting.spindle_rpm, 10000);
  EXPECT_LT(fine.cutting.feed, wide.cutting.feed);
}

}  // namespace
}  // namespace clearcut::resolve
