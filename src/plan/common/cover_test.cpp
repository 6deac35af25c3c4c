#include "plan/common/cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include "base/random.h"
#include "base/units.h"

namespace clearcut::plan {
namespace {

constexpr double kSide = 60;  // mm
const auto kEverywhere = [](Vec2) { return true; };

/// Two sides of a square, then chords of it.
std::vector<Edge> chords(Random& random, int count) {
  std::vector<Edge> edges{Edge::line({0, 0}, {kSide, 0}), Edge::line({kSide, kSide}, {0, kSide})};
  const auto place = [&] { return Vec2{random.between(0, kSide), random.between(0, kSide)}; };
  for (int i = 0; i < count; ++i) edges.push_back(Edge::line(place(), place()));
  return edges;
}

std::vector<Vec2> sorted(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  return points;
}

/// Whether a point of the sorted ones is at p.
bool has(const std::vector<Vec2>& points, Vec2 p) {
  constexpr double kSame = 1e-6;
  auto at =
      std::lower_bound(points.begin(), points.end(), p.x - kSame, [](Vec2 a, double x) { return a.x < x; });
  for (; at != points.end() && at->x <= p.x + kSame; ++at) {
    if (distance(*at, p) <= kSame) return true;
  }
  return false;
}

TEST(Cover, CrowdedSquaresHideNoHole) {
  // Laid over a cover of its first two edges the rest is searched without quartering any square.
  for (int seed = 1; seed <= 6; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const double radius = random.between(0.05, 0.6);
    const auto edges = chords(random, 1200);
    auto few = std::make_shared<Cover>(std::span(edges).first(2), radius);
    few->keep_rim(kEverywhere);
    const auto found = sorted(Cover(edges, radius).holes(kEverywhere));
    const auto expected = Cover(std::span(edges).subspan(2), few).holes(kEverywhere);
    EXPECT_FALSE(expected.empty()) << seed;
    const auto missed =
        std::count_if(expected.begin(), expected.end(), [&](Vec2 p) { return !has(found, p); });
    EXPECT_EQ(missed, 0) << seed;
  }
}

/// What a random cover is made of.
enum class Kind { kLines, kTangential, kSwinging, kRepeated };
constexpr Kind kKinds[] = {Kind::kLines, Kind::kTangential, Kind::kSwinging, Kind::kRepeated};

/// A few paths of short edges within a few radii of each other.
std::vector<Edge> random_paths(Random& random, Kind kind, int count) {
  std::vector<Edge> edges;
  Vec2 at, heading{1, 0};
  for (int i = 0; i < count; ++i) {
    if (i == 0 || random.between(0, 1) < 0.15) {
      at = {random.between(0, 4), random.between(0, 4)};
      heading = direction_of(random.between(0, 2 * kPi));
    }
    const bool goes_on = kind == Kind::kTangential && random.between(0, 1) < 0.8;
    const double turn = kind == Kind::kSwinging ? (i % 2 == 0 ? 1 : -1) * random.between(1.6, kPi)
                                                : random.between(-kPi, kPi);
    const double bend = kind != Kind::kLines && random.between(0, 1) < 0.7 ? random.between(-1.2, 1.2) : 0;
    // The chord of an arc is turned by half its sweep from its beginning.
    const Vec2 chord = rotated(heading, (goes_on ? 0 : turn) + bend);
    const double reach = kind == Kind::kSwinging ? 0.3 : random.between(0.02, 2.5);
    edges.push_back(Edge::from_bulge(at, at + chord * reach, std::tan(bend / 2)));
    at = edges.back().to;
    heading = edges.back().tangent_at(1);
    if (kind == Kind::kRepeated && random.between(0, 1) < 0.5) {
      const Edge again =
          edges[static_cast<std::size_t>(random.between(0, 0.999) * static_cast<double>(i + 1))];
      edges.push_back(random.between(0, 1) < 0.5 ? again : again.reversed());
      at = edges.back().to;
    }
  }
  return edges;
}

void add_circle(Vec2 center, double radius, std::vector<Edge>& out) {
  const Vec2 east = center + Vec2{radius, 0}, west = center - Vec2{radius, 0};
  out.push_back(Edge::arc(east, west, center, Turn::kCounterClockwise));
  out.push_back(Edge::arc(west, east, center, Turn::kCounterClockwise));
}

/// All that may bound the sweeps of the edges.
std::vector<Edge> rims(const std::vector<Edge>& edges, double radius) {
  std::vector<Edge> out;
  for (const Edge& e : edges) {
    add_circle(e.from, radius, out);
    add_circle(e.to, radius, out);
    for (const double side : {radius, -radius}) {
      // Inside an arc narrower than the cutter nothing is a rim.
      const double wide = e.radius() + (e.turn == Turn::kClockwise ? side : -side);
      if (e.is_arc() && wide < 1e-6) continue;
      const Vec2 from = e.from + left_of(e.tangent_at(0)) * side, to = e.to + left_of(e.tangent_at(1)) * side;
      out.push_back({from, to, e.center, e.turn});
    }
  }
  return out;
}

double clearance(const std::vector<Edge>& edges, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Edge& e : edges) least = std::min(least, distance(e, p));
  return least;
}

/// mm. Where a line touches a circle, places much farther inside would lie micrometres away.
constexpr double kRounding = 1e-12;

/// Vertices of the swept area's border, from all pairs of all that may bound it.
std::vector<Vec2> border_vertices(const std::vector<Edge>& edges, double radius) {
  const auto all = rims(edges, radius);
  std::vector<Vec2> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Box near = all[i].box().grown(1e-9);
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const bool same_circle =
          all[i].is_arc() && all[j].is_arc() && distance(all[i].center, all[j].center) < 1e-6;
      if (same_circle || !near.overlaps(all[j].box())) continue;
      for (const Vec2 p : intersections(all[i], all[j]))
        if (clearance(edges, p) >= radius - kRounding) found.push_back(p);
    }
  }
  return found;
}

/// Wide enough for whatever is laid over it.
std::shared_ptr<const Cover> base_of(std::vector<Edge> edges, double radius) {
  edges.push_back(Edge::line({-20, -20}, {-20, -19}));
  edges.push_back(Edge::line({25, 25}, {25, 24}));
  auto base = std::make_shared<Cover>(edges, radius);
  base->keep_rim(kEverywhere);
  return base;
}

TEST(Cover, FindsAllVerticesOfTheBorder) {
  std::size_t vertices = 0;
  for (int seed = 1; seed <= 3000; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto edges = random_paths(random, kKinds[seed % 4], 3 + seed % 11);
    const double radius = random.between(0.05, 1.5);
    const auto expected = border_vertices(edges, radius);
    vertices += expected.size();
    const auto half = static_cast<std::ptrdiff_t>(edges.size() / 2 + 1);
    const std::vector<Edge> later(edges.begin() + half, edges.end());
    for (const Cover& cover : {Cover(edges, radius), Cover(edges, radius, Cover::SearchPlaces::kAtRims),
                               Cover(later, base_of({edges.begin(), edges.begin() + half}, radius))}) {
      const auto found = sorted(cover.holes(kEverywhere));
      for (const Vec2 p : expected) EXPECT_TRUE(has(found, p)) << seed << ": " << p.x << ' ' << p.y;
      for (const Vec2 p : found) EXPECT_GE(clearance(edges, p), radius - 2e-7) << seed;
    }
    EXPECT_TRUE(Cover(edges, radius).has_hole({{-10, -10}, {20, 20}}, kEverywhere)) << seed;
  }
  EXPECT_GT(vertices, 30000U);
}

TEST(Cover, WithCellsInABoxAloneFindsTheHolesThatLieThere) {
  int holes = 0, none = 0;
  for (int seed = 1; seed <= 1000; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto edges = random_paths(random, kKinds[seed % 4], 3 + seed % 11);
    const double radius = random.between(0.05, 1.5);
    const Vec2 corner{random.between(-2, 12), random.between(-2, 12)};
    const Box where{corner, corner + Vec2{random.between(0.1, 4), random.between(0.1, 4)}};
    const auto inside = [&](Vec2 p) { return where.contains(p); };
    const bool has_hole = Cover(edges, radius).has_hole(where, inside);
    EXPECT_EQ(Cover(edges, radius, where).has_hole(where, inside), has_hole) << seed;
    ++(has_hole ? holes : none);
  }
  EXPECT_GT(holes, 100);
  EXPECT_GT(none, 100);
}

TEST(Cover, DistancesAboveALeastOneAreTheDistances) {
  int above = 0, below = 0;
  for (int seed = 1; seed <= 400; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto edges = random_paths(random, kKinds[seed % 4], 3 + seed % 11);
    const Cover cover(edges, random.between(0.5, 1.5));
    const Vec2 p{random.between(0, 10), random.between(0, 10)};
    const double distance = cover.distance_to(p), least = random.between(0, 1.5);
    const auto found = cover.distance_above(least, p);
    ASSERT_EQ(found.has_value(), distance > least) << seed;
    EXPECT_EQ(found.value_or(distance), distance) << seed;
    ++(found ? above : below);
  }
  EXPECT_GT(above, 20);
  EXPECT_GT(below, 20);
}

}  // namespace
}  // namespace clearcut::plan
