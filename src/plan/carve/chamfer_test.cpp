// Chamfers on random outlines against dense sampling: a height field made of the cone's places alone, and distances to a fine polygon.
#include "plan/carve/chamfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "base/units.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::plan::carve {
namespace {

constexpr double kMill = 1.5;  // mm; radius of the mill that made the wall

/// Corners at ascending angles about the origin.
Loop star(std::mt19937& random) {
  std::uniform_int_distribution<int> corners(3, 14);
  std::uniform_real_distribution<double> away(7, 20), share(0.15, 0.85);
  const int count = corners(random);
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i)
    points.push_back(direction_of(2 * kPi * (i + share(random)) / count) * away(random));
  return loop_from_points(points);
}

Regions opened(const Regions& regions, double radius, const Tolerances& tol) {
  Regions centers;
  for (const Region& region : regions) {
    for (Region& one : inset(region, radius, tol)) centers.push_back(std::move(one));
  }
  return centers.empty() ? Regions{} : dilate(centers, radius, tol);
}

Regions closed(const Regions& regions, double radius, const Tolerances& tol) {
  Regions out;
  for (const Region& region : dilate(regions, radius, tol)) {
    for (Region& one : inset(region, radius, tol)) out.push_back(std::move(one));
  }
  return out;
}

struct Case {
  Chamfer chamfer;
  ChamferShape shape;
  std::vector<StandingUpTo> standing;
};

/// A pocket, or an island in a kerf; every third with rounded corners.
Case random_case(int seed, const Tolerances& tol) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> depth(0.1, 1.0), half_angle(20, 50), tip(0, 0.4);
  Case out;
  out.chamfer.line = star(random);
  if (seed % 3 == 0) {
    const Regions round = opened({Region::from_valid_loops(out.chamfer.line, {})}, 2.0, tol);
    if (!round.empty()) out.chamfer.line = round.front().outer();
  }
  out.chamfer.air_inside = seed % 2 == 0;
  out.chamfer.depth = depth(random);
  out.chamfer.reach = kMill;
  out.chamfer.free_floor = -6;
  out.shape.slope = std::tan(half_angle(random) * kPi / 180);
  out.shape.tip_radius = tip(random);
  out.shape.tool_radius = 6;
  out.shape.stepdown = 10;
  const Regions within{Region::from_valid_loops(out.chamfer.line, {})};
  const double width = out.chamfer.depth * out.shape.slope;
  if (out.chamfer.air_inside) {
    out.chamfer.free_beside = opened(within, kMill, tol);
    out.standing.push_back({0, dilate(within, width, tol)});
  } else {
    out.chamfer.free_beside = subtract(dilate(within, 8, tol), closed(within, kMill, tol), tol);
    Regions left;
    for (const Region& region : within) {
      for (Region& one : inset(region, width, tol)) left.push_back(std::move(one));
    }
    out.standing.push_back({0, subtract(dilate(within, 8, tol), left, tol)});
  }
  return out;
}

/// Finely flattened, with nothing of the library but the edges' points.
std::vector<Vec2> points_of(const std::vector<Edge>& edges, double spacing) {
  std::vector<Vec2> points;
  for (const Edge& edge : edges) {
    const int count = std::max(1, static_cast<int>(std::ceil(edge.length() / spacing)));
    for (int i = 0; i <= count; ++i) points.push_back(edge.at(static_cast<double>(i) / count));
  }
  return points;
}

double apart(Vec2 p, Vec2 a, Vec2 b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double apart(Vec2 p, const std::vector<Vec2>& chain) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    least = std::min(least, apart(p, chain[i], chain[i + 1]));
  return least;
}

bool is_within(Vec2 p, const std::vector<Vec2>& chain) {
  bool within = false;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Vec2 a = chain[i], b = chain[i + 1];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) within = !within;
  }
  return within;
}

struct Cone {
  double tip, tip_radius, slope;
};

/// Lowest height over p of a cone that stood on the stretches of its path.
double height_over(Vec2 p, const std::vector<std::vector<Vec2>>& paths, const Cone& cone) {
  double away = HUGE_VAL;
  for (const auto& path : paths) away = std::min(away, apart(p, path));
  return cone.tip + std::max(0.0, away - cone.tip_radius) / cone.slope;
}

/// How many outlines all quarters try together: fewer where CLEARCUT_RANDOM_PARTS asks for few parts, as under sanitizers.
int random_outlines() {
  const char* set = std::getenv("CLEARCUT_RANDOM_PARTS");
  return set ? 20 * std::atoi(set) : 1000;
}

class ChamfersOfRandomOutlines : public ::testing::TestWithParam<int> {};

TEST_P(ChamfersOfRandomOutlines, NeitherGougeNorLeaveTheirEdge) {
  const Tolerances tol;
  int edges_checked = 0;
  for (int seed = GetParam(); seed < random_outlines(); seed += 4) {
    const Case c = random_case(seed, tol);
    const ChamferTracks tracks = chamfer_edge(c.chamfer, c.shape, c.standing, tol);
    if (c.chamfer.free_beside.empty()) continue;
    ASSERT_EQ(tracks.sets.size(), 1u) << seed;
    if (tracks.left_mm > 0) continue;  // a part too thin for its chamfer
    std::vector<std::vector<Vec2>> paths;
    double tip = 0;
    for (const Track& track : tracks.sets.front()) {
      std::vector<Edge> edges;
      for (const Track::Piece& piece : track.pieces) edges.push_back(piece.path), tip = piece.z_from;
      paths.push_back(points_of(edges, 0.05));
    }
    const Cone cone{tip, c.shape.tip_radius, c.shape.slope};
    const std::vector<Vec2> line = points_of(c.chamfer.line, 0.05);
    const double foot = -c.chamfer.depth, width = c.chamfer.depth * c.shape.slope;
    const double out = c.chamfer.air_inside ? -1 : 1;
    for (const Edge& edge : c.chamfer.line) {
      const int places = std::max(2, static_cast<int>(edge.length() / 1.0));
      for (int i = 0; i <= places; ++i) {
        const double t = static_cast<double>(i) / places;
        const Vec2 at = edge.at(t), into = left_of(edge.tangent_at(t)) * out;
        const bool reached = apart(at - into * (kMill - 0.001), line) > kMill - 0.002;
        for (const double share : {0.0, 0.3, 0.6, 0.95, 1.1}) {
          const Vec2 p = at + into * (share * width);
          // Where the part is thinner than that, it is beyond it.
          if (share > 0 && is_within(p, line) == c.chamfer.air_inside) continue;
          const double d = apart(p, line), ideal = std::min(0.0, foot + d / c.shape.slope);
          const double height = std::min(0.0, height_over(p, paths, cone));
          EXPECT_GE(height, ideal - 0.0015 / c.shape.slope - 0.0005) << "seed " << seed << " too deep";
          if (!reached) continue;
          EXPECT_LE(height, ideal + 0.0025 / c.shape.slope + 0.001) << "seed " << seed << " left";
        }
        edges_checked += reached;
      }
    }
  }
  EXPECT_GT(edges_checked, 5 * random_outlines());
}

INSTANTIATE_TEST_SUITE_P(Quarters, ChamfersOfRandomOutlines, ::testing::Range(0, 4));

}  // namespace
}  // namespace clearcut::plan::carve
