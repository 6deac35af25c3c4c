#include "plan/adaptive/finish/finish.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "geometry/contours/boolean.h"
#include "plan/adaptive/clearing/parameters.h"
#include "plan/adaptive/finish/trochoidal.h"
#include "plan/common/cover.h"

namespace clearcut::plan::adaptive {
namespace {

/// Share of the tool radius: distance between the marks along which finishing cuts run. What stands between
/// two marks is at most kFinePitch^2 / 8 of the radius thick.
constexpr double kFinePitch = 0.06;
/// mm. A cutter this near to a wall counts as being on it.
constexpr double kOnWall = 1e-4;
/// mm along a wall: stands for no place.
constexpr double kEndless = 1e300;
/// Radians that residuals on walls may add to the engagement that the turn of a corner alone causes.
constexpr double kResiduals = 0.4;
/// Share of the tool radius: distance between samples along the border of the target.
constexpr double kBorderPitch = 0.02;
/// mm. Material this near to what the cutter cannot reach is not a rest.
constexpr double kReach = 5e-4;
/// mm. The cutter touches the border of the target within its radius plus this.
constexpr double kTouched = 1e-6;
/// Share of the tool radius: a cut round a rest is at least this long.
constexpr double kLeastRound = 0.3;
/// Share of the tool radius: shorter finished stretches of wall are run over, because a link would cost more.
constexpr double kMergeGap = 1.0;
/// Share of the tool radius: how far arcs in place of kinks may deviate from them where no wall is near; and the same over the sine
/// of the limit, which is the radians that a cut beside them engages more (of 0.01 that EngagementTolerance::kExcess leaves).
constexpr double kMostEase = 0.0035;
constexpr double kEaseOfEngagement = 0.005;
/// Greatest number of times that all walls are cut by trochoidal steps.
constexpr int kMostRounds = 30;
/// Share of the tool radius: wall on both sides of a wall's end that is cut along if something still stands
/// there.
constexpr double kBeyondEnd = 0.2;

}  // namespace

AdaptiveFinish::AdaptiveFinish(RemainingStock& remaining, ClearingPath& path, const FinishTask& task)
    : remaining_(remaining),
      path_(path),
      legal_(task.legal),
      target_(task.target),
      radius_(remaining.tool_radius()),
      floor_radius_(task.floor_radius),
      limit_(task.limit),
      clock_(task.clock),
      cuts_(remaining, path, {task.legal, kFinePitch * radius_, ResidualLimits::kWall}, task.area, task.limit,
            {kMergeGap * radius_, RadiusShares::kWallPitch * radius_}) {}

bool AdaptiveFinish::run(bool open, int most_rests, StepPictures& pictures) {
  follow_walls();
  pictures.after("walls and corners");
  cut_walls();
  if (open) cut_wall_ends();
  pictures.after("trochoidal steps");
  path_.ease_joints({remaining_.legal(), ResidualLimits::kWall,
                     std::min(kMostEase, kEaseOfEngagement * base::sin(limit_)) * radius_},
                    clock_);
  const bool all = cut_rests(open, most_rests);
  pictures.after("rests");
  return all;
}

/// Cuts along the walls within the limit and round corners from one wall to the next; thick material is cut
/// off the wall as in clearing. Corners that could not be cut then are tried again at the end.
void AdaptiveFinish::follow_walls() {
  if (path_.empty()) return;
  cuts_.walls.update(remaining_, legal_.box());
  corners_ = all_corners_ = corners_of(cuts_.walls, limit_ - kResiduals);
  cuts_.walls.set_stops(places_of(all_corners_));
  for (const WallPlace& place : cuts_.walls.anywhere()) {
    if (!cuts_.cut_from(place) && trochoidal_step_from_aside(place))
      cuts_.walls.update(remaining_, legal_.box());
  }
  int misses = 0;
  for (auto starts = cuts_.walls.starts(); !starts.empty(); starts = cuts_.walls.starts()) {
    const WallPlace start = cuts_.nearest(starts);
    const Vec2 before = path_.at();
    if (cuts_.cut_from(start)) {
      misses = 0;
      if (path_.at() != before) go_on_round_corners();
    } else {
      // If no link leads to one start, few lead to the next ones: each time more of these are given up.
      cuts_.walls.give_up(start, ++misses);
    }
  }
  while (!corners_.empty()) {
    const auto corner = nearest_corner();
    if (const auto from = prepared_before(cuts_.walls, *corner, remaining_)) finish_corner(*corner, *from);
    corners_.erase(corner);
  }
}

/// From the end of a cut before a corner: cuts round the corner, along the next wall, and so on. If a cut
/// ends before a corner for another reason, it is continued once as if the corner were no stop.
void AdaptiveFinish::go_on_round_corners() {
  std::vector<WallPlace> passed;
  for (Vec2 before{1e300, 0}; path_.at() != before;) {
    before = path_.at();
    const auto corner = std::find_if(corners_.begin(), corners_.end(), [&](const Corner& c) {
      return ahead(c) < RadiusShares::kCornerReach * radius_;
    });
    if (corner == corners_.end()) return;
    const double from = ahead(*corner);
    if (const auto next = finish_corner(*corner, from)) {
      corners_.erase(corner);
      cuts_.cut_from(*next);
    } else {
      if (std::find(passed.begin(), passed.end(), corner->place) != passed.end()) return;
      passed.push_back(corner->place);
      cut_without_stop(*corner, from);
    }
  }
}

/// Cuts on along the wall before a corner, or off it, as if the corner were no stop.
void AdaptiveFinish::cut_without_stop(const Corner& corner, double from) {
  auto stops = places_of(all_corners_);
  std::erase(stops, corner.place);
  cuts_.walls.set_stops(std::move(stops));
  cuts_.cut_from({corner.place.wall, corner.place.s - from});
  cuts_.walls.set_stops(places_of(all_corners_));
}

/// mm along the corner's first wall from the cutter to the corner; infinite if the cutter is not on it.
double AdaptiveFinish::ahead(const Corner& corner) const {
  const Wall& wall = cuts_.walls.wall(corner.place.wall);
  if (distance(cuts_.walls.point(corner.place), path_.at()) > RadiusShares::kCornerReach * radius_)
    return kEndless;
  const auto hit = wall.nearest(path_.at());
  if (hit.distance > kOnWall) return kEndless;
  const double ahead = corner.place.s - hit.s;
  return ahead - std::floor(ahead / wall.length()) * wall.length();
}

std::vector<Corner>::iterator AdaptiveFinish::nearest_corner() {
  const auto far = [&](const Corner& corner) {
    return distance(cuts_.walls.point(corner.place), path_.at());
  };
  return std::min_element(corners_.begin(), corners_.end(),
                          [&](const Corner& a, const Corner& b) { return far(a) < far(b); });
}

/// Cuts a corner whose first wall is cut up to it. Returns where the cut ends; nothing if it was not made.
std::optional<WallPlace> AdaptiveFinish::finish_corner(const Corner& corner, double from) {
  const auto round = round_corner(cuts_.walls, corner, from, remaining_, limit_, ResidualLimits::kCorner);
  if (!round) return std::nullopt;
  const auto link = path_.link_to(round->path.front().from, ResidualLimits::kCornerLink);
  if (!link) return std::nullopt;
  path_.cut(round->path, *link);
  // The residual in a corner is thicker than those on walls: marks near it no longer count.
  const double pitch = RadiusShares::kWallPitch * radius_;
  cuts_.walls.leave_out({corner.place, round->residual_before + pitch, pitch});
  if (round->wedge > 0) cuts_.walls.leave_wedge(corner.place, round->wedge);
  cuts_.walls.update(remaining_, box(round->path).grown(2 * radius_));
  return WallPlace{corner.place.wall, round->end};
}

/// Cuts what walls still touch, the nearest stretch first: by trochoidal steps, else straight along.
void AdaptiveFinish::cut_walls() {
  int round = 0;
  for (auto stretches = unfinished(); !stretches.empty(); stretches = unfinished()) {
    bool any_cut = false;
    for (auto left = stretches; !left.empty() && round < kMostRounds;) {
      const auto next = nearest_stretch(left);
      any_cut = cut_in_trochoidal_steps(*next) || any_cut;
      left.erase(next);
    }
    ++round;
    if (!any_cut) cut_stretch(*nearest_stretch(stretches));
  }
}

/// Where a wall leaves the stock, a corner of the target may stand beyond the last mark: cuts past it.
void AdaptiveFinish::cut_wall_ends() {
  for (const Region& region : target_) {
    for (const Edge& edge : region.edges()) {
      if (!stands_at(edge.from)) continue;
      const Vec2 p = nearest_legal(edge.from);
      for (std::size_t w = 0; w < cuts_.walls.count(); ++w) {
        const auto hit = cuts_.walls.wall(w).nearest(p);
        if (hit.distance > ResidualLimits::kRest) continue;
        cut_stretch({w, hit.s - kBeyondEnd * radius_, hit.s + kBeyondEnd * radius_});
        break;
      }
    }
  }
}

/// Whether material within the cutter's reach stands at a corner of the target.
bool AdaptiveFinish::stands_at(Vec2 corner) const {
  for (int i = 0; i < 8; ++i) {
    const Vec2 p = corner + direction_of(kPi / 4 * i) * ResidualLimits::kRest;
    if (!remaining_.is_removed(p) && contains(target_, p) && distance(nearest_legal(p), p) < radius_)
      return true;
  }
  return false;
}

std::vector<WallStretch> AdaptiveFinish::unfinished() const {
  return unfinished_walls(cuts_.walls, RadiusShares::kWallPitch * radius_, kMergeGap * radius_, remaining_);
}

std::vector<WallStretch>::const_iterator AdaptiveFinish::nearest_stretch(
    const std::vector<WallStretch>& stretches) const {
  const Vec2 at = path_.at();
  const auto far = [&](const WallStretch& stretch) {
    return distance(cuts_.walls.point({stretch.wall, stretch.from}), at);
  };
  return std::min_element(stretches.begin(), stretches.end(),
                          [&](const WallStretch& a, const WallStretch& b) { return far(a) < far(b); });
}

/// Cuts the rests that the exact check of the cover finds. False if `most` were cut and some are left.
bool AdaptiveFinish::cut_rests(bool open, int most) {
  for (int left = most; left > 0;) {
    const auto holes = rests(open);
    const int before = left;
    std::vector<Vec2> cut;
    for (const Vec2 hole : holes) {
      // The stock knows cuts as they were before they were joined into others, which may leave a rest beside them.
      const bool is_cut =
          std::any_of(cut.begin(), cut.end(), [&](Vec2 p) { return distance(p, hole) < floor_radius_; });
      // Nor does it know of rounded corners, which leave a rest on the floor.
      const bool unknown = path_.is_beside_joined(hole) || floor_radius_ < radius_;
      const bool is_left = !is_cut && unknown && contains(target_, hole);
      if (remaining_.is_removed(hole) && !is_left) continue;
      if (left <= 0) return false;
      const Vec2 p = nearest_legal(hole);
      if (!cut_rest(p) && !enter_rest(p)) continue;
      cut.push_back(p);
      --left;
    }
    if (left == before) return true;
  }
  return rests(open).empty();
}

std::vector<Vec2> AdaptiveFinish::rests(bool open) const {
  const Cover cover(path_.moves(), floor_radius_ + ResidualLimits::kRest, Cover::SearchPlaces::kAtRims);
  auto holes = cover.holes([&](Vec2 p) { return is_reachable(p); });
  if (open) add_holes_at_border(cover, holes);
  return holes;
}

/// Holes that reach beyond the target may have no vertex inside it. They cross its border, sampled here.
void AdaptiveFinish::add_holes_at_border(const Cover& cover, std::vector<Vec2>& holes) const {
  for (const Region& region : target_) {
    for (const Edge& edge : region.edges()) {
      const double length = edge.length();
      bool in_hole = false;
      for (double s = 0; s < length;) {
        const Vec2 p = edge.at(s / length);
        // A point `inside` mm deep in the cover has no hole within that distance.
        const double inside = floor_radius_ + ResidualLimits::kRest - cover.distance_to(p);
        const bool hole = inside < 0 && is_within_reach(p, floor_radius_ + kTouched);
        if (hole && !in_hole) holes.push_back(p);
        in_hole = hole;
        s += inside < 0 ? kBorderPitch * radius_ : std::max(inside, ResidualLimits::kRest);
      }
    }
  }
}

bool AdaptiveFinish::is_reachable(Vec2 p) const {
  return is_within_reach(p, floor_radius_ - kReach);
}

bool AdaptiveFinish::is_within_reach(Vec2 p, double reach) const {
  return remaining_.legal().contains(p) || remaining_.legal().is_near_boundary(p, reach);
}

Vec2 AdaptiveFinish::nearest_legal(Vec2 p) const {
  if (legal_.contains(p)) return p;
  Nearest best{p, 1e300, 0};
  for (const Edge& edge : legal_.edges()) {
    if (distance(edge, p) < best.distance) best = clearcut::nearest(edge, p);
  }
  return best.point;
}

/// Makes a short cut that ends at p and begins at a clear place: straight within the limit, else round what
/// stands at p, else straight beyond the limit.
bool AdaptiveFinish::cut_rest(Vec2 p) {
  return from_approach_points_about(p,
                                    [&](Vec2 approach_point, const LinkPath& link) {
                                      return cut_straight(approach_point, p, limit_, link);
                                    }) ||
         from_approach_points_about(
             p,
             [&](Vec2 approach_point, const LinkPath& link) { return cut_round(approach_point, p, link); }) ||
         from_approach_points_about(p, [&](Vec2 approach_point, const LinkPath& link) {
           return cut_straight(approach_point, p, kPi, link);
         });
}

/// Tries `cut` from each clear place about p, the nearest first, until it succeeds.
template <typename Cut>
bool AdaptiveFinish::from_approach_points_about(Vec2 p, const Cut& cut) {
  for (const double reach : {0.3, 0.6, 1.0, 1.5}) {
    for (int i = 0; i < 8; ++i) {
      const Vec2 approach_point = p + direction_of(kPi / 4 * i) * (reach * radius_);
      if (!remaining_.legal().holds_line(approach_point, p) ||
          remaining_.touches(approach_point, RemainingStock::kFree))
        continue;
      const auto link = path_.link_to(approach_point, RemainingStock::kFree);
      if (link && cut(approach_point, *link)) return true;
    }
  }
  return false;
}

bool AdaptiveFinish::cut_straight(Vec2 approach_point, Vec2 p, double limit, const LinkPath& link) {
  const Edge line = Edge::line(approach_point, p);
  if (remaining_.length_within(line, limit) < line.length()) return false;
  path_.cut({line}, link);
  return true;
}

/// Cuts with the material about p on the right, within the limit.
bool AdaptiveFinish::cut_round(Vec2 approach_point, Vec2 p, const LinkPath& link) {
  path_.note_start(approach_point);
  for (const double turn : {0.25, 0.5, 0.0}) {
    const std::size_t before = remaining_.cuts();
    const Path cut = cut_on(approach_point, rotated(unit(p - approach_point), turn * kPi));
    if (length(cut) > kLeastRound * radius_) {
      path_.append(cut, link);
      return true;
    }
    remaining_.forget_beyond(before);
  }
  return false;
}

/// Enters from above, beside p, because no clear path leads there.
bool AdaptiveFinish::enter_rest(Vec2 p) {
  for (const double reach : {0.5, 0.2, 0.05, 0.01, 0.002}) {
    for (int i = 0; i < 8; ++i) {
      const Vec2 from = p + direction_of(kPi / 4 * i) * (reach * radius_);
      if (!remaining_.legal().holds_line(from, p)) continue;
      path_.finish_pass();
      path_.cut({Edge::line(from, p)}, {});
      return true;
    }
  }
  return false;
}

// The part of AdaptiveFinish for narrow ends: trochoidal steps along stretches of wall, and straight cuts where those
// lead no farther.

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
