#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/units.h"
#include "geometry/vec2.h"
#include "kinematics/kinematics.h"

namespace clearcut::kinematics {
namespace {

/// Feed moves from place to place at one height.
class Path {
 public:
  explicit Path(Vec2 start, double z) : at_(start), z_(z) {}
  Path& to(Vec2 place, double feed = 1000) { return add(Edge::line(at_, place), z_, MoveKind::kCut, feed); }
  Path& ramp_to(Vec2 place, double z) { return add(Edge::line(at_, place), z, MoveKind::kRamp, 1000); }
  Path& rapid_to(Vec2 place) { return add(Edge::line(at_, place), z_, MoveKind::kRapid, 0); }
  PublishedTime time() const { return published_time(Toolpath{{section_}}); }

 private:
  Path& add(const Edge& edge, double z, MoveKind kind, double feed) {
    section_.moves.push_back({edge, z_, z, kind, MmPerMin::of(feed)});
    at_ = edge.to;
    z_ = z;
    return *this;
  }
  Section section_;
  Vec2 at_;
  double z_;
};

/// Figure 10 of CPO-kappa: three triangles 7.01 mm apart and two passages of 14.02 mm, 373.4802 mm, ten changes of direction; 26.30 s at
/// 1000 mm/min.
TEST(PublishedTime, OfFigure10) {
  constexpr double kEdge = 79.9861;
  const double height = kEdge * std::sqrt(3.0) / 2;
  const auto corners = [&](double from_wall) {
    const double half = kEdge / 2 - from_wall * std::sqrt(3.0);
    return std::array<Vec2, 3>{Vec2{kEdge / 2, height - 2 * from_wall}, Vec2{kEdge / 2 - half, from_wall},
                               Vec2{kEdge / 2 + half, from_wall}};
  };
  Path path(corners(5)[0], -2);
  for (const double from_wall : {5.0, 12.01, 19.02}) {
    const auto [top, left, right] = corners(from_wall);
    if (from_wall > 5) path.to(top);
    path.to(left).to(right).to(top);
  }
  const PublishedTime time = path.time();
  EXPECT_NEAR(time.length_mm, 373.4802, 5e-5);
  EXPECT_EQ(time.discontinuities, 10);
  EXPECT_EQ(time.slowest.mm_per_min(), 1000);
  EXPECT_EQ(time.fastest.mm_per_min(), 1000);
  EXPECT_NEAR(time.seconds(), 26.3028, 1e-4);
  EXPECT_NEAR(time.seconds_at(MmPerMin::of(500)), 48.7116, 1e-4);
}

/// A change of direction of 0.1 degree is the least that counts.
TEST(PublishedTime, DirectionsCountAsChangedFromATenthOfADegreeOn) {
  const auto changes_at = [](double degrees) {
    const Vec2 on = direction_of(degrees * kPi / 180);
    return Path({0, 0}, -1).to({10, 0}).to(Vec2{10, 0} + on * 10).time().discontinuities;
  };
  EXPECT_EQ(changes_at(0.0995), 0);
  EXPECT_EQ(changes_at(0.1005), 1);
}

TEST(PublishedTime, RampsAndRapidsAreNoSegments) {
  const PublishedTime time = Path({0, 0}, 0)
                                 .ramp_to({10, 0}, -1)
                                 .to({20, 0})
                                 .rapid_to({30, 10})
                                 .to({30, 20}, 500)
                                 .to({40, 20})
                                 .time();
  EXPECT_NEAR(time.length_mm, 30, 1e-12);
  EXPECT_NEAR(time.cutting_s, 0.6 + 1.2 + 0.6, 1e-12);
  EXPECT_EQ(time.discontinuities, 1);
  EXPECT_EQ(time.slowest.mm_per_min(), 500);
  EXPECT_EQ(time.fastest.mm_per_min(), 1000);
}

}  // namespace
}  // namespace clearcut::kinematics
