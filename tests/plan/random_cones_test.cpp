// V-carvings and chamfers of random outlines (CLEARCUT_CONES says how many), from the drawing to the text of the program, against a second method: what cones leave
// that stood along every way in the text, beside the height that the distance to the drawn outline asks for. It shares neither
// reader nor geometry with what it judges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "pipeline/test_drawings.h"
#include "support/independent/drawn_outline.h"
#include "support/independent/plain_gcode.h"

namespace clearcut::pipeline {
namespace {

using test_support::Sample;
using test_support::Side;
using test_support::TipWay;

constexpr int kShards = 4;
constexpr double kSagitta = 0.0002;  // mm
/// mm sideways: half the last digit of a program in x and in y, chords here and there.
constexpr double kAside = 0.0015;
constexpr double kLastDigit = 0.0005;  // mm in z

/// Of all shards. 1000 take ten minutes of one core.
int outline_count() {
  const char* set = std::getenv("CLEARCUT_CONES");
  return set != nullptr ? std::atoi(set) : 240;
}

using Corners = std::vector<BulgeVertex>;

/// Corners at ascending angles about `center`.
Corners star(std::mt19937& random, int count, double least, double most, bool bows) {
  std::uniform_real_distribution<double> share(0, 1);
  Corners corners;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * (i + 0.6 * share(random)) / count;
    const double away = least + (most - least) * share(random);
    const double bulge = bows && share(random) < 0.3 ? 0.3 * share(random) - 0.1 : 0;
    corners.push_back({{away * std::cos(angle), away * std::sin(angle)}, bulge});
  }
  return corners;
}

struct Cone {
  double tip_radius = 0, slope = 1;
};

/// Lowest that the cone leaves over p while its tip goes a way: z and distance are convex along it, so that thirds find the least.
double lowest_over(Vec2 p, const TipWay& way, const Cone& cone) {
  const auto height = [&](double t) {
    const double x = way.x0 + (way.x1 - way.x0) * t, y = way.y0 + (way.y1 - way.y0) * t;
    const double away = std::max(0.0, std::hypot(x - p.x, y - p.y) - cone.tip_radius);
    return way.z0 + (way.z1 - way.z0) * t + away / cone.slope;
  };
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (height(a) < height(b) ? high : low) = height(a) < height(b) ? b : a;
  }
  return std::min({height(0), height(1), height(low)});
}

/// An end mill of 2 mm: its wall is upright.
constexpr Cone kMillForFloors{1, 1e-6};

double height_left(Vec2 p, const std::vector<TipWay>& ways, int tool, const Cone& cone) {
  double lowest = 0;
  for (const TipWay& way : ways) {
    if (way.tool != tool) continue;
    const double away = test_support::to_segment(p, {way.x0, way.y0}, {way.x1, way.y1});
    if (std::min(way.z0, way.z1) + std::max(0.0, away - cone.tip_radius) / cone.slope >= lowest) continue;
    lowest = std::min(lowest, lowest_over(p, way, cone));
  }
  return lowest;
}

class RandomCarvings : public ::testing::TestWithParam<int> {};

/// Every third outline has an island; two of three have a limit, below which nothing may be cut.
TEST_P(RandomCarvings, AreAsDeepAsTheDistanceToTheirOutlineAsks) {
  int places = 0, clean = 0;
  for (int seed = GetParam(); seed < outline_count(); seed += kShards) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> share(0, 1);
    const double size = 4 + 9 * share(random), limit = 0.4 + 1.6 * share(random);
    const double angle = seed % 2 == 0 ? 60 : 90;
    const Cone cone{0, std::tan(angle / 360 * kPi)};
    const std::string layer = seed % 3 == 0 ? "VCARVE" : "VCARVE_D" + std::to_string(limit);
    const Corners outer = star(random, 5 + seed % 8, 0.45 * size, size, true);
    const Corners island = star(random, 3 + seed % 4, 0.08 * size, 0.2 * size, false);
    const bool has_island = seed % 3 == 1;
    const PlanResult result =
        plan_part(drawn(outline(layer, outer) + (has_island ? outline(layer, island) : "")),
                  with({"vbit:" + std::to_string(static_cast<int>(angle)) + "deg:30", "endmill:2"}));
    clean += verdict_of(result.findings) == Verdict::kClean;
    const std::vector<TipWay> ways = test_support::ways_of(result.program, kSagitta);
    const std::vector<Side> around = test_support::sides_of(outer), inner = test_support::sides_of(island);
    for (int i = 0; i < 60; ++i) {
      const Vec2 p{size * (2 * share(random) - 1), size * (2 * share(random) - 1)};
      const double within = -test_support::signed_distance(p, around);
      const double beside = has_island ? test_support::signed_distance(p, inner) : HUGE_VAL;
      const double away = std::max(0.0, std::min(within, beside));
      const double floor = seed % 3 == 0 ? -HUGE_VAL : -limit;
      const double asked = std::max(floor, -away / cone.slope);
      const double left = std::min(height_left(p, ways, 1, cone), height_left(p, ways, 2, kMillForFloors));
      EXPECT_GE(left, asked - kAside / cone.slope - kLastDigit)
          << "seed " << seed << " at " << p.x << " " << p.y;
      // A floor that a cone has cleared has cusps, which the certificate's figures hold.
      if (away > 0 && asked > floor + 0.1) {
        EXPECT_LE(left, asked + 0.01) << "seed " << seed << " at " << p.x << " " << p.y;
      }
      places += away > 0;
    }
  }
  EXPECT_GT(places, 16 * outline_count() / kShards);
  EXPECT_GE(clean, outline_count() / kShards * 98 / 100);
}

INSTANTIATE_TEST_SUITE_P(Quarters, RandomCarvings, ::testing::Range(0, kShards));

class RandomChamfers : public ::testing::TestWithParam<int> {};

/// The edges of pockets. Where the mill does not reach the wall there is none to be broken.
TEST_P(RandomChamfers, NeitherGougeNorLeaveTheirEdge) {
  constexpr double kMill = 1.5;  // mm; its radius
  int places = 0, refused = 0;
  for (int seed = GetParam(); seed < outline_count(); seed += kShards) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> share(0, 1);
    const double depth = 0.2 + 0.6 * share(random), angle = seed % 2 == 0 ? 90 : 60;
    const Cone cone{seed % 3 == 0 ? 0.2 : 0, std::tan(angle / 360 * kPi)};
    const Corners corners = star(random, 3 + seed % 11, 9, 20, seed % 4 == 0);
    const std::string tool = "chamfer:" + std::to_string(static_cast<int>(angle)) + "deg:8" +
                             (cone.tip_radius > 0 ? ":tip=0.4" : "");
    const Part part =
        drawn(outline("POCKET_D4", corners) + outline("CHAMFER_D" + std::to_string(depth), corners));
    PlanOptions options = with({"endmill:3", tool});
    options.accept = {"out-of-reach"};
    options.strategy = "contour";
    PlanResult result;
    try {
      result = plan_part(part, options);
    } catch (const InputError&) {
      ++refused;
      continue;
    }
    const bool clean = verdict_of(result.findings) == Verdict::kClean;
    EXPECT_LE(result.findings.all.gouge_mm, 0.001) << seed;
    const std::vector<TipWay> ways = test_support::ways_of(result.program, kSagitta);
    const std::vector<Side> sides = test_support::sides_of(corners);
    std::vector<Sample> samples;
    for (const Side& side : sides) test_support::add_samples(side, 1.5, samples);
    for (const Sample& sample : samples) {
      const bool reached = -test_support::signed_distance(sample.at - sample.outwards * (kMill - 0.001),
                                                          sides) > kMill - 0.002;
      for (const double part_of_width : {0.0, 0.3, 0.6, 0.95, 1.1}) {
        const Vec2 p = sample.at + sample.outwards * (part_of_width * depth * cone.slope + 1e-6);
        const double away = test_support::signed_distance(p, sides);
        if (away <= 0) continue;  // the part is thinner than that
        const double asked = std::min(0.0, -depth + away / cone.slope), left = height_left(p, ways, 2, cone);
        EXPECT_GE(left, asked - kAside / cone.slope - kLastDigit)
            << "seed " << seed << " at " << p.x << " " << p.y;
        if (reached && clean) {
          EXPECT_LE(left, asked + 0.01) << "seed " << seed << " at " << p.x << " " << p.y;
        }
        ++places;
      }
    }
  }
  EXPECT_GT(places, 80 * outline_count() / kShards);
  EXPECT_LE(refused, std::max(1, outline_count() / kShards / 50));
}

INSTANTIATE_TEST_SUITE_P(Quarters, RandomChamfers, ::testing::Range(0, kShards));

}  // namespace
}  // namespace clearcut::pipeline
