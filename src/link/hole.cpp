#include "link/hole.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "link/moves.h"

namespace clearcut::link {
namespace {

/// Share of the radius of the tool's flat end. A helix with a wider centre circle would leave a post in the middle.
constexpr double kWidestBore = 0.95;
/// Share of the tool's radius. A narrower helix has too many turns; a plunge and a circle in each layer are
/// quicker.
constexpr double kNarrowestBore = 0.1;
/// mm above the material at which the helix begins.
constexpr double kBoreHeight = 0.2;

Section section_of(MoveList& list, const LinkOptions& options) {
  Section section;
  section.spindle_clockwise = options.spindle_clockwise;
  section.moves = list.take();
  return section;
}

/// Down to z, each stretch at its own feed: the beginning of the hole, its end, and the stretch between.
void feed_down(MoveList& list, double z, const HoleWork& hole, const LinkOptions& options,
               const HoleFeeds& feeds) {
  const double start_end = feeds.start_depth > 0 ? hole.z_top - feeds.start_depth : hole.z_top;
  const double end_begin = feeds.end_depth > 0 ? hole.z + feeds.end_depth : hole.z;
  const auto stretch = [&](double to, double share) {
    const double low = std::max(to, z);
    if (low < list.z()) list.vertical(low, MoveKind::kPlunge, options.plunge_feed * share);
  };
  if (feeds.start_depth > 0) stretch(start_end, feeds.start_share);
  if (feeds.end_depth > 0) stretch(end_begin, 1);
  stretch(z, feeds.end_depth > 0 ? feeds.end_share : 1);
}

}  // namespace

Section drill_hole(const HoleWork& hole, double peck, const LinkOptions& options, const HoleFeeds& feeds) {
  const double clear = hole.z_top + options.above_material;
  MoveList list(hole.center, options.safe_z);
  list.vertical(clear, MoveKind::kRapid, {});
  const int pecks = std::max(1, static_cast<int>(std::ceil((hole.z_top - hole.z) / peck - 1e-9)));
  const double step = pecks == 1 ? clear - hole.z : (hole.z_top - hole.z) / pecks;
  // Pecks are counted from the height above the material, as in drilling cycles.
  for (double depth = clear - step; depth > hole.z + step / 1000; depth -= step) {
    feed_down(list, depth, hole, options, feeds);
    list.vertical(clear, MoveKind::kRapid, {});
    list.vertical(std::min(clear, depth + kPeckGap), MoveKind::kRapid, {});
  }
  feed_down(list, hole.z, hole, options, feeds);
  if (feeds.retract_share)
    list.vertical(clear, MoveKind::kRetract, options.plunge_feed * *feeds.retract_share);
  list.vertical(options.safe_z, MoveKind::kRapid, {});
  return section_of(list, options);
}

Section chip_hole(const HoleWork& hole, double peck, const LinkOptions& options) {
  const double clear = hole.z_top + options.above_material;
  MoveList list(hole.center, options.safe_z);
  list.vertical(clear, MoveKind::kRapid, {});
  const int pecks = std::max(1, static_cast<int>(std::ceil((hole.z_top - hole.z) / peck - 1e-9)));
  const double step = pecks == 1 ? clear - hole.z : (hole.z_top - hole.z) / pecks;
  for (double depth = clear - step; depth > hole.z + step / 1000; depth -= step) {
    list.vertical(depth, MoveKind::kPlunge, options.plunge_feed);
    list.vertical(std::min(clear, depth + kPeckGap), MoveKind::kRapid, {});
  }
  list.vertical(hole.z, MoveKind::kPlunge, options.plunge_feed);
  list.vertical(options.safe_z, MoveKind::kRapid, {});
  return section_of(list, options);
}

Section feed_out_hole(const HoleWork& hole, const LinkOptions& options) {
  const double clear = hole.z_top + options.above_material;
  MoveList list(hole.center, options.safe_z);
  list.vertical(clear, MoveKind::kRapid, {});
  list.vertical(hole.z, MoveKind::kPlunge, options.plunge_feed);
  list.vertical(clear, MoveKind::kRetract, options.plunge_feed);
  list.vertical(options.safe_z, MoveKind::kRapid, {});
  return section_of(list, options);
}

bool can_bore(const HoleWork& hole, double tool_radius, double flat) {
  const double radius = hole.radius - tool_radius;
  return radius >= kNarrowestBore * tool_radius && radius <= kWidestBore * flat;
}

namespace {

/// Feed of the centre with which the teeth at the wall advance at `feed`: the wall is longer than the centre's path.
MmPerMin centre_feed(MmPerMin feed, double centre_radius, double wall_radius) {
  return feed * (centre_radius / wall_radius);
}

}  // namespace

Section bore_hole(const HoleWork& hole, double stepdown, const LinkOptions& options) {
  const double radius = hole.radius - options.tool_radius;
  const double top = hole.z_top + kBoreHeight;
  const double drop = std::min(stepdown, 2 * kPi * radius * base::tan(options.entry_angle.radians()));
  const bool climbs = (options.direction == CutDirection::kClimb) == options.spindle_clockwise;
  const Turn turn = climbs ? Turn::kCounterClockwise : Turn::kClockwise;
  const int turns = std::max(1, static_cast<int>(std::ceil((top - hole.z) / drop - 1e-9)));
  MoveList list(hole.center + Vec2{radius, 0}, options.safe_z);
  list.vertical(hole.z_top + options.above_material, MoveKind::kRapid, {});
  list.vertical(top, MoveKind::kPlunge, options.plunge_feed);
  const MmPerMin level = centre_feed(options.feed, radius, hole.radius);
  const MmPerMin down = std::min(options.ramp_feed, level);
  for (int i = 1; i <= turns; ++i) {
    const double z = i == turns ? hole.z : top - (top - hole.z) * i / turns;
    const MmPerMin feed = sinking_feed(down, options.plunge_feed, 2 * kPi * radius, list.z() - z);
    list.circle(hole.center, turn, z, MoveKind::kRamp, feed);
  }
  list.circle(hole.center, turn, hole.z, MoveKind::kCut, level);
  list.line(hole.center, MoveKind::kLeadOut, options.feed);
  list.vertical(options.safe_z, MoveKind::kRapid, {});
  return section_of(list, options);
}

}  // namespace clearcut::link
