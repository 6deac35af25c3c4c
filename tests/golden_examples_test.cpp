// The examples, planned for every controller in millimetres and inches: byte for byte as in
// tests/golden/examples, read back from there and certified clean.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>

#include "base/file.h"
#include "pipeline/run.h"
#include "read/gcode/gcode.h"
#include "read/read_part.h"
#include "read/step_solid/solid_model.h"
#include "support/grbl.h"
#include "support/programs.h"
#include "support/rs274.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

struct Example {
  const char* file;
  std::optional<const char*> tool;  ///< where the file names none
  double stepdown;                  ///< mm
};

constexpr Example kExamples[] = {{"bracket.dxf", "endmill:6", 2},
                                 {"fishhead.p21", std::nullopt, 50},
                                 {"nested.step", "endmill:6", 8},
                                 {"awkward.step", "endmill:4", 8}};

struct Case {
  Example example;
  std::string dialect;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.example.file << " for " << c.dialect;
}

PlanOptions options_of(const Case& c, bool inch) {
  PlanOptions options;
  if (c.example.tool) options.tools = {parse_tool(*c.example.tool)};
  options.stepdown = c.example.stepdown;
  options.post.dialect = c.dialect;
  options.post.inch = inch;
  return options;
}

Part part_of(const Case& c) {
  return read_part(fs::path(CLEARCUT_SOURCE_DIR) / "examples" / c.example.file, {});
}

std::string golden(const Case& c, bool inch, const std::string& program) {
  const fs::path file = fs::path(CLEARCUT_SOURCE_DIR) / "tests/golden/examples" /
                        fs::path(c.example.file).stem() /
                        (c.dialect + (inch ? "-inch" : "-mm") + file_extension_of(c.dialect));
  if (std::getenv("CLEARCUT_UPDATE_GOLDEN")) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << program;
  }
  return read_file(file.string());
}

class ExampleProgram : public ::testing::TestWithParam<Case> {};

/// Plans, compares with the golden program, and judges what stands there.
Toolpath checked_program(const Case& c, bool inch) {
  const Part part = part_of(c);
  const PlanOptions options = options_of(c, inch);
  const std::string program = plan(part, options).program;
  const std::string wanted = golden(c, inch, program);
  EXPECT_EQ(test_support::first_difference(program, wanted), "");
  const JudgeResult judged = judge(part, wanted, "golden", options);
  EXPECT_TRUE(judged.findings.all.clean)
      << (judged.findings.faults.empty() ? "" : judged.findings.faults[0].text);
  if (c.dialect == "grbl") {
    for (const auto& fault : test_support::grbl_faults(wanted))
      ADD_FAILURE() << fault.error << ": " << fault.text;
  }
  if (c.dialect == "linuxcnc" && test_support::has_rs274()) {
    const test_support::CanonProgram canon = test_support::run_rs274(wanted);
    EXPECT_TRUE(canon.accepted) << canon.message;
  }
  return judged.toolpath;
}

TEST_P(ExampleProgram, IsTheGoldenOneAndCleanInBothUnits) {
  const Case& c = GetParam();
  if (fs::path(c.example.file).extension() == ".step" && !solids_can_be_read()) {
    GTEST_SKIP() << "built without Open CASCADE: STEP solids cannot be read";
  }
  const Toolpath metric = checked_program(c, false), inch = checked_program(c, true);
  const double limit =
      0.001 + 2 * rounding_of(options_of(c, false).post) + 2 * rounding_of(options_of(c, true).post);
  ASSERT_EQ(metric.sections.size(), inch.sections.size());
  for (std::size_t s = 0; s < metric.sections.size(); ++s) {
    const auto a = test_support::feed_moves(metric.sections[s]),
               b = test_support::feed_moves(inch.sections[s]);
    EXPECT_LE(test_support::largest_distance(a, b), limit) << metric.sections[s].label;
    EXPECT_LE(test_support::largest_distance(b, a), limit) << metric.sections[s].label;
  }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Example& example : kExamples)
    for (const std::string& dialect : post_dialects()) all.push_back({example, dialect});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Golden, ExampleProgram, ::testing::ValuesIn(cases()));

}  // namespace
}  // namespace clearcut
