// The examples, planned for every controller in millimetres and inches: byte for byte as those of
// tests/golden/examples, read back and certified clean. bracket.json, .svg and .step are the same part as
// bracket.dxf and need its programs only; flange.toml has every kind of hole; gland.toml threads inside and outside; two_sided.toml, which has two set-ups, is in
// tests/command/setups_test.cpp; five_pockets.toml is a job of elements, whose grid leaves corners by design.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <set>
#include <sstream>

#include "base/file.h"
#include "base/tolerances.h"
#include "pipeline/check.h"
#include "pipeline/elements.h"
#include "pipeline/job_options.h"
#include "pipeline/run.h"
#include "post/post.h"
#include "read/gcode/gcode.h"
#include "read/job/job_file.h"
#include "read/job/read_part.h"
#include "read/outline/read_elements.h"
#include "read/step_solid/solid_model.h"
#include "support/controllers.h"
#include "support/golden.h"
#include "support/independent/grbl.h"
#include "support/independent/rs274.h"
#include "support/programs.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

struct Example {
  const char* file;
  const char* folder;               ///< in tests/golden/examples
  std::optional<const char*> tool;  ///< or several, where the file names none
  std::optional<double> stepdown;   ///< mm
  /// Of many like holes: which of two equally short tours is taken hangs on the rounding.
  bool has_many_holes = false;
  /// How many times as far from its sharpest corner a V-bit ends as from the sides.
  double in_corners = 1;
};

constexpr Example kBracket{"bracket.dxf", "bracket", "endmill:6", 2.5};
constexpr Example kExamples[] = {
    kBracket,
    {"bracket.toml", "bracket_job", std::nullopt, std::nullopt},
    {"fishhead.p21", "fishhead", std::nullopt, 50},
    {"fishhead_sloped.p21", "fishhead_sloped", std::nullopt, 50},
    {"nested.step", "nested", "endmill:6", 8},
    {"awkward.step", "awkward", "endmill:4", 8},
    {"sign.dxf", "sign", "vbit:60deg:10", std::nullopt},
    {"inlay_hole.dxf", "inlay_hole", "vbit:60deg:10 endmill:3", 4, false, 3.3},
    {"inlay_plug.dxf", "inlay_plug", "vbit:60deg:10 endmill:3", 4, false, 3.3},
    {"plate.dxf", "plate", "endmill:5 chamfer:90deg:8:tip=0.4", 3},
    {"table.dxf", "table", "endmill:12:length=30 tslot:20:length=8:shank=10", 7},
    {"flange.toml", "flange", std::nullopt, std::nullopt, true},
    {"gland.toml", "gland", std::nullopt, std::nullopt, true},
    {"inch_plate.dxf", "inch_plate", "endmill:0.25in drill:0.201in", std::nullopt, true}};
constexpr Example kFivePockets{"five_pockets.toml", "five_pockets", std::nullopt, std::nullopt};

struct Case {
  Example example;
  std::string dialect;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.example.file << " for " << c.dialect;
}

fs::path file_of(const Example& example) {
  return fs::path(CLEARCUT_SOURCE_DIR) / "examples" / example.file;
}

bool is_solid(const Example& example) {
  return fs::path(example.file).extension() == ".step";
}

PlanOptions options_of(const Case& c, bool inch) {
  PlanOptions options;
  if (c.example.file == std::string("bracket.toml"))
    options.machine = read::read_job(file_of(c.example)).machine;
  if (c.example.file == std::string("inch_plate.dxf")) options.tabs.count = 4;
  if (c.example.file == std::string("flange.toml") || c.example.file == std::string("gland.toml"))
    options = pipeline::options_of_job(read::read_job(file_of(c.example)));
  std::istringstream tools(c.example.tool.value_or(""));
  for (std::string tool; tools >> tool;) options.tools.push_back(resolve::parse_tool(tool));
  options.stepdown = c.example.stepdown;
  options.post.dialect = c.dialect;
  options.post.inch = inch;
  for (const std::string& name : test_support::controller_named(c.dialect).of_tools)
    options.accept.push_back(name);
  // Its firmware need not have inches.
  if (c.dialect == "marlin") options.accept.emplace_back("g20");
  // awkward.step shows what is left out of a solid.
  if (is_solid(c.example)) options.accept.emplace_back("left-out");
  return options;
}

/// The shortest example for every controller, and every example for one: those are kept as text.
bool is_kept_as_text(const Case& c, bool inch) {
  return c.example.folder == std::string("table") || (c.dialect == "linuxcnc" && !inch);
}

std::string difference_from_golden(const Case& c, bool inch, const std::string& program) {
  const std::string name = std::string(c.example.folder) + "/" + c.dialect + (inch ? "-inch" : "-mm") +
                           test_support::ending_in_tests(c.dialect);
  return test_support::difference_from_golden(name, program, is_kept_as_text(c, inch));
}

class ExampleProgram : public ::testing::TestWithParam<Case> {};

/// The control itself would take it, as far as its rules are known here.
void expect_accepted(const std::string& dialect, const std::string& program) {
  if (dialect == "grbl") {
    for (const auto& fault : test_support::grbl_faults(program))
      ADD_FAILURE() << fault.error << ": " << fault.text;
  }
  if (dialect == "linuxcnc" && test_support::has_rs274()) {
    const test_support::CanonProgram canon = test_support::run_rs274(program);
    EXPECT_TRUE(canon.accepted) << canon.message;
  }
}

/// Plans, compares with the golden program, and checks what stands there.
Toolpath checked_program(const Case& c, bool inch) {
  const Part part = read::read_part(file_of(c.example), {});
  const PlanOptions options = options_of(c, inch);
  const PlanResult planned = pipeline::plan_part(part, options);
  EXPECT_EQ(difference_from_golden(c, inch, planned.program), "");
  if (c.dialect == "marlin" && c.example.has_many_holes) {
    // Its programs name no tools: read back they are checked with those of the workplan in its order, holes run in another.
    EXPECT_TRUE(planned.findings.all.clean);
    return planned.toolpath;
  }
  const CheckResult checked = pipeline::check_program(part, planned.program, "golden", options,
                                                      read::gcode::dialect_named(c.dialect));
  EXPECT_EQ(verdict_and_reasons(checked.findings), "CLEAN\n");
  expect_accepted(c.dialect, planned.program);
  return checked.toolpath;
}

void expect_same_path(const Toolpath& one, const Toolpath& other, double limit) {
  ASSERT_EQ(one.sections.size(), other.sections.size());
  for (std::size_t s = 0; s < one.sections.size(); ++s) {
    const auto a = test_support::feed_moves(one.sections[s]), b = test_support::feed_moves(other.sections[s]);
    EXPECT_LE(test_support::largest_distance(a, b), limit) << one.sections[s].label;
    EXPECT_LE(test_support::largest_distance(b, a), limit) << one.sections[s].label;
  }
}

std::multiset<std::string> labels_of(const Toolpath& toolpath) {
  std::multiset<std::string> labels;
  for (const Section& section : toolpath.sections) labels.insert(section.label);
  return labels;
}

/// mm; what rounding to either unit's decimals may part, and 1 um.
double limit_of(const std::string& dialect) {
  PostOptions metric, inch;
  metric.dialect = inch.dialect = dialect;
  inch.inch = true;
  return 0.001 + 2 * post::rounding_of(metric) + 2 * post::rounding_of(inch);
}

/// Where the digits of both units are so fine that no stock is kept for them, both units are one plan.
bool is_one_plan(const std::string& dialect) {
  PostOptions inch;
  inch.dialect = dialect;
  inch.inch = true;
  return post::rounding_of(inch) <= inch.tol.gouge / 2;
}

TEST_P(ExampleProgram, IsTheGoldenOneAndCleanInBothUnits) {
  const Case& c = GetParam();
  if (is_solid(c.example) && !read::solids_can_be_read())
    GTEST_SKIP() << "built without Open CASCADE: STEP solids cannot be read";
  const Toolpath metric = checked_program(c, false), inch = checked_program(c, true);
  if (c.example.has_many_holes || !is_one_plan(c.dialect))
    EXPECT_EQ(labels_of(metric), labels_of(inch));
  else
    expect_same_path(metric, inch, c.example.in_corners * limit_of(c.dialect));
}

TEST(OtherFormsOfTheBracket, GiveItsGoldenProgram) {
  for (const char* file : {"bracket.json", "bracket.svg", "bracket.step"}) {
    SCOPED_TRACE(file);
    const Case c{{file, kBracket.folder, kBracket.tool, kBracket.stepdown}, "linuxcnc"};
    if (is_solid(c.example) && !read::solids_can_be_read()) continue;
    const PlanResult result =
        pipeline::plan_part(read::read_part(file_of(c.example), {}), options_of(c, false));
    EXPECT_TRUE(result.findings.all.clean);
    const std::string wanted =
        read_file((fs::path(CLEARCUT_SOURCE_DIR) / "tests/golden/examples/bracket/linuxcnc-mm.ngc").string());
    expect_same_path(result.toolpath, read::gcode::read_gcode(wanted, "golden").toolpath,
                     2 * post::rounding_of(options_of(c, false).post));
  }
}

/// The verdict on an example's program in mm with `from` replaced by `to` wherever it stands.
std::string verdict_with(const Case& c, const std::string& from, const std::string& to) {
  const Part part = read::read_part(file_of(c.example), {});
  std::string program = pipeline::plan_part(part, options_of(c, false)).program;
  EXPECT_NE(program.find(from), std::string::npos) << from;
  for (std::size_t at = 0; (at = program.find(from, at)) != std::string::npos; at += to.size())
    program.replace(at, from.size(), to);
  const auto found = pipeline::check_program(part, program, "changed", options_of(c, false),
                                             read::gcode::dialect_named(c.dialect));
  return verdict_and_reasons(found.findings);
}

TEST(ChangedExamples, ToolsThatAreDrivenOtherwiseThanIsStated) {
  const Case gland{{"gland.toml", "gland", std::nullopt, std::nullopt, true}, "linuxcnc"};
  EXPECT_NE(verdict_with(gland, "M3 S1200", "M3").find("condition stated-speed: T4 turns at 3500 rpm"),
            std::string::npos);
  EXPECT_NE(verdict_with(gland, "F150", "F950").find("condition stated-feed: T"), std::string::npos);
  EXPECT_EQ(verdict_with(gland, "M3 S1200", "M3 S1300"), "CLEAN\n");
}

TEST(ChangedExamples, ChamferMillsThatStandOrHaveAnotherLength) {
  const Case plate{{"plate.dxf", "plate", "endmill:5 chamfer:90deg:8:tip=0.4", 3}, "haas"};
  EXPECT_NE(verdict_with(plate, "M3 S3980\n", "").find("spindle off: CHAMFER"), std::string::npos);
  EXPECT_NE(verdict_with(plate, "G43 H2", "G43 H1").find("tool length: CHAMFER"), std::string::npos);
}

/// The grid's own reduction leaves corners uncut; all else is as for any other program.
Toolpath checked_elements(const std::string& dialect, bool inch) {
  const Case c{kFivePockets, dialect};
  const ElementsResult result =
      pipeline::plan_elements(read::read_elements(file_of(kFivePockets)), options_of(c, inch));
  EXPECT_EQ(difference_from_golden(c, inch, result.plan.program), "");
  for (const Fault& fault : result.plan.findings.faults)
    EXPECT_EQ(fault.kind, FaultKind::kUncut) << fault.text;
  expect_accepted(dialect, result.plan.program);
  return result.plan.toolpath;
}

TEST(FivePockets, AreTheGoldenProgramsInBothUnits) {
  for (const std::string& dialect : post::post_dialects()) {
    SCOPED_TRACE(dialect);
    expect_same_path(checked_elements(dialect, false), checked_elements(dialect, true), limit_of(dialect));
  }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Example& example : kExamples)
    for (const std::string& dialect : post::post_dialects()) all.push_back({example, dialect});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Golden, ExampleProgram, ::testing::ValuesIn(cases()));

}  // namespace
}  // namespace clearcut
