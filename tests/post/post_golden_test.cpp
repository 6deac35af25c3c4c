// Programs as they must be written, byte for byte: tests/golden, a folder a case.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/file.h"
#include "post/post.h"
#include "read/gcode/gcode.h"
#include "support/controllers.h"
#include "support/golden.h"
#include "support/independent/grbl.h"
#include "support/independent/rs274.h"
#include "support/programs.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::feed_moves;
using test_support::first_difference;
using test_support::largest_distance;

struct Case {
  std::string folder;
  std::vector<std::string> dialects;
  PostOptions options;
};

std::vector<std::string> with_home() {
  std::vector<std::string> names;
  for (const test_support::Controller& one : test_support::controllers())
    if (!one.home.empty()) names.emplace_back(one.name);
  return names;
}

std::vector<Case> cases() {
  PostOptions lines;
  lines.arcs = false;
  lines.tol.chord = 0.01;
  PostOptions by_hand;
  by_hand.tool_changer = false;
  by_hand.exact_stop = true;
  by_hand.spindle_wait = Seconds::of(4);
  PostOptions home;
  home.end = *end_position_named("home");
  PostOptions place;
  place.end = *end_position_named("0,40");
  return {{"end-home", with_home(), home},           {"end-place", post::post_dialects(), place},
          {"two-tools", post::post_dialects(), {}},  {"circles", post::post_dialects(), {}},
          {"lines-only", {"grbl", "marlin"}, lines}, {"by-hand", {"linuxcnc", "mach4", "fanuc"}, by_hand}};
}

fs::path folder_of(const Case& c) {
  return fs::path(CLEARCUT_SOURCE_DIR) / "tests/golden" / c.folder;
}

Part golden_part() {
  Part part;
  part.name = "GOLDEN";
  part.stock = Stock{{{0, 0}, {50, 40}}, -10, 0};
  part.clearance_z = 12;
  for (const int number : {1, 2}) {
    Tool tool;
    tool.number = number;
    tool.diameter = number == 1 ? 6 : 3;
    part.tools.push_back(tool);
  }
  return part;
}

PostOptions options_of(const Case& c, const std::string& dialect, bool inch) {
  PostOptions options = c.options;
  options.dialect = dialect;
  options.inch = inch;
  options.program_name = c.folder;
  options.header = {"STOCK 50 X 40 X 10 MM", "CUTTING TIME 1 MIN"};
  return options;
}

/// The written program is the toolpath again: sections, tools, speeds and, either way round, every point.
void expect_same(const Toolpath& wanted, const Toolpath& got, double tolerance) {
  ASSERT_EQ(wanted.sections.size(), got.sections.size());
  for (std::size_t s = 0; s < wanted.sections.size(); ++s) {
    EXPECT_EQ(wanted.sections[s].label, got.sections[s].label);
    EXPECT_EQ(wanted.sections[s].tool_number, got.sections[s].tool_number);
    EXPECT_EQ(wanted.sections[s].spindle_rpm, got.sections[s].spindle_rpm);
    EXPECT_EQ(wanted.sections[s].coolant, got.sections[s].coolant);
    const auto a = feed_moves(wanted.sections[s]), b = feed_moves(got.sections[s]);
    EXPECT_LE(largest_distance(a, b), tolerance);
    EXPECT_LE(largest_distance(b, a), tolerance);
    EXPECT_NEAR(feed_length(wanted.sections[s]), feed_length(got.sections[s]), 40 * tolerance);
  }
}

void check(const Case& c, const std::string& dialect, bool inch) {
  const PostOptions options = options_of(c, dialect, inch);
  const fs::path file =
      folder_of(c) / (dialect + (inch ? "-inch" : "-mm") + test_support::ending_in_tests(dialect));
  SCOPED_TRACE(file);
  const Toolpath input =
      read::gcode::read_gcode(read_file((folder_of(c) / "input.ngc").string()), "input.ngc").toolpath;
  const std::string text = post::write_program(input, golden_part(), options);
  if (std::getenv("CLEARCUT_UPDATE_GOLDEN")) std::ofstream(file, std::ios::binary) << text;
  ASSERT_TRUE(fs::exists(file));
  const std::string wanted = read_file(file.string());
  EXPECT_EQ(first_difference(text, wanted), "");
  const Program program = test_support::read_posted(wanted, dialect, input);
  EXPECT_TRUE(program.ended);
  expect_same(input, program.toolpath, 2 * post::rounding_of(options) + options.tol.chord);
  if (dialect == "grbl") {
    for (const auto& fault : test_support::grbl_faults(wanted))
      ADD_FAILURE() << fault.error << ": " << fault.text;
  }
}

TEST(Golden, EveryDialectWritesItsProgram) {
  int checked = 0;
  for (const Case& c : cases()) {
    for (const std::string& dialect : c.dialects) {
      check(c, dialect, false);
      check(c, dialect, true);
      checked += 2;
    }
  }
  EXPECT_EQ(checked, 112);
}

TEST(Golden, NoFileIsForgotten) {
  for (const Case& c : cases()) {
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder_of(c))) files += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(files, 2 * c.dialects.size() + 2) << c.folder << ": README.md, input.ngc and the programs";
  }
}

TEST(Golden, LinuxCncTakesItsOwn) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  for (const Case& c : cases()) {
    for (const auto& entry : fs::directory_iterator(folder_of(c))) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("linuxcnc", 0) != 0 && name.rfind("mach", 0) != 0 && name != "input.ngc") continue;
      const test_support::CanonProgram canon = test_support::run_rs274(read_file(entry.path().string()));
      EXPECT_TRUE(canon.accepted) << entry.path() << ": " << canon.message;
    }
  }
}

}  // namespace
}  // namespace clearcut
