// Short covers: everything is cleared, by a raster and by area; the same task gives the same path; walls are kept.
#include "plan/cover/shortest_cover.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/random.h"
#include "base/units.h"
#include "geometry/contours/boolean.h"
#include "plan/cover/witnesses.h"

namespace clearcut::plan::cover {
namespace {

Region box_region(double x0, double y0, double x1, double y1) {
  const std::vector<Vec2> corners{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

CoverEffort brief() {
  CoverEffort effort;
  effort.steps = 300'000;
  return effort;
}

/// The moves of a path, with that back to its first point if it is closed.
std::vector<Edge> moves_of(const std::vector<Vec2>& points, bool closed) {
  std::vector<Edge> moves;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i] != points[i - 1]) moves.push_back(Edge::line(points[i - 1], points[i]));
  if (closed && points.back() != points.front()) moves.push_back(Edge::line(points.back(), points.front()));
  return moves;
}

double distance_to(const std::vector<Edge>& moves, Vec2 p) {
  double least = 1e300;
  for (const Edge& move : moves) least = std::min(least, distance(move, p));
  return least;
}

/// The greatest distance of a raster's points from the path, and of points along the boundary.
double farthest(const Regions& area, const std::vector<Edge>& moves, double pitch) {
  double most = 0;
  const Box around = box(area);
  for (double y = around.min.y + pitch / 3; y < around.max.y; y += pitch)
    for (double x = around.min.x + pitch / 3; x < around.max.x; x += pitch)
      if (contains(area, {x, y})) most = std::max(most, distance_to(moves, {x, y}));
  for (const Edge& edge : edges_of(area))
    for (double along = 0; along <= edge.length(); along += pitch / 4)
      most = std::max(most, distance_to(moves, edge.at(along / edge.length())));
  return most;
}

/// What discs along the path leave of the area, mm2.
double area_left(Regions left, const std::vector<Edge>& moves, double radius) {
  for (const Edge& move : moves) {
    const Vec2 aside = left_of(unit(move.to - move.from)) * radius;
    Loop rim{Edge::line(move.from - aside, move.to - aside),
             Edge::arc(move.to - aside, move.to + aside, move.to, Turn::kCounterClockwise),
             Edge::line(move.to + aside, move.from + aside),
             Edge::arc(move.from + aside, move.from - aside, move.from, Turn::kCounterClockwise)};
    left = subtract(left, {Region::from_valid_loops(std::move(rim), {})}, {});
  }
  return area(left);
}

Regions random_area(Random& random) {
  Regions area{box_region(0, 0, random.between(3, 7), random.between(3, 7))};
  for (int i = 0; i < 3; ++i) {
    const Vec2 p{random.between(-1, 6), random.between(-1, 6)};
    area = subtract(
        area, {box_region(p.x, p.y, p.x + random.between(0.3, 2.5), p.y + random.between(0.3, 2.5))}, {});
  }
  return area;
}

TEST(ShortestCover, ClearsRandomAreas) {
  const char* asked = std::getenv("CLEARCUT_RANDOM_COVERS");
  const int rounds = asked ? std::atoi(asked) : 6;
  for (int round = 0; round < rounds; ++round) {
    Random random(static_cast<std::uint64_t>(round) + 1);
    CoverTask task;
    task.area = random_area(random);
    task.radius = random.between(0.3, 0.8);
    task.closed = round % 2 == 0;
    const CoverResult result = shortest_cover(task, brief());
    EXPECT_TRUE(result.proven) << round;
    const std::vector<Edge> moves = moves_of(result.points, task.closed);
    EXPECT_LT(farthest(task.area, moves, 0.05), task.radius + 1e-6) << round;
    EXPECT_LT(area_left(task.area, moves, task.radius), 1e-3) << round;
    EXPECT_GE(result.length, area(task.area) / (2 * task.radius) - kPi * task.radius / 2) << round;
    double length = 0;
    for (const Edge& move : moves) length += move.length();
    EXPECT_NEAR(length, result.length, 1e-9) << round;
  }
}

TEST(ShortestCover, BriefSearchesClearAllToo) {
  Random random(23);
  for (int round = 0; round < 3; ++round) {
    CoverTask task;
    task.area = random_area(random);
    task.radius = 0.5;
    task.corner_price = 0.1;
    CoverEffort effort = brief();
    effort.brief = true;
    const CoverResult result = shortest_cover(task, effort);
    EXPECT_TRUE(result.proven) << round;
    const std::vector<Edge> moves = moves_of(result.points, false);
    EXPECT_LT(farthest(task.area, moves, 0.05), task.radius + 1e-6) << round;
    EXPECT_LT(area_left(task.area, moves, task.radius), 1e-3) << round;
  }
}

TEST(ShortestCover, BriefSearchesOfRectanglesKeepToStrips) {
  CoverTask task;
  task.area = {box_region(0, 0, 20, 9.7)};
  task.radius = 0.5;
  task.corner_price = 0.1;
  CoverEffort effort = brief();
  effort.brief = true;
  const CoverResult result = shortest_cover(task, effort);
  EXPECT_TRUE(result.proven);
  // Ten strips along the longer side.
  EXPECT_LT(result.length, 10 * 20 + 9);
}

TEST(ShortestCover, StripAsWideAsTheDiscTakesOneLine) {
  CoverTask task;
  task.area = {box_region(0, 0, 10, 1)};
  task.radius = 0.51;
  const CoverResult result = shortest_cover(task, brief());
  EXPECT_TRUE(result.proven);
  EXPECT_LT(result.length, 10);
}

TEST(ShortestCover, RepeatsToTheLastBit) {
  Random random(5);
  CoverTask task;
  task.area = random_area(random);
  task.radius = 0.5;
  EXPECT_EQ(shortest_cover(task, brief()).points, shortest_cover(task, brief()).points);
}

TEST(ShortestCover, KeepsWithinWallsAndBeginsWhereAsked) {
  const Regions legal{box_region(0, 0, 8, 2), box_region(0, 3, 8, 5), box_region(6, 1, 8, 4)};
  Regions united;
  for (const Region& region : legal) united = unite(united, {region}, {});
  const LegalPaths paths(united);
  CoverTask task;
  task.area = {box_region(0.5, 0.5, 7.5, 1.5), box_region(0.5, 3.5, 7.5, 4.5)};
  task.radius = 0.5;
  task.legal = &paths;
  task.start = Vec2{1, 1};
  const CoverResult result = shortest_cover(task, brief());
  ASSERT_TRUE(result.proven);
  EXPECT_EQ(result.points.front(), *task.start);
  for (const Edge& move : moves_of(result.points, false))
    EXPECT_TRUE(paths.area().holds_line(move.from, move.to));
}

TEST(ShortestCover, StopsWhenCancelled) {
  std::stop_source source;
  source.request_stop();
  CoverTask task;
  task.area = {box_region(0, 0, 5, 5)};
  task.radius = 0.5;
  CoverEffort effort = brief();
  effort.cancel = source.get_token();
  EXPECT_ANY_THROW(shortest_cover(task, effort));
}

/// A box with discs left out at the points of a square lattice.
Regions sieve(double side, double pitch, double radius) {
  std::vector<Loop> islands;
  for (double y = pitch / 2; y < side; y += pitch) {
    for (double x = pitch / 2; x < side; x += pitch) {
      const Vec2 center{x, y}, out{radius, 0};
      islands.push_back(Loop{Edge::arc(center - out, center + out, center, Turn::kClockwise),
                             Edge::arc(center + out, center - out, center, Turn::kClockwise)});
    }
  }
  const std::vector<Vec2> corners{{0, 0}, {side, 0}, {side, side}, {0, side}};
  return {Region::from_valid_loops(loop_from_points(corners), std::move(islands))};
}

TEST(ShortestCover, LargeAreasKeepToTheirSteps) {
  CoverTask task;
  task.radius = 0.5;
  for (const Regions& area : {Regions{box_region(0, 0, 100, 60)}, sieve(30, 3, 0.7)}) {
    task.area = area;
    const CoverResult result = shortest_cover(task, brief());
    EXPECT_TRUE(result.proven);
    EXPECT_LT(farthest(area, moves_of(result.points, false), 1), task.radius + 1e-6);
    // A first path that clears all, and what the steps allow.
    EXPECT_LT(static_cast<double>(result.steps),
              1.2 * static_cast<double>(brief().steps) + 5000 * geometry::area(area));
  }
}

TEST(ShortestCover, CurvedBoundariesAreClearedExactly) {
  CoverTask task;
  task.radius = 0.5;
  task.area = sieve(6, 3, 0.7);
  const CoverResult result = shortest_cover(task, brief());
  EXPECT_TRUE(result.proven);
  EXPECT_LT(farthest(task.area, moves_of(result.points, false), 0.02), task.radius * (1 + 1e-8));
}

TEST(ShortestCover, TinyAreasEndTheSearch) {
  CoverTask task;
  task.area = {box_region(0, 0, 0.01, 0.01)};
  task.radius = 5;
  const CoverResult result = shortest_cover(task, brief());
  EXPECT_TRUE(result.proven);
  EXPECT_LT(result.length, 0.1);
}

TEST(ShortestCover, TimeThatIsOverEndsTheSearch) {
  CoverTask task;
  task.area = {box_region(0, 0, 5, 5)};
  task.radius = 0.5;
  CoverEffort effort;
  effort.steps = std::uint64_t{1} << 60;
  effort.seconds = 1e-3;
  EXPECT_TRUE(shortest_cover(task, effort).proven);
}

TEST(ShortestCover, NothingToClearIsNoPath) {
  EXPECT_TRUE(shortest_cover({}, brief()).points.empty());
}

TEST(ClearedBand, IsWhereTheMoveComesNear) {
  Random random(3);
  for (int round = 0; round < 2000; ++round) {
    const Vec2 a{random.between(-3, 3), random.between(-3, 3)};
    const Vec2 b = round % 5 == 0   ? Vec2{a.x, random.between(-3, 3)}
                   : round % 5 == 1 ? Vec2{random.between(-3, 3), a.y}
                                    : Vec2{random.between(-3, 3), random.between(-3, 3)};
    const ClearedBand band(a, b, 1);
    const Vec2 p{random.between(-5, 5), random.between(-4, 4)};
    const double away = distance(Edge::line(a, b), p);
    if (std::abs(away - 1) < 1e-9) continue;
    const ClearedBand::Run run = band.at(p.y);
    EXPECT_EQ(away < 1, p.x >= run.first && p.x <= run.last) << round;
  }
}

}  // namespace
}  // namespace clearcut::plan::cover
