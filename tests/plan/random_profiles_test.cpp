// Profiles of random outlines against a second method: the kerf by distances to the drawn outline, sampled here.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "pipeline/test_drawings.h"
#include "support/independent/drawn_outline.h"

namespace clearcut::pipeline {
namespace {

using namespace test_support;

constexpr int kOutlines = 1000, kShards = 4;
constexpr double kDepth = 4;
/// mm; what a program's digits, and the chords that stand for arcs here, may come to.
constexpr double kClose = 0.0015;

struct Case {
  const char* layer;
  double side;  ///< of the outline on which the cutter runs: 1 outside, -1 inside, 0 on it
  double diameter;
  std::vector<BulgeVertex> corners;  ///< counter-clockwise
};

Case random_case(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> share(0, 1);
  constexpr const char* kLayers[] = {"PROFILE_D4", "INSIDE_D4", "ON_D4"};
  constexpr double kSides[] = {1, -1, 0};
  Case c{kLayers[seed % 3], kSides[seed % 3], 1.0 + seed % 6, {}};
  const int count = 3 + seed % 11;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * (i + 0.6 * share(random)) / count, away = 16 + 24 * share(random);
    const double bulge = seed % 5 == 0 && share(random) < 0.4 ? 0.5 * share(random) - 0.2 : 0;
    c.corners.push_back({{away * std::cos(angle), away * std::sin(angle)}, bulge});
  }
  return c;
}

/// Where the tip is while it cuts, as short chords; `floor`: at full depth alone.
std::vector<std::pair<Vec2, Vec2>> chords_of(const Toolpath& toolpath, bool floor) {
  std::vector<std::pair<Vec2, Vec2>> chords;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      const double highest = std::max(move.z_from, move.z_to), lowest = std::min(move.z_from, move.z_to);
      if (is_rapid(move.kind) || lowest > -0.001 || (floor && highest > 0.001 - kDepth)) continue;
      const int count = move.path.is_arc() ? 2 + static_cast<int>(move.path.length() / 0.05) : 1;
      for (int i = 0; i < count; ++i)
        chords.emplace_back(move.path.at(static_cast<double>(i) / count),
                            move.path.at(static_cast<double>(i + 1) / count));
    }
  }
  return chords;
}

/// Nothing of the part is cut: the axis keeps a radius away from it, or to the line itself.
void expect_no_gouge(const Case& c, const std::vector<Side>& outline, const Toolpath& toolpath, int seed) {
  const double radius = c.diameter / 2;
  for (const auto& [from, to] : chords_of(toolpath, c.side == 0)) {
    const int count = 1 + static_cast<int>(norm(to - from) / 1.0);
    for (int i = 0; i <= count; ++i) {
      const double away = signed_distance(from + (to - from) * (static_cast<double>(i) / count), outline);
      if (c.side == 0)
        ASSERT_LE(std::abs(away), kClose) << "seed " << seed;
      else
        ASSERT_GE(c.side * away, radius - kClose) << "seed " << seed;
    }
  }
}

/// Nothing is left at the wall: wherever the cutter can touch the outline it does, at full depth.
int expect_cut(const Case& c, const std::vector<Side>& outline, const Toolpath& toolpath, int seed) {
  const double radius = c.side == 0 ? 0 : c.diameter / 2;
  const auto chords = chords_of(toolpath, true);
  int touched = 0;
  std::vector<Sample> samples;
  for (const Side& side : outline) add_samples(side, 1.0, samples);
  for (const Sample& sample : samples) {
    const Vec2 axis = sample.at + sample.outwards * (c.side * radius);
    if (c.side * signed_distance(axis, outline) < radius - 1e-6) continue;
    double nearest = HUGE_VAL;
    for (const auto& [from, to] : chords) nearest = std::min(nearest, to_segment(axis, from, to));
    EXPECT_LE(nearest, kClose) << "seed " << seed << " at " << sample.at.x << " " << sample.at.y;
    ++touched;
  }
  return touched;
}

class RandomProfiles : public ::testing::TestWithParam<int> {};

/// Cannot see: what leads and ways down take of the waste beside the kerf.
TEST_P(RandomProfiles, NeitherGougeNorLeaveTheirOutline) {
  int touched = 0;
  for (int seed = GetParam(); seed < kOutlines; seed += kShards) {
    const Case c = random_case(seed);
    PlanOptions options = with({"endmill:" + std::to_string(static_cast<int>(c.diameter))});
    options.accept = {"out-of-reach"};
    const PlanResult result = plan_part(drawn(pipeline::outline(c.layer, c.corners)), options);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << seed << "\n" << faults_of(result.findings);
    const std::vector<Side> outline = sides_of(c.corners);
    expect_no_gouge(c, outline, result.toolpath, seed);
    touched += expect_cut(c, outline, result.toolpath, seed);
  }
  EXPECT_GT(touched, 20000);
}

INSTANTIATE_TEST_SUITE_P(Quarters, RandomProfiles, ::testing::Range(0, kShards));

}  // namespace
}  // namespace clearcut::pipeline
