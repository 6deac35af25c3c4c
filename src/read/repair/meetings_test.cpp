#include "read/repair/meetings.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"
#include "read/repair/clean.h"

namespace clearcut::read {
namespace {

Loop polygon(std::vector<Vec2> points) {
  return loop_from_points(points);
}

std::vector<MeetingKind> kinds(const std::vector<Loop>& loops) {
  std::vector<MeetingKind> out;
  for (const Meeting& meeting : meetings(loops, 1000, "test")) out.push_back(meeting.kind);
  return out;
}

using Kinds = std::vector<MeetingKind>;
constexpr auto kTouch = MeetingKind::kTouch;
constexpr auto kCrossing = MeetingKind::kCrossing;
constexpr auto kOverlap = MeetingKind::kOverlap;

TEST(Meetings, SimpleLoopsDoNotMeet) {
  EXPECT_TRUE(kinds({polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), full_circle({5, 5}, 2)}).empty());
}

TEST(Meetings, RoundedRectangleWithTangentArcsDoesNotMeetItself) {
  for (const double r : {0.001, 1.0, 5.0, 300.0}) {
    const double s = std::tan(kPi / 8);
    const BulgeVertex v[] = {{{r, 0}, 0},         {{3 * r, 0}, s}, {{4 * r, r}, 0}, {{4 * r, 3 * r}, s},
                             {{3 * r, 4 * r}, 0}, {{r, 4 * r}, s}, {{0, 3 * r}, 0}, {{0, r}, s}};
    EXPECT_TRUE(kinds({loop_from_bulges(v)}).empty()) << r;
  }
}

TEST(Meetings, BowTieCrossesItself) {
  EXPECT_EQ(kinds({polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}), Kinds{kCrossing});
}

TEST(Meetings, VertexOnAnEdgeTouches) {
  EXPECT_EQ(kinds({polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), polygon({{5, 0}, {7, 3}, {3, 3}})}),
            (Kinds{kTouch, kTouch}));  // with both edges of the vertex
}

TEST(Meetings, CircleTangentToAWallTouches) {
  for (const MeetingKind kind :
       kinds({polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), full_circle({2, 5}, 2)})) {
    EXPECT_EQ(kind, kTouch);
  }
}

/// A slot drawn as a rectangle and a circle about the middle of its end: the corners lie on the circle, where it is tangent to
/// the sides.
TEST(Meetings, ACornerOnATangentCircleCrosses) {
  Random random(3);
  for (int n = 0; n < 200; ++n) {
    const Vec2 along = direction_of(random.between(0, 2 * kPi)),
               center{random.between(-50, 50), random.between(-50, 50)};
    const double radius = random.between(0.5, 30);
    const Vec2 side = left_of(along) * radius, end = center + along * (3 * radius);
    const auto found =
        kinds({polygon({center - side, end - side, end + side, center + side}), full_circle(center, radius)});
    EXPECT_GE(std::count(found.begin(), found.end(), kCrossing), 2) << n;
  }
}

TEST(Meetings, CircleThroughAWallCrosses) {
  EXPECT_EQ(kinds({polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), full_circle({1, 5}, 2)}),
            (Kinds{kCrossing, kCrossing}));
}

TEST(Meetings, SharedWallOverlaps) {
  const auto found =
      kinds({polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), polygon({{10, 2}, {20, 2}, {20, 8}, {10, 8}})});
  EXPECT_EQ(std::count(found.begin(), found.end(), kOverlap), 1);
  EXPECT_EQ(std::count(found.begin(), found.end(), kCrossing), 0);
}

TEST(Meetings, SpikeOverlapsItself) {
  const auto found = kinds({polygon({{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, 15}, {5, 10}, {0, 10}})});
  EXPECT_GE(std::count(found.begin(), found.end(), kOverlap), 1);
}

TEST(Meetings, CrossingInASharedVertexIsSeen) {
  EXPECT_EQ(kinds({polygon({{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}}), polygon({{5, 5}, {4, 9}, {5, 2}})})
                .size(),
            5u);
  int crossings = 0;
  for (const MeetingKind kind : kinds({polygon({{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}}),
                                       polygon({{5, 5}, {5, 9}, {4, 9}, {5, 2}})})) {
    crossings += kind == kCrossing ? 1 : 0;
  }
  EXPECT_GE(crossings, 1);
}

/// Against all pairs of edges, on random triangles: the index may lose nothing.
TEST(Meetings, AgreesWithAllPairs) {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    std::vector<Loop> loops;
    for (int i = 0; i < 8; ++i) {
      std::vector<Vec2> points;
      for (int k = 0; k < 3; ++k) points.push_back({random.between(0, 10), random.between(0, 10)});
      loops.push_back(polygon(points));
    }
    std::size_t expected = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      for (std::size_t k = i + 1; k < loops.size(); ++k) {
        for (const Edge& a : loops[i]) {
          for (const Edge& b : loops[k]) expected += intersections(a, b).size();
        }
      }
    }
    EXPECT_EQ(meetings(loops, 100000, "test").size(), expected);
  }
}

}  // namespace
}  // namespace clearcut::read
