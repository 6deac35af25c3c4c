#include "kinematics/published_time.h"

#include <cmath>

#include "base/elementary.h"
#include "base/tolerances.h"

namespace clearcut::kinematics {
namespace {

/// Degrees. Smaller changes of direction come from rounding.
constexpr double kStraightOn = 0.1;

bool is_segment(const Move& move) {
  return !is_rapid(move.kind) && !move.is_vertical() && move.z_from == move.z_to;
}

bool turns_between(const Move& before, const Move& after) {
  if (distance(before.path.to, after.path.from) > kRoundingMm) return false;
  const Vec2 in = before.path.tangent_at(1), out = after.path.tangent_at(0);
  return std::abs(base::atan2(cross(in, out), dot(in, out))) * 180 / kPi > kStraightOn;
}

void add(PublishedTime& time, const Move& move) {
  const double length = move.path.length(), feed = move.feed.mm_per_min();
  time.length_mm += length;
  if (feed <= 0) return;
  time.cutting_s += 60 * length / feed;
  if (time.slowest.mm_per_min() <= 0 || feed < time.slowest.mm_per_min()) time.slowest = move.feed;
  if (feed > time.fastest.mm_per_min()) time.fastest = move.feed;
}

}  // namespace

double published_time(double cutting_s, int discontinuities) {
  return cutting_s + 2 * (1 + discontinuities) * kPublishedStop;
}

double PublishedTime::seconds_at(MmPerMin feed) const {
  return published_time(60 * length_mm / feed.mm_per_min(), discontinuities);
}

PublishedTime published_time(const Toolpath& toolpath) {
  PublishedTime time;
  for (const Section& section : toolpath.sections) {
    const Move* before = nullptr;
    for (const Move& move : section.moves) {
      const bool counts = is_segment(move);
      if (counts) add(time, move);
      if (counts && before != nullptr && turns_between(*before, move)) ++time.discontinuities;
      before = counts ? &move : nullptr;
    }
  }
  return time;
}

}  // namespace clearcut::kinematics
