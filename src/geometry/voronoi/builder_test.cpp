// The circle events given to Boost's Voronoi builder, against the builder's own big integers, on every event
// that comes up while it builds diagrams of random outlines: smooth, raw, on a coarse raster (parallel walls,
// equal distances), far out, and tiny.
#include "geometry/voronoi/builder.h"

#include <gtest/gtest.h>

#include <boost/version.hpp>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::inline geometry::voronoi {
namespace {

/// Roundings of a double that the builder tolerates.
constexpr double kTolerated = 64 * 0x1p-53;

struct Seen {
  int events = 0;
  double worst = 0;
  void compare(double ours, double exact) {
    const double off = std::abs(ours - exact) / std::abs(exact);
    if (!(off <= worst)) worst = off;
  }
};
Seen seen;

template <class Site, class Event>
class CheckedFormation {
 public:
  void ppp(const Site& a, const Site& b, const Site& c, Event& event) {
    ours_.ppp(a, b, c, event);
    check(event, [&](Event& exact) { exact_.ppp(a, b, c, exact); });
  }
  void pps(const Site& a, const Site& b, const Site& c, int index, Event& event) {
    ours_.pps(a, b, c, index, event);
    check(event, [&](Event& exact) { exact_.pps(a, b, c, index, exact); });
  }
  void pss(const Site& a, const Site& b, const Site& c, int index, Event& event) {
    ours_.pss(a, b, c, index, event);
    check(event, [&](Event& exact) { exact_.pss(a, b, c, index, exact); });
  }
  void sss(const Site& a, const Site& b, const Site& c, Event& event) {
    ours_.sss(a, b, c, event);
    check(event, [&](Event& exact) { exact_.sss(a, b, c, exact); });
  }

 private:
  template <class Make>
  void check(const Event& event, Make make) {
    Event exact;
    make(exact);
    if (!std::isfinite(exact.x()) || !std::isfinite(exact.lower_x())) return;
    ++seen.events;
    seen.compare(event.x(), exact.x());
    seen.compare(event.y(), exact.y());
    seen.compare(event.lower_x(), exact.lower_x());
  }

  CircleFormation<Site, Event> ours_;
  typename BuilderPredicates::template mp_circle_formation_functor<Site, Event> exact_;
};

struct CheckedPredicates : BuilderPredicates {
  template <class Site, class Event>
  using circle_formation_predicate = BuilderPredicates::circle_formation_predicate<
      Site, Event, BuilderPredicates::circle_existence_predicate<Site>, CheckedFormation<Site, Event>>;
};
using CheckedBuilder =
    boost::polygon::voronoi_builder<boost::polygon::detail::int32, BuilderTraits, CheckedPredicates>;

struct Shape {
  int vertices = 0;
  double radius = 0;  ///< grid units
  double noise = 0;   ///< of the radius
  int raster = 1;     ///< grid units
};

/// A star-shaped outline about a centre in the middle of positive coordinates: it never crosses itself.
std::vector<std::array<int, 2>> outline(const Shape& shape, Random& random) {
  std::vector<std::array<int, 2>> points;
  for (int i = 0; i < shape.vertices; ++i) {
    const double a = 2 * kPi * i / shape.vertices;
    const double r = shape.radius * (1 + 0.2 * std::sin(3 * a) + shape.noise * random.between(-1, 1));
    const auto on_raster = [&](double x) {
      return shape.raster * static_cast<int>(std::lround((2 * shape.radius + x) / shape.raster));
    };
    const std::array<int, 2> p{on_raster(r * std::cos(a)), on_raster(r * std::sin(a))};
    if (points.empty() || (p != points.back() && p != points.front())) points.push_back(p);
  }
  return points;
}

void build(const std::vector<std::array<int, 2>>& points) {
  CheckedBuilder builder;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &p = points[i], &q = points[(i + 1) % points.size()];
    builder.insert_segment(p[0], p[1], q[0], q[1]);
  }
  boost::polygon::voronoi_diagram<double> diagram;
  builder.construct(&diagram);
}

/// The builder's predicates are a detail of Boost, not its surface. With another version compare
/// boost/polygon/detail/voronoi_predicates.hpp with what builder.h replaces, let these tests run, and name the version here.
TEST(Builder, BoostIsOfTheVersionWhoseDetailsAreKnown) {
  EXPECT_EQ(BOOST_VERSION / 100, 1074);
}

class EventsOf : public testing::TestWithParam<Shape> {};

TEST_P(EventsOf, RandomOutlinesAreThoseOfTheBuildersBigIntegers) {
  seen = {};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    build(outline(GetParam(), random));
  }
  EXPECT_GT(seen.events, 1000);
  EXPECT_LE(seen.worst, kTolerated);
}

INSTANTIATE_TEST_SUITE_P(Shapes, EventsOf,
                         testing::Values(Shape{200, 1e6, 0, 1}, Shape{200, 1e6, 0.1, 1},
                                         Shape{60, 1e6, 0.1, 50000}, Shape{100, 5e8, 0.1, 1},
                                         Shape{100, 3000, 0.05, 1}, Shape{300, 1e6, 1e-6, 1}));

TEST(DoubleDouble, HoldsWhatADoubleCannot) {
  const DoubleDouble third = DoubleDouble(1.0) / DoubleDouble(3.0);
  const DoubleDouble zero = third * DoubleDouble(3.0) - DoubleDouble(1.0);
  EXPECT_LE(std::abs(zero.high), 0x1p-103);
  const DoubleDouble root = sqrt(DoubleDouble(2.0));
  EXPECT_LE(std::abs((root * root - DoubleDouble(2.0)).high), 0x1p-101);
  const std::int64_t large = 0x7fffffffffffffff;
  const DoubleDouble exact(large);
  EXPECT_EQ(static_cast<std::int64_t>(exact.high - 0x1p62) + static_cast<std::int64_t>(exact.low),
            large - (1L << 62));
}

}  // namespace
}  // namespace clearcut::inline geometry::voronoi
