// Profiles of random outlines against a second method: the kerf by distances to the drawn outline, sampled here.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

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

Vec2 turned_left(Vec2 v) {
  return {-v.y, v.x};
}

/// One side of an outline: a line, or an arc by the definition of the bulge.
struct Side {
  Vec2 from, to;
  double sweep = 0;  ///< 4 atan(bulge); 0: a line
  Vec2 center{};
  double radius = 0;
};

Side side_of(Vec2 from, Vec2 to, double bulge) {
  Side side{from, to};
  if (bulge == 0) return side;
  const Vec2 chord = to - from;
  const double size = std::hypot(chord.x, chord.y), sweep = 4 * std::atan(bulge);
  const double signed_radius = size / (2 * std::sin(sweep / 2));
  side.sweep = sweep;
  side.radius = std::abs(signed_radius);
  side.center = from + chord * 0.5 + turned_left(chord) * (signed_radius * std::cos(sweep / 2) / size);
  return side;
}

std::vector<Side> sides_of(const Case& c) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < c.corners.size(); ++i)
    sides.push_back(
        side_of(c.corners[i].point, c.corners[(i + 1) % c.corners.size()].point, c.corners[i].bulge));
  return sides;
}

/// Points along a side, each with the direction away from the part.
struct Sample {
  Vec2 at, outwards;
};

void add_samples(const Side& side, double step, std::vector<Sample>& samples) {
  const Vec2 chord = side.to - side.from;
  const double size = std::hypot(chord.x, chord.y);
  const int count =
      1 + static_cast<int>((side.sweep == 0 ? size : std::abs(side.radius * side.sweep)) / step);
  const double start = std::atan2(side.from.y - side.center.y, side.from.x - side.center.x);
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    if (side.sweep == 0) {
      samples.push_back({side.from + chord * share, turned_left(chord) * (-1 / size)});
      continue;
    }
    const double angle = start + side.sweep * share;
    const Vec2 away{std::cos(angle), std::sin(angle)};
    samples.push_back({side.center + away * side.radius, away * (side.sweep > 0 ? 1.0 : -1.0)});
  }
}

double to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a, from = p - a;
  const double squared = along.x * along.x + along.y * along.y;
  const double t = squared > 0 ? std::clamp((from.x * along.x + from.y * along.y) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(from.x - t * along.x, from.y - t * along.y);
}

/// On which side of the chord p lies: > 0 to the left.
double left_of_chord(const Side& side, Vec2 p) {
  const Vec2 along = side.to - side.from, from = p - side.from;
  return along.x * from.y - along.y * from.x;
}

/// Whether p lies on the arc's own side of its chord: arcs here are less than half a circle, so that seen from the center, too.
bool is_beyond_chord(const Side& side, Vec2 p) {
  return left_of_chord(side, p) * side.sweep < 0;
}

double to_side(Vec2 p, const Side& side) {
  if (side.sweep == 0) return to_segment(p, side.from, side.to);
  const Vec2 from_center = p - side.center;
  const double away = std::hypot(from_center.x, from_center.y);
  const Vec2 nearest = side.center + from_center * (side.radius / std::max(away, 1e-12));
  if (is_beyond_chord(side, nearest)) return std::abs(away - side.radius);
  return std::min(std::hypot(p.x - side.from.x, p.y - side.from.y),
                  std::hypot(p.x - side.to.x, p.y - side.to.y));
}

/// Distance to the outline, negative within it.
double signed_distance(Vec2 p, const std::vector<Side>& outline) {
  double nearest = HUGE_VAL;
  bool within = false;
  for (const Side& side : outline) {
    const Vec2 a = side.from, b = side.to;
    nearest = std::min(nearest, to_side(p, side));
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) within = !within;
    const bool in_bow = side.sweep != 0 && is_beyond_chord(side, p) &&
                        std::hypot(p.x - side.center.x, p.y - side.center.y) < side.radius;
    if (in_bow) within = !within;
  }
  return within ? -nearest : nearest;
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
    resolve::PlanOptions options = with({"endmill:" + std::to_string(static_cast<int>(c.diameter))});
    options.accept = {"out-of-reach"};
    const PlanResult result = plan_part(drawn(pipeline::outline(c.layer, c.corners)), options);
    EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << seed << "\n" << faults_of(result.findings);
    const std::vector<Side> outline = sides_of(c);
    expect_no_gouge(c, outline, result.toolpath, seed);
    touched += expect_cut(c, outline, result.toolpath, seed);
  }
  EXPECT_GT(touched, 20000);
}

INSTANTIATE_TEST_SUITE_P(Quarters, RandomProfiles, ::testing::Range(0, kShards));

}  // namespace
}  // namespace clearcut::pipeline
