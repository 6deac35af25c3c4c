// The exact answers against slow, plain ones: dense sampling and rasters.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/random.h"
#include "verify/coverage/coverage.h"
#include "verify/part/legal_centers.h"
#include "verify/program/shaped_cutter.h"
#include "verify/test_program.h"

namespace clearcut::verify {
namespace {

using testing::pocket_part;
using testing::rectangle;

/// A random star-shaped outline of lines and arcs about (0, 0), perhaps with a round island; empty if it
/// crosses itself.
Regions random_outline(Random& random) {
  std::vector<BulgeVertex> vertices;
  const int n = 5 + static_cast<int>(random.below(9));
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * (i + random.between(-0.3, 0.3)) / n;
    const double bulge = random.below(2) == 0 ? 0 : random.between(-0.5, 0.5);
    vertices.push_back({direction_of(angle) * random.between(9, 15), bulge});
  }
  const Loop loop = loop_from_bulges(vertices);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    for (std::size_t j = i + 1; j < loop.size(); ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j + 1 == loop.size());
      if (intersections(loop[i], loop[j]).size() > (neighbours ? 1u : 0u)) return {};
    }
  }
  std::vector<Loop> islands;
  const Vec2 island{random.between(-2, 2), random.between(-2, 2)};
  Region region = Region::from_valid_loops(loop, {});
  if (random.below(2) == 0 && region.contains(island) && region.boundary_distance(island) > 2.5) {
    islands.push_back(testing::circle_loop(island, 2));
  }
  return {Region::from_valid_loops(loop, islands)};
}

Edge random_path(Random& random, double reach) {
  const Vec2 a{random.between(-reach, reach), random.between(-reach, reach)};
  const Vec2 b{random.between(-reach, reach), random.between(-reach, reach)};
  const auto kind = random.below(5);
  if (kind == 0) return Edge::line(a, a);
  return kind < 3 ? Edge::line(a, b) : Edge::from_bulge(a, b, random.between(-1.2, 1.2));
}

// What correct means: as long as the centre stays out of the part, the gouge is radius - least distance to
// the outline. When the centre itself enters the part the gouge is at least the radius (or the height of the
// part).
TEST(Differential, GougesAgreeWithDenseSampling) {
  Random random(5);
  int touching = 0, clear = 0, inside = 0;
  for (int round = 0; round < 150; ++round) {
    const Regions outline = random_outline(random);
    if (outline.empty()) continue;
    const Part part = pocket_part(outline, 4, -100);
    const FinishedPart finished(part);
    for (int k = 0; k < 10; ++k) {
      const Edge path = random_path(random, 11);
      const double radius = random.between(0.5, 3), z = -random.between(10, 90);
      double least = 1e9, step = 0;
      bool enters = false;
      const int n = path.from == path.to ? 0 : 2000;
      for (int i = 0; i <= n; ++i) {
        const Vec2 p = n == 0 ? path.from : path.at(static_cast<double>(i) / n);
        least = std::min(least, outline[0].boundary_distance(p));
        enters = enters || !outline[0].contains(p);
      }
      if (n > 0) step = path.length() / n;
      const Move move{path, z, z, MoveKind::kCut, MmPerMin::of(1000), 1};
      const auto gouge = gouge_of(finished, move, radius, 0.001, false);
      const double depth = gouge ? gouge->depth : 0;
      if (enters) {
        ++inside;
        EXPECT_GE(depth, radius - step) << round;
        continue;
      }
      ++(least < radius ? touching : clear);
      EXPECT_LE(depth, std::max(0.0, radius - least) + step) << round;
      EXPECT_GE(depth, radius - least - 1e-9) << round;
    }
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(clear, 100);
  EXPECT_GT(inside, 100);
}

// The same while the tip goes down through the floor of a shelf: the part stands from a ring's floor at -1
// upwards.
TEST(Differential, RampsAreCheckedByTheFloorTheyPass) {
  Part part = pocket_part(testing::rectangle(0, 0, 60, 40), 4, -1);
  part.features.push_back(part.features[0]);
  part.features[1].name = "DEEP";
  part.features[1].target = part.features[1].allowed = testing::rectangle(20, 10, 40, 30);
  part.features[1].top_z = -1;
  part.features[1].floor_z = -5;
  const FinishedPart finished(part);
  Random random(9);
  int gouging = 0;
  for (int round = 0; round < 2000; ++round) {
    const Vec2 a{random.between(14, 46), random.between(6, 34)},
        b{random.between(14, 46), random.between(6, 34)};
    const double radius = 2, z0 = -random.between(0, 4), z1 = -random.between(0, 4);
    double expected = 0;
    const int n = 2000;
    for (int i = 0; i <= n; ++i) {
      const double t = static_cast<double>(i) / n, z = z0 + (z1 - z0) * t;
      const Vec2 p = lerp(a, b, t);
      if (z >= -1) continue;
      const Region& deep = part.features[1].allowed[0];
      const double sideways =
          deep.contains(p) ? radius - deep.boundary_distance(p) : radius + deep.boundary_distance(p);
      expected = std::max(expected, std::min(sideways, -1 - z));
    }
    const auto gouge = gouge_of(finished, {Edge::line(a, b), z0, z1, MoveKind::kRamp, MmPerMin::of(300), 1},
                                radius, 0.001, false);
    const double depth = gouge ? gouge->depth : 0;
    // A piece below the shelf is checked at its lowest tip: never less than what sampling finds.
    EXPECT_GE(depth, expected - 0.002) << round;
    if (expected == 0) {
      EXPECT_LE(depth, 0.001) << round;
    }
    gouging += expected > 0.01;
  }
  EXPECT_GT(gouging, 300);
  EXPECT_LT(gouging, 1900);
}

/// Points of a square grid with what plain search says about them.
struct Raster {
  static constexpr double kStep = 0.2;
  struct Sample {
    Vec2 p;
    /// Distance to the nearest legal grid point, at most half a diagonal too long; huge where it is farther than asked about.
    double to_legal = 1e9;
    double excess = 1e9;  ///< distance to the nearest path less the radius
  };
  std::vector<Sample> samples;
  std::vector<Vec2> legal;  ///< grid points where the centre may be, ascending in x

  Raster(const Region& region, double radius, double allowance, const std::vector<Swath>& swaths) {
    for (double x = -16; x <= 16; x += kStep) {
      for (double y = -16; y <= 16; y += kStep) {
        const Vec2 p{x, y};
        if (!region.contains(p)) continue;
        if (region.boundary_distance(p) >= radius + allowance) legal.push_back(p);
        samples.push_back({p});
      }
    }
    for (Sample& sample : samples) {
      double squared = 1e18;
      for (const Vec2 c : legal_about(sample.p.x, radius + 2 * kStep)) {
        squared = std::min(squared, norm_squared(c - sample.p));
      }
      sample.to_legal = std::sqrt(squared);
      for (const Swath& swath : swaths) {
        sample.excess = std::min(sample.excess, distance(swath.path, sample.p) - swath.radius);
      }
    }
  }

  /// The legal grid points whose x is no farther from this one.
  std::span<const Vec2> legal_about(double x, double far) const {
    const auto by_x = [](Vec2 p, double at) { return p.x < at; };
    const auto begin = std::lower_bound(legal.begin(), legal.end(), x - far, by_x);
    return {begin, std::lower_bound(begin, legal.end(), x + far, by_x)};
  }
};

/// Whether a legal grid centre reaches all of a disc, as far as places on three circles in it tell.
bool all_within_reach(const Raster& raster, Vec2 center, double disc, double radius) {
  for (int i = 0; i < 192; ++i) {
    const Vec2 q = center + direction_of(2 * kPi * i / 64) * (disc * (1 + i % 3) / 3);
    const auto near = raster.legal_about(q.x, radius + Raster::kStep);
    if (std::none_of(near.begin(), near.end(),
                     [&](Vec2 c) { return norm_squared(c - q) <= radius * radius; }))
      return false;
  }
  return true;
}

/// Lower bound of the width of what is left within reach: the widest disc about a sample that lies in the region, outside all
/// that was cut, and within reach.
double least_width(const Raster& raster, const Region& region, double radius) {
  double widest = 0;
  for (const Raster::Sample& sample : raster.samples) {
    if (sample.to_legal > radius) continue;
    const double most = std::min(sample.excess, region.boundary_distance(sample.p));
    const double step = most / 32;
    while (widest + step <= most && all_within_reach(raster, sample.p, widest + step, radius)) widest += step;
  }
  return 2 * std::max(0.0, widest);
}

// What correct means: every point that a legal grid centre reaches and that no path covers lies within the
// thickness bound, and their area is not above the area bound; and neither bound is above what the raster,
// blurred by its own step, allows. The raster cannot see less than its step of 0.2 mm; the proof itself
// claims micrometres.
TEST(Differential, CoverageBoundsAgreeWithARaster) {
  Random random(21);
  const Tolerances tol;
  int uncut_cases = 0, unreachable_cases = 0;
  for (int round = 0; round < 18; ++round) {
    const Regions outline = random_outline(random);
    if (outline.empty()) continue;
    const double radius = random.between(1, 3), allowance = random.below(2) == 0 ? 0 : 0.3;
    const Part part = pocket_part(outline, 2 * radius, -2);
    const FinishedPart finished(part);
    CoverageQuestion question{&finished, &outline, -1.999, radius, radius, allowance, 0, 0, {}};
    for (int i = 0; i < 25; ++i) {
      Edge path = random_path(random, 12);
      if (std::abs(path.sweep()) > 2) path = path.part(0, 0.5);
      question.swaths.push_back({path, radius});
    }
    const Coverage coverage = coverage_of(question, tol);
    const Raster raster(outline[0], radius, allowance, question.swaths);
    const double cell = Raster::kStep * Raster::kStep, blur = Raster::kStep * 1.5;
    const double thick_low = least_width(raster, outline[0], radius);
    double area_low = 0, area_high = 0, thick_high = 0, unreachable_low = 0;
    for (const Raster::Sample& sample : raster.samples) {
      const double beside = outline[0].boundary_distance(sample.p);
      if (sample.to_legal <= radius && sample.excess > tol.uncut) area_low += cell;
      if (sample.to_legal <= radius + blur && sample.excess > -blur) area_high += cell;
      if (sample.to_legal <= radius + blur)
        thick_high = std::max(thick_high, 2 * std::min(sample.excess, beside) + 2 * blur);
      const bool in_residual = outline[0].boundary_distance(sample.p) < allowance + blur;
      if (sample.to_legal > radius + blur && sample.excess > blur && !in_residual) unreachable_low += cell;
    }
    EXPECT_GE(coverage.thickness_mm, thick_low) << round;
    // What is thick is bounded to 5 % of itself.
    EXPECT_LE(coverage.thickness_mm, 1.06 * thick_high + tol.uncut) << round;
    // The raster's own area is good to a step along the outline of what it counts.
    EXPECT_GE(coverage.uncut_mm2, area_low - 0.02 * area_low - 1) << round;
    EXPECT_LE(coverage.uncut_mm2, area_high + 0.02 * area_high + 1) << round;
    EXPECT_GE(coverage.unreachable_mm2, 0.9 * unreachable_low - 0.3) << round;
    uncut_cases += area_low > 5;
    unreachable_cases += unreachable_low > 0.2;
  }
  EXPECT_GT(uncut_cases, 3);
  EXPECT_GE(unreachable_cases, 2);
}

/// A pocket 28 mm wide and `height` mm high with an island that leaves 4 mm at its lower and upper side and corridors too narrow
/// for the cutter at its left and right one; another pocket stands `apart` mm left of it.
Part pocket_beside_a_pocket(double height, double corridor, double apart) {
  const Regions outer = rectangle(0, 0, 28, height);
  const std::vector<Vec2> corners{
      {corridor, 4}, {corridor, height - 4}, {28 - corridor, height - 4}, {28 - corridor, 4}};
  const Loop island = loop_from_points(corners);
  Part part = pocket_part({Region::from_valid_loops(outer[0].outer(), {island})}, 3, -1);
  Feature beside = part.features[0];
  beside.name = "BESIDE";
  beside.target = beside.allowed = rectangle(-apart - 30, height / 3, -apart, height / 2);
  part.features.push_back(beside);
  return part;
}

// What correct means: whatever lies beside the pocket, its corridors are out of reach, and all else was cut.
TEST(Differential, APocketBesideBringsNothingWithinReach) {
  const Tolerances tol;
  for (double height = 20; height < 80; height += 0.7) {
    for (const double apart : {1.0, 3.1, 4.2, 9.0}) {
      const Part part = pocket_beside_a_pocket(height, 1.1, apart);
      const FinishedPart finished(part);
      CoverageQuestion question{&finished, &part.features[0].target, -0.999, 1.5, 1.5, 0, 0, 0, {}};
      for (const double y : {1.5, height - 2.5}) {
        const std::vector<Vec2> ring{{1.5, y}, {26.5, y}, {26.5, y + 1}, {1.5, y + 1}};
        for (const Edge& edge : loop_from_points(ring)) question.swaths.push_back({edge, 1.5});
      }
      const Coverage coverage = coverage_of(question, tol);
      EXPECT_EQ(coverage.uncut_mm2, 0) << height << " " << apart;
      EXPECT_LE(coverage.thickness_mm, widest_left(tol)) << height << " " << apart;
      EXPECT_NEAR(coverage.unreachable_mm2, 2 * 1.1 * (height - 8), 6) << height << " " << apart;
    }
  }
}

// What correct means for the boundary of the legal centres: each of its points keeps its distance, and every
// legal grid point next to an illegal one has a piece of it near.
TEST(Differential, LegalBoundarySeparatesLegalFromIllegal) {
  Random random(33);
  const Tolerances tol;
  int borders = 0;
  for (int round = 0; round < 40; ++round) {
    const Regions outline = random_outline(random);
    if (outline.empty()) continue;
    const double reach = random.between(0.5, 3.5);
    const FinishedPart finished(pocket_part(outline, 2 * reach, -2));
    const LegalCenters legal(finished, -1.999, reach, 0, box(outline), tol);
    for (const Edge& edge : legal.boundary().edges()) {
      for (const double t : {0.0, 0.3, 0.5, 0.9, 1.0}) {
        const Vec2 p = edge.from == edge.to ? edge.from : edge.at(t);
        EXPECT_GE(outline[0].boundary_distance(p), reach - 1.1 * tol.fit) << round;
        EXPECT_TRUE(outline[0].contains(p)) << round;
      }
    }
    const double step = 0.3;
    for (double x = -16; x < 16; x += step) {
      for (double y = -16; y < 16; y += step) {
        const bool here = outline[0].contains({x, y}) && outline[0].boundary_distance({x, y}) >= reach;
        const Vec2 beside{x + step, y};
        const bool there = outline[0].contains(beside) && outline[0].boundary_distance(beside) >= reach;
        EXPECT_EQ(legal.contains({x, y}), here);
        if (here == there) continue;
        ++borders;
        EXPECT_LE(legal.boundary().nearest({x + step / 2, y}).distance, step) << round;
      }
    }
  }
  EXPECT_GT(borders, 500);
}

}  // namespace
}  // namespace clearcut::verify
