#include "report/result.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "report/sample_job.h"

namespace clearcut::report {
namespace {

using testing::HasSubstr;
using testing::Not;

Toolpath one_section(std::vector<Move> moves) {
  return {{Section{"P", 0, 1, 0, true, Coolant::kOff, std::move(moves)}}};
}

TEST(ResultFile, TriangleOfThePaperHasItsFirstContour) {
  // First contour (8.6603, 5.0) - (71.3259, 5.0) of the triangle with edge 79.9861, R = 5.
  sample::Moves m({8.660254, 5}, 0);
  m.to(MoveKind::kCut, {71.325846, 5}, 0);
  EXPECT_EQ(result_file(one_section(m.moves), {"triangle80", {{"P", {5, 12.01, 19.02}}}}),
            "# triangle80\n"
            "# x_i y_i x_f y_f [x_c y_c G02|G03], mm\n"
            "# P contours at 5.0000 12.0100 19.0200\n"
            "# P offset step 7.0100\n"
            "# P tool 1 z 0.0000\n"
            "8.6603 5.0000 71.3258 5.0000\n"
            "# total length 62.6656\n");
}

TEST(ResultFile, SaysOfWhatEquation9IsMade) {
  ResultInfo info{"a", {}, PublishedTime{373.4802, 22.408812, 10, MmPerMin::of(1000), MmPerMin::of(1000)}};
  EXPECT_THAT(result_file({}, info),
              HasSubstr("# time by CPO-rho eq. 9 26.30 s: sum L 373.4802 mm, V_f 1000 mm/min, "
                        "nd 10, tau 0.177 s\n"));
  info.published->slowest = MmPerMin::of(500);
  EXPECT_THAT(result_file({}, info), HasSubstr("V_f 500 to 1000 mm/min"));
}

TEST(ResultFile, NamesEveryStepWhereTheyDiffer) {
  EXPECT_THAT(result_file({}, {"a", {{"P", {4, 10, 17.5}}, {"Q", {4}}}}),
              HasSubstr("# P offset step 6.0000 7.5000\n# Q contours at 4.0000\n# total"));
}

TEST(ResultFile, HoldsEveryFeedMoveInPlanAndTheirLength) {
  const Toolpath toolpath = sample::toolpath();
  int expected = 0;
  double length = 0;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || move.is_vertical()) continue;
      ++expected;
      length += move.path.length();
    }
  }
  std::istringstream text(result_file(toolpath, {"sample", {}}));
  int segments = 0;
  double sum = 0;
  std::string last;
  for (std::string line; std::getline(text, line); last = line) {
    if (line[0] == '#') continue;
    ++segments;
    std::istringstream numbers(line);
    Vec2 from, to, center;
    std::string word;
    numbers >> from.x >> from.y >> to.x >> to.y;
    if (numbers >> center.x >> center.y >> word) {
      sum += Edge::arc(from, to, center, word == "G02" ? Turn::kClockwise : Turn::kCounterClockwise).length();
    } else {
      sum += distance(from, to);
    }
  }
  EXPECT_EQ(segments, expected);
  EXPECT_NEAR(sum, length, 0.001);
  EXPECT_NEAR(std::stod(last.substr(last.rfind(' '))), length, 0.0001);
}

TEST(ResultFile, ANameCannotStartALine) {
  EXPECT_THAT(result_file({}, {"a\n1 2 3 4", {}}), HasSubstr("# a 1 2 3 4\n"));
}

}  // namespace
}  // namespace clearcut::report
