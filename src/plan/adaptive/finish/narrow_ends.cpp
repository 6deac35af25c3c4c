// The part of AdaptiveFinish for narrow ends: trochoidal steps along stretches of wall, and straight cuts where those
// lead no farther.
#include <algorithm>

#include "base/elementary.h"
#include "plan/adaptive/clearing/parameters.h"
#include "plan/adaptive/finish/finish.h"
#include "plan/adaptive/finish/trochoidal.h"

namespace clearcut::plan::adaptive {
namespace {

/// Shares of the tool radius: distances from a wall at which approach points of trochoidal steps are tried.
constexpr double kApproachPoints[] = {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.4};
/// Share of the tool radius: distance between samples along a wall that is cut by trochoidal steps.
constexpr double kTrochoidalPitch = 0.02;
/// mm. A trochoidal step that shortens the unfinished stretch of wall by less counts as having cut nothing.
constexpr double kLeastTrochoidalStep = 1e-3;
/// Share of the tool radius: distance between the places of a stretch from beside which trochoidal steps are
/// tried; greatest number of such places.
constexpr double kAsidePitch = 0.1;
constexpr int kMostAside = 400;
/// Greatest number of trochoidal steps for one stretch of wall; what they leave is cut straight.
constexpr int kMostTrochoidalSteps = 300;
/// Share of the tool radius: a trochoidal step that gets less far along the wall is small. Where a corridor is hardly
/// wider than the cutter all are, and each costs more planning than the one before, since the cuts lie closer. In a
/// pointed corner only the last ones are.
constexpr double kSmallStep = 0.03;
/// Greatest number of small steps one after the other; then the stretch is cut straight.
constexpr int kMostSmallSteps = 40;

}  // namespace

/// Cuts a stretch by trochoidal steps within the limit, each from a clear place of the wall. True if any cut.
bool AdaptiveFinish::cut_in_trochoidal_steps(const WallStretch& stretch) {
  const Walls& walls = cuts_.walls;
  TrochoidalSteps steps(remaining_, walls.wall(stretch.wall), limit_);
  const auto touching = [&](const WallStretch& within) {
    return unfinished_part(walls, within, kTrochoidalPitch * radius_, ResidualLimits::kTrochoidal,
                           remaining_);
  };
  auto left = touching(stretch);
  const bool began = left.has_value();
  bool idle = false;
  int trochoidal_steps = 0, small_steps = 0;
  while (left && !idle && trochoidal_steps < kMostTrochoidalSteps) {
    const auto link = link_to_trochoidal_step(*left);
    const Path trochoidal_step = link ? steps.trochoidal_step(left->from, left->to) : Path{};
    if (trochoidal_step.empty()) break;
    path_.cut(trochoidal_step, *link);
    ++trochoidal_steps;
    const auto before = *left;
    left = touching(before);
    if (!left) break;
    const double advance = before.to - before.from - (left->to - left->from);
    idle = advance < kLeastTrochoidalStep;
    small_steps = advance < kSmallStep * radius_ ? small_steps + 1 : 0;
    if (small_steps >= kMostSmallSteps) {
      cut_stretch(*left);
      return true;
    }
  }
  if (trochoidal_steps > (idle ? 1 : 0) || !began) return began;
  return trochoidal_step_from_aside(stretch);
}

/// One trochoidal step from beside some place of the stretch, the middle first. True if it cut anything.
bool AdaptiveFinish::trochoidal_step_from_aside(const WallStretch& stretch) {
  if (trochoidal_step_from_aside(WallPlace{stretch.wall, (stretch.from + stretch.to) / 2})) return true;
  const double whole = stretch.to - stretch.from;
  const int places = std::min(kMostAside, static_cast<int>(whole / (kAsidePitch * radius_)));
  for (int i = 0; i < places; ++i) {
    if (trochoidal_step_from_aside(WallPlace{stretch.wall, stretch.from + whole * (i + 0.5) / places}))
      return true;
  }
  return false;
}

/// One trochoidal step from a clear place beside the wall at `place`. True if it cut anything.
bool AdaptiveFinish::trochoidal_step_from_aside(const WallPlace& place) {
  const Wall& wall = cuts_.walls.wall(place.wall);
  const Vec2 p = wall.at(place.s), inwards = left_of(wall.heading(place.s));
  for (const double share : kApproachPoints) {
    const Vec2 approach_point = p + inwards * (share * radius_);
    if (!remaining_.legal().holds_line(p, approach_point) ||
        remaining_.touches(approach_point, RemainingStock::kFree))
      continue;
    const Path trochoidal_step =
        TrochoidalSteps(remaining_, wall, limit_).trochoidal_step_from_aside(approach_point, place.s);
    if (trochoidal_step.empty()) continue;
    auto link = path_.empty() ? std::nullopt : path_.link_to(approach_point, RemainingStock::kFree);
    if (!link) link = path_.retract_if_clear(approach_point);
    if (!link) continue;
    path_.cut(trochoidal_step, *link);
    return true;
  }
  return false;
}

std::optional<LinkPath> AdaptiveFinish::link_to_trochoidal_step(const WallStretch& stretch) {
  const Vec2 p = cuts_.walls.point({stretch.wall, stretch.from});
  if (!path_.empty()) {
    // A step begins near the end of the one before: straight over the thin residual there is shorter than
    // round it.
    if (remaining_.is_free(path_.at(), p, ResidualLimits::kCornerLink)) return LinkPath{{p}};
    if (auto link = path_.link_to(p, RemainingStock::kFree)) return link;
    if (auto link = path_.link_to(p, ResidualLimits::kCornerLink)) return link;
  }
  return path_.retract_if_clear(p);
}

void AdaptiveFinish::cut_stretch(const WallStretch& place) {
  const Wall& wall = cuts_.walls.wall(place.wall);
  const bool round = place.to - place.from >= wall.length() * (1 - 1e-9);
  Path stretch = round ? wall.loop() : wall.part(place.from, place.to);
  const Vec2 p = stretch.front().from, inwards = left_of(stretch.front().tangent_at(0));
  for (const double share : {0.0, 0.02, 0.05, 0.1, 0.2, 0.4}) {
    const Vec2 approach_point = p + inwards * (share * radius_);
    if (!remaining_.legal().holds_line(approach_point, p) ||
        remaining_.touches(approach_point, RemainingStock::kFree))
      continue;
    const auto link = path_.link_to(approach_point, RemainingStock::kFree);
    if (!link) continue;
    if (share > 0) stretch.insert(stretch.begin(), Edge::line(approach_point, p));
    return path_.cut(stretch, *link);
  }
  if (const auto link = path_.link_to(p, radius_ * (1 - base::cos(limit_))); link && !path_.empty()) {
    // Through residuals, and therefore at the cutting feed.
    Path lead;
    for (const LinkMove& move : *link) lead.push_back(move.edge(lead.empty() ? path_.at() : lead.back().to));
    stretch.insert(stretch.begin(), lead.begin(), lead.end());
  } else if (!path_.empty()) {
    path_.finish_pass();
  }
  path_.cut(stretch, {});
}

}  // namespace clearcut::plan::adaptive
