#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/random.h"
#include "base/units.h"
#include "geometry/side_list.h"
#include "read/outline/outline_reader.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Part read(const std::string& text) {
  return read_edges(text, "plate.edges", ReadOptions{});
}

const Region& region_of(const Part& part) {
  return part.features.at(0).target.at(0);
}

std::string message_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string said(const Part& part, Severity severity) {
  std::string all;
  for (const auto& item : part.diagnostics.items()) {
    if (item.severity == severity) all += item.what + "\n";
  }
  return all;
}

/// CPO-kappa figure 10 prints the corners of this triangle: (0, 0), (79.9861, 0), (39.9931, 69.2700).
TEST(Edges, TheTriangleOfTheResultFile) {
  const Part part = read("name triangle\ndepth 2\n79.9861 60\n79.9861 60\n79.9861 60\n");
  EXPECT_EQ(part.name, "triangle");
  const Vec2 corners[] = {{0, 0}, {79.9861, 0}, {39.9931, 69.2700}};
  ASSERT_EQ(region_of(part).outer().size(), 3u);
  for (const auto& edge : region_of(part).outer()) {
    const double nearest = std::min(
        {distance(edge.from, corners[0]), distance(edge.from, corners[1]), distance(edge.from, corners[2])});
    EXPECT_LT(nearest, 1e-4);
  }
  EXPECT_DOUBLE_EQ(part.features[0].floor_z, -2);
  EXPECT_THAT(said(part, Severity::kNote), HasSubstr("closing error 0 mm"));
  EXPECT_EQ(part.workplan.size(), 1u);
}

TEST(Edges, StartAndOrientationMoveTheOutline) {
  const Part part = read("start 10 20\norientation 90\ndepth 1\n60 90\n40 90\n60 90\n40 90\n");
  const Box box = region_of(part).box();
  EXPECT_NEAR(box.min.x, -30, 1e-9);
  EXPECT_NEAR(box.max.x, 10, 1e-9);
  EXPECT_NEAR(box.min.y, 20, 1e-9);
  EXPECT_NEAR(box.max.y, 80, 1e-9);
}

/// CPO-rho appendix A: an arc of radius r in a corner of angle alpha has the length r (pi - alpha).
TEST(Edges, ConnectingArcs) {
  const Part part = read("depth 1\n60 90 8\n40 90\n60 90 5\n40 90\n");
  EXPECT_NEAR(region_of(part).area(), 2400 - (1 - kPi / 4) * (64 + 25), 1e-6);
  double arcs = 0;
  for (const auto& edge : region_of(part).outer()) arcs += edge.is_arc() ? edge.length() : 0;
  EXPECT_NEAR(arcs, (8 + 5) * kPi / 2, 1e-6);
}

TEST(Edges, LengthsMayEndWhereArcsBegin) {
  const Part corners = read("depth 1\n60 90 8\n40 90 8\n60 90 8\n40 90 8\n");
  const Part tangents = read("lengths tangents\ndepth 1\n44 90 8\n24 90 8\n44 90 8\n24 90 8\n");
  EXPECT_NEAR(region_of(corners).area(), region_of(tangents).area(), 1e-6);
  EXPECT_NEAR(region_of(tangents).box().min.x, 0, 1e-9) << "start is the corner";
}

TEST(Edges, AReflexCornerMayBeRoundedToo) {
  const Part part = read("depth 1\n40 90\n40 90\n20 90\n20 270 6\n20 90\n20 90\n");
  EXPECT_NEAR(region_of(part).area(), 1200 + (1 - kPi / 4) * 36, 1e-6);
}

TEST(Edges, InchesBecomeMillimetres) {
  const Part part = read("unit in\nstart 1 1\ntop 1\ndepth 0.5\n1 90\n1 90\n1 90\n1 90\n");
  EXPECT_NEAR(region_of(part).area(), 25.4 * 25.4, 1e-6);
  EXPECT_NEAR(region_of(part).box().min.x, 25.4, 1e-9);
  EXPECT_DOUBLE_EQ(part.features[0].floor_z, 12.7);
}

TEST(Edges, AClosingErrorIsReportedAndSharedOut) {
  const Part part = read("depth 2\n60 90\n40 90\n60 90\n39.98 90\n");
  EXPECT_THAT(said(part, Severity::kRepair), HasSubstr("closing error 0.02 mm (dx 0, dy -0.02)"));
  for (const auto& edge : region_of(part).outer()) {
    EXPECT_LT(std::min(std::abs(edge.length() - 40), std::abs(edge.length() - 60)), 0.021);
  }
}

TEST(Edges, TheUserMaySayHowMuchIsSharedOut) {
  EXPECT_THAT(message_of("depth 2\n60 90\n40 90\n60 90\n39 90\n"), HasSubstr("closing error 1 mm"));
  const Part part = read("depth 2\nclosing 1\n60 90\n40 90\n60 90\n39 90\n");
  EXPECT_NEAR(region_of(part).area(), 60 * 39.5, 2);
}

TEST(Edges, AnglesThatDoNotAddUpAreReported) {
  const Part part = read("depth 2\n60 90\n40 90\n60 90\n40 90.5\n");
  EXPECT_THAT(said(part, Severity::kWarning), HasSubstr("add up to 360.5 degrees, those of 4 edges to 360"));
}

TEST(Edges, BadFilesGiveOneLineWithFileAndLine) {
  const struct {
    const char* text;
    const char* place;
    const char* what;
  } cases[] = {{"", "plate.edges:1: ", "at least three"},
               {"depth 2\n10 60\n", "plate.edges:2: ", "1 edges enclose nothing"},
               {"10 60\n10 60\n10 60\n", "plate.edges: ", "no depth given"},
               {"depth 2\n10 60\n10\n10 60\n", "plate.edges:3: ", "LENGTH ANGLE"},
               {"depth 2\n10 60\n10 sixty\n10 60\n", "plate.edges:3: ", "'sixty' is no number"},
               {"depth 2\n10 60\n-10 60\n10 60\n", "plate.edges:3: ", "length must be above 0"},
               {"depth 2\n10 60\n10 0\n10 60\n", "plate.edges:3: ", "between 0 and 360"},
               {"depth 2\n10 60\n10 60 -1\n10 60\n", "plate.edges:3: ", "radius must be 0 or more"},
               {"depth 2\n10 60\n10 180 1\n10 60\n", "plate.edges:3: ", "180 degrees has no arc"},
               {"depth 2\n10 60 4\n10 60 4\n10 60\n", "plate.edges:3: ", "make the radii smaller"},
               {"depth 2\n10 300\n10 300\n10 300\n",
                "plate.edges: ", "add up to 900 degrees, those of 3 edges to 180"},
               {"depth 2\n10 90\n10 90\n12 90\n10 90\n", "plate.edges: ", "closing error 2 mm"},
               {"depth 0\n10 60\n10 60\n10 60\n", "plate.edges: ", "must be above 0"},
               {"depth 2 3\n10 60\n10 60\n10 60\n", "plate.edges:1: ", "takes one value"},
               {"depht 2\n10 60\n10 60\n10 60\n", "plate.edges:1: ", "'depht' is unknown"},
               {"unit furlong\n", "plate.edges:1: ", "unknown unit"},
               {"lengths long\n", "plate.edges:1: ", "corners or tangents"},
               {"start 1\n", "plate.edges:1: ", "takes x and y"},
               {"depth 2\n1e300 60\n1e300 60\n1e300 60\n", "plate.edges:2: ", "longer than 1000 m"}};
  for (const auto& row : cases) {
    const std::string message = message_of(row.text);
    EXPECT_THAT(message, StartsWith(row.place)) << row.text;
    EXPECT_THAT(message, HasSubstr(row.what)) << row.text;
    EXPECT_EQ(message.find('\n'), std::string::npos) << row.text;
  }
}

/// Any polygon, taken apart into lengths and angles, traces itself again.
TEST(SideList, TracesRandomPolygons) {
  for (int seed = 0; seed < 200; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<Vec2> corners;
    const int n = 3 + static_cast<int>(random.below(9));
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * kPi * (i + random.between(0.1, 0.9)) / n, radius = random.between(20, 60);
      corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    SideList list;
    list.start = corners[0];
    const Loop loop = loop_from_points(corners);
    list.orientation = std::atan2(loop[0].tangent_at(0).y, loop[0].tangent_at(0).x);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 in = loop[i].tangent_at(1), out = loop[(i + 1) % loop.size()].tangent_at(0);
      list.sides.push_back({loop[i].length(), kPi - std::atan2(cross(in, out), dot(in, out)), 0});
    }
    const Path trace = traced(list);
    ASSERT_EQ(trace.size(), loop.size());
    EXPECT_NEAR(angle_excess(list), 0, 1e-9);
    EXPECT_LT(norm(closing_error(trace)), 1e-9);
    for (std::size_t i = 0; i < loop.size(); ++i) EXPECT_LT(distance(trace[i].to, loop[i].to), 1e-9);
  }
}

}  // namespace
}  // namespace clearcut::read
