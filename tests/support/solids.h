// For tests: STEP solids of the examples.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.h"
#include "base/units.h"
#include "read/job/read_part.h"
#include "read/step_solid/solid_model.h"

#define SKIP_WITHOUT_OPEN_CASCADE() \
  if (!read::solids_can_be_read()) GTEST_SKIP() << "built without Open CASCADE: STEP solids cannot be read"

namespace clearcut::test_support {

inline std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(CLEARCUT_SOURCE_DIR) / "examples" / name;
}

inline double circle_area(double radius) {
  return kPi * radius * radius;
}

inline double rounded_area(double width, double height, double radius) {
  return width * height - (4 - kPi) * radius * radius;
}

inline std::string refusal(const std::string& text) {
  try {
    read::read_part_text(text, "s.step", {});
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "not refused";
}

/// The message of a refusal, one line; "" where the file is read.
inline std::string refused(const std::string& name, const SolidOptions& solid) {
  ReadOptions options;
  options.solid = solid;
  try {
    read::read_part(example(name), options);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

}  // namespace clearcut::test_support
