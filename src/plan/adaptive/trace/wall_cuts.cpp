#include "plan/adaptive/trace/wall_cuts.h"

#include <algorithm>

#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// Share of the tool radius: a cut begins at most this far along the wall before the material that it is for.
constexpr double kLongestApproach = 1.5;
/// Share of the tool radius: a start is given up if a cut from it gets less than this farther along the wall.
constexpr double kLeastAdvance = 0.03;
/// Approach points beside a wall: how far along the wall the last move onto it goes, divided by the distance
/// from the wall; tried in this order. An approach point is at most kFarthestApproachPoint tool radii away
/// along the wall.
constexpr double kApproachSlopes[] = {0, 2, 6, 16};
constexpr double kFarthestApproachPoint = 3;
/// Share of the tool radius: to a start this near the cutter goes straight from the end of the last cut, at
/// the cutting feed.
constexpr double kStraightOn = 0.6;
/// mm. Leads shorter than this are not made.
constexpr double kShortest = 1e-4;

}  // namespace

/// A clear link to an approach point and a short move from there to the first place of a cut.
struct WallCuts::Approach {
  LinkPath link;
  Path lead;  ///< cut at the cutting feed, because it goes through residuals
  WallPlace first;
};

WallCuts::WallCuts(RemainingStock& remaining, ClearingPath& path, Walls all, const Regions& area,
                   double limit, AlongWalls along)
    : walls(std::move(all)),
      tracer(remaining, walls, area, limit, along),
      remaining_(remaining),
      path_(path),
      radius_(remaining.tool_radius()),
      limit_(limit) {}

WallPlace WallCuts::nearest(const std::vector<WallPlace>& starts) const {
  const Vec2 at = path_.at();
  return *std::min_element(starts.begin(), starts.end(), [&](const WallPlace& a, const WallPlace& b) {
    return distance(walls.point(a), at) < distance(walls.point(b), at);
  });
}

bool WallCuts::cut_from(const WallPlace& start) {
  const Outcome outcome = cut_from_clear_wall(start);
  if (outcome == Outcome::kCut) return true;
  auto approach = approach_to(start);
  if (!approach) {
    if (outcome == Outcome::kNothingToCut) walls.give_up(start);
    return outcome == Outcome::kNothingToCut;
  }
  path_.note_start(approach->link.empty() ? walls.point(approach->first) : approach->link.back().to);
  const Vec2 on_wall = walls.point(approach->first);
  const bool may_begin_beside = approach->lead.empty() && !path_.empty();
  const auto can_begin = [&](Vec2 p) {
    if (p == on_wall || !may_begin_beside) return p == on_wall;
    auto link = path_.link_to(p, RemainingStock::kFree);
    if (link) approach->link = std::move(*link);
    return link.has_value();
  };
  const Path cut = tracer.cut_from(approach->first, start.s, can_begin);
  if (cut.empty()) {
    walls.give_up(start);
    return true;
  }
  Path whole = approach->lead;
  for (const Edge& edge : approach->lead) remaining_.cut(edge);
  const Vec2 approach_point = whole.empty() ? approach->link.back().to : whole.back().to;
  if (approach_point != cut.front().from) whole.push_back(Edge::line(approach_point, cut.front().from));
  whole.insert(whole.end(), cut.begin(), cut.end());
  add(start, whole, approach->link);
  return true;
}

/// A cut from a clear place on the wall or beside it; most cuts are of this kind. The link to the place is
/// searched for only when something can be cut from there.
WallCuts::Outcome WallCuts::cut_from_clear_wall(const WallPlace& start) {
  const auto first = clear_place_before(start);
  if (!first) return Outcome::kNoLink;
  const Vec2 on_wall = walls.point(*first);
  path_.note_start(on_wall);
  std::optional<LinkPath> link;
  bool asked = false;
  const auto can_begin = [&](Vec2 p) {
    if (path_.empty() && p != on_wall) return false;
    asked = true;
    link = path_.link_to(p, RemainingStock::kFree);
    return link.has_value();
  };
  const Path cut = tracer.cut_from(*first, start.s, can_begin);
  if (cut.empty()) return asked && !link ? Outcome::kNoLink : Outcome::kNothingToCut;
  add(start, cut, *link);
  return Outcome::kCut;
}

void WallCuts::add(const WallPlace& start, const Path& cut, const LinkPath& link) {
  path_.append(cut, link);
  walls.update(remaining_, box(cut).grown(2 * radius_));
  if (!walls.is_start(start)) return;
  const bool advances = walls.advances(start, tracer.first_departure(), kLeastAdvance * radius_);
  stuck_ = advances ? 0 : stuck_ + 1;
  // The starts next to it seldom get farther: more of them are given up each time.
  if (!advances) walls.give_up(start, (stuck_ + 1) / 2);
}

/// The last clear place on the wall before the start.
std::optional<WallPlace> WallCuts::clear_place_before(const WallPlace& start) const {
  // If the start is just before the end of an edge, the end itself, which saves a move.
  const WallPlace end{start.wall, walls.wall(start.wall).edge_end(start.s)};
  if (end.s < start.s + RadiusShares::kWallPitch * radius_ &&
      !remaining_.touches(walls.point(end), RemainingStock::kFree))
    return end;
  const double farthest = farthest_before(start);
  for (double back = 0; back < farthest; back += RadiusShares::kWallPitch * radius_ / 2) {
    const WallPlace first{start.wall, start.s - back};
    if (!remaining_.touches(walls.point(first), RemainingStock::kFree)) return first;
  }
  return std::nullopt;
}

double WallCuts::farthest_before(const WallPlace& start) const {
  return std::min(kLongestApproach * radius_, walls.from_stop(start));
}

/// An approach to the start over a place off the wall, for starts that no clear place on the wall leads to.
std::optional<WallCuts::Approach> WallCuts::approach_to(const WallPlace& start) const {
  const double farthest = farthest_before(start);
  if (const auto approach = straight_on_to(start)) return approach;
  for (const double back : {0.0, 0.2, 0.5, 1.0}) {
    if (back * radius_ > farthest) break;
    if (const auto approach = approach_from_aside({start.wall, start.s - back * radius_})) return approach;
  }
  return approach_through_residuals(start);
}

/// Straight from the end of the last cut, if that is near.
std::optional<WallCuts::Approach> WallCuts::straight_on_to(const WallPlace& place) const {
  if (path_.empty()) return std::nullopt;
  const Edge lead = Edge::line(path_.at(), walls.point(place));
  const double length = lead.length();
  if (length < kShortest || length > kStraightOn * radius_ ||
      !remaining_.legal().holds_line(lead.from, lead.to) || !is_within(lead))
    return std::nullopt;
  return Approach{{}, {lead}, place};
}

/// From an approach point beside the wall. Only the first clear one is tried: if no link leads to it, few
/// lead to the others.
std::optional<WallCuts::Approach> WallCuts::approach_from_aside(const WallPlace& place) const {
  const Vec2 p = walls.point(place), along = walls.wall(place.wall).heading(place.s);
  for (const double share : {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5}) {
    for (const double slope : kApproachSlopes) {
      const double aside = share * radius_;
      if (share * slope > kFarthestApproachPoint) continue;
      const Vec2 approach_point = p - along * (slope * aside) + left_of(along) * aside;
      if (!remaining_.legal().holds_line(approach_point, p) ||
          remaining_.touches(approach_point, RemainingStock::kFree) ||
          !is_within(Edge::line(approach_point, p)))
        continue;
      const auto link = path_.link_to(approach_point, RemainingStock::kFree);
      return link ? std::optional(Approach{*link, {}, place}) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// Along the wall from a place behind the start, through the residuals that clearing left there, within the
/// limit.
std::optional<WallCuts::Approach> WallCuts::approach_through_residuals(const WallPlace& start) const {
  if (path_.empty()) return std::nullopt;
  const double farthest = farthest_before(start);
  for (double back = 0; back < farthest; back += RadiusShares::kWallPitch * radius_) {
    const WallPlace first{start.wall, start.s - back};
    const double residual = walls.residual(first);
    if (remaining_.touches(walls.point(first), residual)) continue;
    const auto link = path_.link_to(walls.point(first), residual);
    if (!link) continue;
    Approach approach{{}, {}, first};
    Vec2 at = path_.at();
    for (const LinkMove& move : *link) {
      if (approach.lead.empty() && remaining_.is_free(move.edge(at), RemainingStock::kFree)) {
        approach.link.push_back(move);
      } else {
        approach.lead.push_back(move.edge(at));
      }
      at = move.to;
    }
    const auto within = [&](const Edge& edge) { return is_within(edge); };
    if (std::all_of(approach.lead.begin(), approach.lead.end(), within)) return approach;
  }
  return std::nullopt;
}

/// Whether a move keeps the engagement limit.
bool WallCuts::is_within(const Edge& edge) const {
  // Most moves that exceed it do so at their end, which is cheaper to check.
  return remaining_.engagement(edge.to, edge.tangent_at(1)) <= limit_ &&
         remaining_.length_within(edge, limit_) >= edge.length();
}

}  // namespace clearcut::plan::adaptive
