// A thousand random threads in holes and about bosses against the formula of the helix and the basic profile.
#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "link/tracks.h"
#include "model/hole.h"

namespace clearcut::link {
namespace {

const char* const kNames[] = {"M6",    "M8",  "M10x1",  "M12",    "M16x1.5", "M20",    "M24x2",
                              "M30x2", "M48", "UNC1-4", "UNC1-2", "UNF3-8",  "UNF#10", "UNC1"};

struct Sample {
  Thread thread;
  ThreadWork work;
  LinkOptions options;
};

Sample random_thread(Random& random) {
  Sample out;
  const std::string name = kNames[random.below(std::size(kNames))];
  out.thread = *thread_named(name + (random.below(2) ? "LH" : ""));
  ThreadWork& work = out.work;
  work.center = {random.between(-50, 50), random.between(-50, 50)};
  work.pitch = out.thread.pitch;
  work.left_hand = out.thread.left_hand;
  work.z_top = random.between(-5, 5);
  work.full_z = work.z_top - random.between(1, 12) * work.pitch;
  work.external = random.below(2) == 1;
  work.radius = (work.external ? root_diameter(out.thread) : out.thread.diameter) / 2;
  work.crest = out.thread.diameter / 2;
  work.aside = approach_beside(out.thread);
  work.rows = random.below(2) * 4 * work.pitch;
  LinkOptions& options = out.options;
  options.tool_radius = minor_diameter(out.thread) / 2 * random.between(0.4, 0.85);
  options.direction = random.below(2) ? CutDirection::kClimb : CutDirection::kConventional;
  options.spindle_clockwise = random.below(2) == 1;
  options.safe_z = work.z_top + 10;
  options.feed = MmPerMin::of(300);
  options.plunge_feed = MmPerMin::of(100);
  return out;
}

/// What the teeth do at dense places of a path.
struct Cut {
  double beside_turns = 0;  ///< mm off the helix while they are at full depth
  double beside_leads = 0;  ///< mm off the helix on the ways in and out, where they are in the material
  double farthest = 0;      ///< mm beyond the radius that they shall reach
  std::vector<std::pair<double, double>> heights;  ///< of whole turns
};

Cut cut_of(const Sample& sample, const std::vector<Move>& moves) {
  const ThreadWork& work = sample.work;
  const double crest = (work.external ? sample.thread.diameter : minor_diameter(sample.thread)) / 2;
  Cut cut;
  std::optional<double> first;
  const auto turns_at = [&](Vec2 p, double z) {
    const Vec2 from = p - work.center;
    return z / work.pitch - (work.left_hand ? -1 : 1) * std::atan2(from.y, from.x) / (2 * kPi);
  };
  for (const Move& move : moves) {
    if (move.kind == MoveKind::kCut && !first) first = turns_at(move.path.from, move.z_from);
  }
  for (const Move& move : moves) {
    if (is_rapid(move.kind) || move.is_vertical()) continue;
    for (int i = 0; i <= 100; ++i) {
      const Vec2 p = move.path.at(i / 100.0);
      const double z = move.z_from + (move.z_to - move.z_from) * i / 100;
      const double away = distance(p, work.center);
      const double reach =
          work.external ? away - sample.options.tool_radius : away + sample.options.tool_radius;
      cut.farthest = std::max(cut.farthest, work.external ? work.radius - reach : reach - work.radius);
      if (work.external ? reach > crest : reach < crest) continue;
      const double off = turns_at(p, z) - *first;
      double& worst = move.kind == MoveKind::kCut ? cut.beside_turns : cut.beside_leads;
      worst = std::max(worst, std::abs(off - std::round(off)) * work.pitch);
    }
    const double more_rows = work.rows > 0 ? work.rows - work.pitch : 0;
    if (move.kind == MoveKind::kCut)
      cut.heights.push_back({std::min(move.z_from, move.z_to), std::max(move.z_from, move.z_to) + more_rows});
  }
  return cut;
}

TEST(ThreadPaths, AThousandLieOnTheirHelixAndReachTheirProfile) {
  Random random(68);
  for (int i = 0; i < 1000; ++i) {
    const Sample sample = random_thread(random);
    SCOPED_TRACE(sample.thread.name + (sample.work.external ? " external" : " internal"));
    const Section section = mill_thread(sample.work, sample.options);
    Cut cut = cut_of(sample, section.moves);
    EXPECT_LT(cut.beside_turns, 1e-9);
    EXPECT_LT(cut.beside_leads, 0.01 * sample.work.pitch + 0.006);
    EXPECT_LT(cut.farthest, 1e-9);
    // From a pitch below its full depth up to its top, without a gap.
    std::sort(cut.heights.begin(), cut.heights.end());
    double low = sample.work.full_z;
    ASSERT_LE(cut.heights.front().first, low + 1e-9);
    for (const auto& [from, to] : cut.heights)
      if (from <= low + 1e-9) low = std::max(low, to);
    EXPECT_GE(low, sample.work.z_top - 1e-9);
  }
}

/// The ways down and up again stay clear of the crests.
TEST(ThreadPaths, GoDownBesideTheThread) {
  Random random(69);
  for (int i = 0; i < 200; ++i) {
    const Sample sample = random_thread(random);
    for (const Move& move : mill_thread(sample.work, sample.options).moves) {
      if (!move.is_vertical()) continue;
      const double away = distance(move.path.from, sample.work.center);
      if (sample.work.external)
        EXPECT_GT(away - sample.options.tool_radius, sample.thread.diameter / 2 + 0.9);
      else
        EXPECT_LT(away + sample.options.tool_radius, minor_diameter(sample.thread) / 2);
    }
  }
}

}  // namespace
}  // namespace clearcut::link
