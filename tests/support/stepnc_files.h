// For tests: STEP-NC files, own and published.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "read/stepnc/stepnc.h"
#include "support/data.h"
#include "support/same_regions.h"

namespace clearcut::test_support {

namespace fs = std::filesystem;

inline std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline Part read_data(const std::string& name) {
  return read::stepnc::read_stepnc(content(*test_support::data_folder() / "stepnc" / name), name, {});
}

inline void expect_same_cutting(const CuttingData& a, const CuttingData& b) {
  const auto same = [](std::optional<MmPerMin> x, std::optional<MmPerMin> y) {
    ASSERT_EQ(x.has_value(), y.has_value());
    if (x) {
      EXPECT_NEAR(x->mm_per_min(), y->mm_per_min(), 1e-9);
    }
  };
  same(a.feed, b.feed);
  same(a.plunge_feed, b.plunge_feed);
  same(a.ramp_feed, b.ramp_feed);
  same(a.slot_feed, b.slot_feed);
  ASSERT_EQ(a.spindle_rpm.has_value(), b.spindle_rpm.has_value());
  if (a.spindle_rpm) {
    EXPECT_NEAR(*a.spindle_rpm, *b.spindle_rpm, 1e-9);
    EXPECT_EQ(a.spindle_clockwise, b.spindle_clockwise);
  }
  EXPECT_EQ(a.coolant, b.coolant);
}

inline void expect_near(const std::optional<double>& a, const std::optional<double>& b, const char* what) {
  ASSERT_EQ(a.has_value(), b.has_value()) << what;
  if (a) {
    EXPECT_NEAR(*a, *b, 1e-9) << what;
  }
}

inline void expect_same_operation(const Operation& a, const Operation& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.tool, b.tool);
  expect_same_cutting(a.cutting, b.cutting);
  expect_near(a.stepdown, b.stepdown, "stepdown");
  expect_near(a.stepover, b.stepover, "stepover");
  expect_near(a.scallop, b.scallop, "scallop");
  expect_near(a.retract_z, b.retract_z, "retract");
  EXPECT_EQ(a.allowance_side, b.allowance_side);
  EXPECT_EQ(a.allowance_floor, b.allowance_floor);
  EXPECT_EQ(a.entry, b.entry);
  EXPECT_EQ(a.entry_angle, b.entry_angle);
  expect_near(a.lead, b.lead, "lead");
  EXPECT_EQ(a.lead_angle, b.lead_angle);
  if (a.entry_size) expect_near(a.entry_size, b.entry_size, "size of the entry");
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.strategy_hint, b.strategy_hint);
  ASSERT_EQ(a.feed_direction.has_value(), b.feed_direction.has_value());
  if (a.feed_direction) {
    EXPECT_NEAR(a.feed_direction->radians(), b.feed_direction->radians(), 1e-9);
  }
}

inline void expect_same_feature(const Feature& a, const Feature& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.kind, b.kind) << a.name;
  EXPECT_LE(boundary_gap(a.target, b.target), 1e-6) << a.name;
  EXPECT_LE(boundary_gap(a.allowed, b.allowed), 1e-6) << a.name;
  EXPECT_NEAR(a.top_z, b.top_z, 1e-9) << a.name;
  EXPECT_NEAR(a.floor_z, b.floor_z, 1e-9) << a.name;
  EXPECT_EQ(a.wall_slope, b.wall_slope) << a.name;
  EXPECT_EQ(a.through, b.through) << a.name;
  expect_near(a.hole_diameter, b.hole_diameter, "hole diameter");
}

inline void expect_same_part(const Part& a, const Part& b) {
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.stock.has_value(), b.stock.has_value());
  if (a.stock) {
    EXPECT_NEAR(a.stock->plan.max.x, b.stock->plan.max.x, 1e-9);
    EXPECT_NEAR(a.stock->plan.max.y, b.stock->plan.max.y, 1e-9);
    EXPECT_NEAR(a.stock->z_top, b.stock->z_top, 1e-9);
    EXPECT_NEAR(a.stock->z_bottom, b.stock->z_bottom, 1e-9);
  }
  EXPECT_EQ(a.safe_z(), b.safe_z());
  ASSERT_EQ(a.tools.size(), b.tools.size());
  for (std::size_t i = 0; i < a.tools.size(); ++i) {
    EXPECT_EQ(a.tools[i].number, b.tools[i].number);
    EXPECT_EQ(a.tools[i].name, b.tools[i].name);
    EXPECT_EQ(a.tools[i].kind, b.tools[i].kind);
    EXPECT_EQ(a.tools[i].diameter, b.tools[i].diameter);
    EXPECT_EQ(a.tools[i].corner_radius, b.tools[i].corner_radius);
    EXPECT_EQ(a.tools[i].teeth, b.tools[i].teeth);
    EXPECT_EQ(a.tools[i].flute_length, b.tools[i].flute_length);
    EXPECT_EQ(a.tools[i].center_cutting, b.tools[i].center_cutting);
  }
  ASSERT_EQ(a.features.size(), b.features.size());
  for (std::size_t i = 0; i < a.features.size(); ++i) expect_same_feature(a.features[i], b.features[i]);
  ASSERT_EQ(a.workplan.size(), b.workplan.size());
  for (std::size_t i = 0; i < a.workplan.size(); ++i) {
    EXPECT_EQ(a.workplan[i].name, b.workplan[i].name);
    EXPECT_EQ(a.workplan[i].feature, b.workplan[i].feature);
    expect_same_operation(a.workplan[i].operation, b.workplan[i].operation);
  }
}

}  // namespace clearcut::test_support
