// Filled paths whose outlines touch, share corners and run along each other, beside the winding numbers of sampled points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "base/random.h"
#include "base/text.h"
#include "base/units.h"
#include "geometry/region.h"
#include "read/repair/clean.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

/// Rectangles and circles on a coarse lattice, so that most of them meet in some special way; then turned and shifted.
struct Scene {
  std::vector<Loop> loops;
  double scale = 1;

  explicit Scene(Random& random) {
    const auto on_lattice = [&](int most) {
      return static_cast<double>(random.below(static_cast<std::uint64_t>(most) + 1));
    };
    const bool turned = (random.unit() < 0.5);
    const Vec2 along = turned ? direction_of(random.between(0, 2 * kPi)) : Vec2{1, 0};
    scale = (random.unit() < 0.5) ? 1 : random.between(0.3, 20);
    const auto place = [&](Vec2 p) { return (along * p.x + left_of(along) * p.y) * scale; };
    for (std::uint64_t count = 2 + random.below(3); count > 0; --count) {
      const Vec2 low{on_lattice(6), on_lattice(6)};
      Loop loop;
      if ((random.unit() < 0.4)) {
        loop = full_circle(place(low), (1 + on_lattice(2)) * scale);
      } else {
        const Vec2 high = low + Vec2{1 + on_lattice(4), 1 + on_lattice(4)};
        const Vec2 corners[] = {place(low), place({high.x, low.y}), place(high), place({low.x, high.y})};
        loop = loop_from_points(corners);
      }
      loops.push_back((random.unit() < 0.7) ? loop : reversed(loop));
    }
  }

  std::string text() const {
    std::string out;
    for (const Loop& loop : loops) {
      for (const Edge& edge : loop)
        out += (edge.is_arc() ? "arc " : "line ") + trimmed(edge.from.x, 9) + " " + trimmed(edge.from.y, 9) +
               ", ";
      out += "\n";
    }
    return out;
  }

  double distance_to(Vec2 p) const {
    double least = HUGE_VAL;
    for (const Loop& loop : loops)
      for (const Edge& edge : loop) least = std::min(least, distance(edge, p));
    return least;
  }
  /// Around p, by the angles that pieces of the loops are seen under.
  int winding(Vec2 p) const {
    constexpr int kArcPieces = 64;
    double turn = 0;
    for (const Loop& loop : loops) {
      for (const Edge& edge : loop) {
        const int pieces = edge.is_arc() ? kArcPieces : 1;
        for (int k = 0; k < pieces; ++k) {
          const Vec2 a = edge.at(static_cast<double>(k) / pieces) - p, b = edge.at((k + 1.0) / pieces) - p;
          turn += std::atan2(cross(a, b), dot(a, b));
        }
      }
    }
    return static_cast<int>(std::lround(turn / (2 * kPi)));
  }
};

int scenes() {
  const char* asked = std::getenv("CLEARCUT_RANDOM_PARTS");
  return asked ? std::atoi(asked) : 250;
}

bool covers(const Regions& regions, Vec2 p) {
  for (const Region& region : regions)
    if (region.contains(p)) return true;
  return false;
}

/// A hole that touches its outline from within, and two rectangles across both.
TEST(Compounds, AHoleThatTouchesItsOutlineStaysAHole) {
  const Vec2 center{1.543776106, -4.197231866}, hole{2.272254513, -4.882300628};
  const Vec2 one[] = {{-2.74027505, -2.913913631},
                      {-4.110412576, -4.370870446},
                      {-0.468020537, -7.796214259},
                      {0.902116988, -6.339257444}};
  const Vec2 two[] = {{-2.011796643, -3.598982393},
                      {-3.381934168, -5.055939209},
                      {0.260457871, -8.481283022},
                      {1.630595396, -7.024326206}};
  const Compound path{0, true};
  const std::vector<RawCurve> curves{{full_circle(hole, 2), true, "path", path},
                                     {reversed(full_circle(center, 3)), true, "path", path},
                                     {loop_from_points(one), true, "path", path},
                                     {loop_from_points(two), true, "path", path}};
  Diagnostics diagnostics;
  const Regions regions = repair(curves, {}, diagnostics);
  EXPECT_FALSE(covers(regions, {0.647, -4.963}));
  EXPECT_FALSE(covers(regions, hole));
  EXPECT_TRUE(covers(regions, {-0.5, -4.2}));
  EXPECT_TRUE(covers(regions, {-0.9, -6.0}));
}

TEST(Compounds, AreWhatTheirFillRuleSaysHoweverTheirOutlinesMeet) {
  Random random(11);
  for (int n = 0; n < scenes(); ++n) {
    SCOPED_TRACE(n);
    const Scene scene(random);
    const bool nonzero = (random.unit() < 0.5);
    std::vector<RawCurve> curves;
    for (const Loop& loop : scene.loops) curves.push_back({loop, true, "path", Compound{0, nonzero}});
    RepairOptions options;
    options.may_be_empty = true;
    Diagnostics diagnostics;
    const Regions regions = repair(curves, options, diagnostics);
    for (int k = 0; k < 60; ++k) {
      const Vec2 p = Vec2{random.between(-14, 14), random.between(-14, 14)} * scene.scale;
      if (scene.distance_to(p) < 0.02 * scene.scale) continue;
      const int winding = scene.winding(p);
      ASSERT_EQ(covers(regions, p), nonzero ? winding != 0 : winding % 2 != 0)
          << scene.text() << "at " << p.x << " " << p.y << ", winding " << winding
          << (nonzero ? " nonzero" : " even-odd");
    }
  }
}

/// Outlines of a drawing that are not mended bound what the even-odd rule says, whatever they touch.
TEST(Outlines, AreAreasByTheEvenOddRuleUnlessAMendIsSaid) {
  Random random(12);
  int plain = 0;
  for (int n = 0; n < scenes(); ++n) {
    SCOPED_TRACE(n);
    const Scene scene(random);
    std::vector<RawCurve> curves;
    for (const Loop& loop : scene.loops) curves.push_back({loop, true, "outline", {}});
    Diagnostics diagnostics;
    Regions regions;
    try {
      regions = repair(curves, {}, diagnostics);
    } catch (const InputError&) {
      continue;
    }
    const auto& items = diagnostics.items();
    const auto is_mend = [](const Diagnostic& item) { return item.severity == Severity::kRepair; };
    if (std::any_of(items.begin(), items.end(), is_mend)) continue;
    ++plain;
    for (int k = 0; k < 60; ++k) {
      const Vec2 p = Vec2{random.between(-14, 14), random.between(-14, 14)} * scene.scale;
      if (scene.distance_to(p) < 0.02 * scene.scale) continue;
      ASSERT_EQ(covers(regions, p), scene.winding(p) % 2 != 0) << scene.text() << "at " << p.x << " " << p.y;
    }
  }
  EXPECT_GT(plain, scenes() / 10);
}

/// What a boolean leaves of thousands of strokes: where a band and its round end all but meet, an edge of a fraction of a nanometre that
/// runs back along its neighbour. On a board's legend each counted as a place where outlines meet.
TEST(Compounds, EdgesOfNanometresBetweenBandAndEndGo) {
  const Vec2 joint{10, 5}, beside{10 - 2e-7, 5 - 6e-8};
  const Loop band{Edge::arc({10, -5}, joint, {10, 0}, Turn::kCounterClockwise),
                  Edge::line(joint, beside),
                  Edge::line(beside, {0, 5}),
                  Edge::line({0, 5}, {0, -5}),
                  Edge::line({0, -5}, {10 - 3e-7, -5}),
                  Edge::line({10 - 3e-7, -5}, {10, -5})};
  const Loop clean = without_tiny_edges(band);
  ASSERT_EQ(clean.size(), 4u);
  for (std::size_t i = 0; i < clean.size(); ++i) {
    EXPECT_EQ(clean[i].to, clean[(i + 1) % clean.size()].from);
    EXPECT_GT(clean[i].length(), kTinyEdge);
  }
  EXPECT_NEAR(signed_area(clean), 100 + kPi * 25 / 2, 1e-5);
  EXPECT_TRUE(without_tiny_edges({Edge::line({0, 0}, {1e-5, 0}), Edge::line({1e-5, 0}, {0, 0})}).empty());
}

}  // namespace
}  // namespace clearcut::read
