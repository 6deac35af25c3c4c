#include "plan/adaptive/finish/finish.h"

#include <algorithm>
#include <cmath>

#include "geometry/boolean.h"
#include "plan/adaptive/corners/trochoidal.h"
#include "plan/common/cover.h"

namespace clearcut::plan::adaptive {
namespace {

/// Tool radii between the marks on walls that are looked at again; and between marks that finishing cuts follow, where
/// nothing may stay: what stands between two is no thicker than 1/8 of its square.
constexpr double kMarkPitch = 0.1;
constexpr double kFinePitch = 0.06;
/// Tool radii. A cut that ends as near before a corner goes on round it; mm from the wall.
constexpr double kCornerReach = 1.2;
constexpr double kOnWall = 1e-4;
constexpr double kEndless = 1e300;
/// mm. Material thinner than this may stay on walls, and in corners.
constexpr double kWallFilm = 1.5e-3;
constexpr double kCornerFilm = 5.5e-3;
/// The same where bites end: less than what the ways to the next ones may graze.
constexpr double kPeelFilm = 2e-3;
/// Radians that films on the walls may add to what a corner shows.
constexpr double kFilms = 0.4;
/// mm. What ways to corners may graze: walls there are cut to within kWallFilm.
constexpr double kCornerFree = 3e-3;
/// mm. Rests thinner than this stay.
constexpr double kRest = 0.0065;
/// Tool radii between looks at the border of the target.
constexpr double kBorderPitch = 0.02;
/// mm. Nearer to what the cutter cannot reach nothing is a rest.
constexpr double kReach = 5e-4;
/// mm. So far beyond its reach the cutter still touches the border of the target.
constexpr double kTouched = 1e-6;
/// Tool radii of a cut round a rest, at least.
constexpr double kLeastRound = 0.3;
/// Tool radii. Shorter stretches of wall that are finished already are run over at the cutting feed.
constexpr double kMergeGap = 1.0;
/// Tool radii from a wall from where bites towards it are tried.
constexpr double kGates[] = {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.4};
/// Tool radii between looks at a wall that is cut by bites.
constexpr double kPeelPitch = 0.02;
/// mm. Bites that take less of the wall are idle.
constexpr double kLeastBite = 1e-3;
/// Tool radii between places of a stretch from beside which bites are tried, and most of them.
constexpr double kAsidePitch = 0.1;
constexpr int kMostAside = 400;
constexpr int kMostBites = 300;
/// Times that all walls are gone over with bites.
constexpr int kMostRounds = 30;
/// Tool radii of wall on both sides of its end that are run along where something still stands there.
constexpr double kBeyondEnd = 0.2;

}  // namespace

AdaptiveFinish::AdaptiveFinish(Ground& ground, ClearingPath& path, const Region& legal, const Regions& area,
                               const Regions& target, double limit)
    : ground_(ground),
      path_(path),
      legal_(legal),
      target_(target),
      radius_(ground.tool_radius()),
      limit_(limit),
      cuts_(ground, path, {legal, kFinePitch * radius_, kWallFilm}, area, limit,
            {kMergeGap * radius_, kMarkPitch * radius_}) {}

bool AdaptiveFinish::run(bool open, int most_rests) {
  follow_walls();
  cut_walls();
  if (open) cut_wall_ends();
  return cut_rests(open, most_rests);
}

/// Along the walls within the limit, round corners from one to the next; where they bear more, it is cut like any front.
/// Corners that could not be cut then are tried again.
void AdaptiveFinish::follow_walls() {
  if (path_.empty()) return;
  cuts_.walls.update(ground_, legal_.box());
  corners_ = all_corners_ = corners_of(cuts_.walls, limit_ - kFilms);
  cuts_.walls.set_stops(places_of(all_corners_));
  for (const WallPlace& place : cuts_.walls.anywhere()) {
    if (!cuts_.cut_from(place) && bite_from_aside(place)) cuts_.walls.update(ground_, legal_.box());
  }
  int misses = 0;
  for (auto starts = cuts_.walls.starts(); !starts.empty(); starts = cuts_.walls.starts()) {
    const WallPlace start = cuts_.nearest(starts);
    const Vec2 before = path_.at();
    if (cuts_.cut_from(start)) {
      misses = 0;
      if (path_.at() != before) go_on_round_corners();
    } else {
      // Where no way leads to one place it seldom leads to the next ones.
      cuts_.walls.give_up(start, ++misses);
    }
  }
  while (!corners_.empty()) {
    const auto corner = nearest_corner();
    if (const auto from = prepared_before(cuts_.walls, *corner, ground_)) finish_corner(*corner, *from);
    corners_.erase(corner);
  }
}

/// From the end of a cut before a corner round it and along the next wall, and so on. Where it is not the corner that
/// stopped the cut it goes on as if there were none, once.
void AdaptiveFinish::go_on_round_corners() {
  std::vector<WallPlace> passed;
  for (Vec2 before{1e300, 0}; path_.at() != before;) {
    before = path_.at();
    const auto corner = std::find_if(corners_.begin(), corners_.end(),
                                     [&](const Corner& c) { return ahead(c) < kCornerReach * radius_; });
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

/// On along the wall before a corner, or off it.
void AdaptiveFinish::cut_without_stop(const Corner& corner, double from) {
  auto stops = places_of(all_corners_);
  std::erase(stops, corner.place);
  cuts_.walls.set_stops(std::move(stops));
  cuts_.cut_from({corner.place.wall, corner.place.s - from});
  cuts_.walls.set_stops(places_of(all_corners_));
}

/// mm. How far along its first wall a corner is from the cutter; infinite where that is not on it.
double AdaptiveFinish::ahead(const Corner& corner) const {
  const Wall& wall = cuts_.walls.wall(corner.place.wall);
  if (distance(cuts_.walls.point(corner.place), path_.at()) > kCornerReach * radius_) return kEndless;
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

/// Cuts a corner up to which its first wall is cut. Where the cut ends.
std::optional<WallPlace> AdaptiveFinish::finish_corner(const Corner& corner, double from) {
  const auto round = round_corner(cuts_.walls, corner, from, ground_, limit_, kCornerFilm);
  if (!round) return std::nullopt;
  const auto way = path_.way_to(round->path.front().from, kCornerFree);
  if (!way) return std::nullopt;
  path_.cut(round->path, *way);
  // Its film is thicker than those of walls.
  const double pitch = kMarkPitch * radius_;
  cuts_.walls.leave_out({corner.place, round->film_before + pitch, pitch});
  if (round->wedge > 0) cuts_.walls.leave_wedge(corner.place, round->wedge);
  cuts_.walls.update(ground_, box(round->path).grown(2 * radius_));
  return WallPlace{corner.place.wall, round->end};
}

/// What walls still bear: by bites where that leads on, else straight along, the nearest stretch first.
void AdaptiveFinish::cut_walls() {
  int round = 0;
  for (auto stretches = unfinished(); !stretches.empty(); stretches = unfinished()) {
    bool bitten = false;
    for (auto left = stretches; !left.empty() && round < kMostRounds;) {
      const auto next = nearest_stretch(left);
      bitten = peel(*next) || bitten;
      left.erase(next);
    }
    ++round;
    if (!bitten) cut_stretch(*nearest_stretch(stretches));
  }
}

/// Where a wall leaves the stock a point of the target may stand beyond the last mark: over it, a little farther.
void AdaptiveFinish::cut_wall_ends() {
  for (const Region& region : target_) {
    for (const Edge& edge : region.edges()) {
      if (!stands_at(edge.from)) continue;
      const Vec2 p = nearest_legal(edge.from);
      for (std::size_t w = 0; w < cuts_.walls.count(); ++w) {
        const auto hit = cuts_.walls.wall(w).nearest(p);
        if (hit.distance > kRest) continue;
        cut_stretch({w, hit.s - kBeyondEnd * radius_, hit.s + kBeyondEnd * radius_});
        break;
      }
    }
  }
}

/// Whether anything within reach stands at a corner of the target.
bool AdaptiveFinish::stands_at(Vec2 corner) const {
  for (int i = 0; i < 8; ++i) {
    const Vec2 p = corner + direction_of(kPi / 4 * i) * kRest;
    if (!ground_.is_removed(p) && contains(target_, p) && distance(nearest_legal(p), p) < radius_)
      return true;
  }
  return false;
}

std::vector<WallStretch> AdaptiveFinish::unfinished() const {
  return unfinished_walls(cuts_.walls, kMarkPitch * radius_, kMergeGap * radius_, ground_);
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

/// By bites within the limit, each from where the wall is clear. Whether that took anything away.
bool AdaptiveFinish::peel(const WallStretch& stretch) {
  const Walls& walls = cuts_.walls;
  Peeler peeler(ground_, walls.wall(stretch.wall), limit_);
  const auto bearing = [&](const WallStretch& within) {
    return bearing_part(walls, within, kPeelPitch * radius_, kPeelFilm, ground_);
  };
  auto left = bearing(stretch);
  const bool began = left.has_value();
  bool idle = false;
  int bites = 0;
  while (left && !idle && bites < kMostBites) {
    const auto way = way_to_bite(*left);
    const Path bite = way ? peeler.bite(left->from, left->to) : Path{};
    if (bite.empty()) break;
    path_.cut(bite, *way);
    ++bites;
    const auto before = *left;
    left = bearing(before);
    if (left) idle = before.to - before.from - (left->to - left->from) < kLeastBite;
  }
  if (bites > (idle ? 1 : 0) || !began) return began;
  return bite_from_aside(stretch);
}

/// The same from beside any place of a stretch, the middle first.
bool AdaptiveFinish::bite_from_aside(const WallStretch& stretch) {
  if (bite_from_aside(WallPlace{stretch.wall, (stretch.from + stretch.to) / 2})) return true;
  const double whole = stretch.to - stretch.from;
  const int places = std::min(kMostAside, static_cast<int>(whole / (kAsidePitch * radius_)));
  for (int i = 0; i < places; ++i) {
    if (bite_from_aside(WallPlace{stretch.wall, stretch.from + whole * (i + 0.5) / places})) return true;
  }
  return false;
}

/// Towards the wall at `place` from a clear place beside it, and along it. Whether anything was cut.
bool AdaptiveFinish::bite_from_aside(const WallPlace& place) {
  const Wall& wall = cuts_.walls.wall(place.wall);
  const Vec2 p = wall.at(place.s), inwards = left_of(wall.heading(place.s));
  for (const double share : kGates) {
    const Vec2 gate = p + inwards * (share * radius_);
    if (!ground_.legal().holds_line(p, gate) || ground_.touches(gate, Ground::kFree)) continue;
    const Path bite = Peeler(ground_, wall, limit_).bite_from_aside(gate, place.s);
    if (bite.empty()) continue;
    auto way = path_.empty() ? std::nullopt : path_.way_to(gate, Ground::kFree);
    if (!way) way = path_.hop_if_clear(gate);
    if (!way) continue;
    path_.cut(bite, *way);
    return true;
  }
  return false;
}

std::optional<Way> AdaptiveFinish::way_to_bite(const WallStretch& stretch) {
  const Vec2 p = cuts_.walls.point({stretch.wall, stretch.from});
  if (!path_.empty()) {
    // Bites begin near the end of the one before: straight over its film rather than round it.
    if (ground_.is_free(path_.at(), p, kCornerFree)) return Way{{p}};
    if (auto way = path_.way_to(p, Ground::kFree)) return way;
    if (auto way = path_.way_to(p, kCornerFree)) return way;
  }
  return path_.hop_if_clear(p);
}

void AdaptiveFinish::cut_stretch(const WallStretch& place) {
  const Wall& wall = cuts_.walls.wall(place.wall);
  const bool round = place.to - place.from >= wall.length() * (1 - 1e-9);
  Path stretch = round ? wall.loop() : wall.part(place.from, place.to);
  const Vec2 p = stretch.front().from, inwards = left_of(stretch.front().tangent_at(0));
  for (const double share : {0.0, 0.02, 0.05, 0.1, 0.2, 0.4}) {
    const Vec2 gate = p + inwards * (share * radius_);
    if (!ground_.legal().holds_line(gate, p) || ground_.touches(gate, Ground::kFree)) continue;
    const auto way = path_.way_to(gate, Ground::kFree);
    if (!way) continue;
    if (share > 0) stretch.insert(stretch.begin(), Edge::line(gate, p));
    return path_.cut(stretch, *way);
  }
  if (const auto way = path_.way_to(p, radius_ * (1 - std::cos(limit_))); way && !path_.empty()) {
    // Over films: at the cutting feed.
    Path lead;
    for (const Leg& leg : *way) lead.push_back(leg.edge(lead.empty() ? path_.at() : lead.back().to));
    stretch.insert(stretch.begin(), lead.begin(), lead.end());
  } else if (!path_.empty()) {
    path_.finish_pass();
  }
  path_.cut(stretch, {});
}

/// What still stands between the cuts: over each place that the check of the whole cover finds. False where as many as
/// `most` were cut and some are left.
bool AdaptiveFinish::cut_rests(bool open, int most) {
  for (int left = most; left > 0;) {
    const auto holes = rests(Cover(path_.moves(), radius_ + kRest, Cover::Looks::kAtRims), open);
    const int before = left;
    for (const Vec2 hole : holes) {
      if (ground_.is_removed(hole)) continue;
      if (left <= 0) return false;
      const Vec2 p = nearest_legal(hole);
      if (cut_rest(p) || enter_rest(p)) --left;
    }
    if (left == before) return true;
  }
  return rests(Cover(path_.moves(), radius_ + kRest, Cover::Looks::kAtRims), open).empty();
}

std::vector<Vec2> AdaptiveFinish::rests(const Cover& cover, bool open) const {
  auto holes = cover.holes([&](Vec2 p) { return is_reachable(p); });
  if (open) add_holes_at_border(cover, holes);
  return holes;
}

/// Holes that reach beyond the target may have no vertex inside it; they meet its border.
void AdaptiveFinish::add_holes_at_border(const Cover& cover, std::vector<Vec2>& holes) const {
  for (const Region& region : target_) {
    for (const Edge& edge : region.edges()) {
      const double length = edge.length();
      bool in_hole = false;
      for (double s = 0; s < length;) {
        const Vec2 p = edge.at(s / length);
        // No nearer than by how far it is inside anything ends.
        const double inside = radius_ + kRest - cover.distance_to(p);
        const bool hole = inside < 0 && is_within_reach(p, radius_ + kTouched);
        if (hole && !in_hole) holes.push_back(p);
        in_hole = hole;
        s += inside < 0 ? kBorderPitch * radius_ : std::max(inside, kRest);
      }
    }
  }
}

bool AdaptiveFinish::is_reachable(Vec2 p) const {
  return is_within_reach(p, radius_ - kReach);
}

bool AdaptiveFinish::is_within_reach(Vec2 p, double reach) const {
  return ground_.legal().contains(p) || ground_.legal().is_near_boundary(p, reach);
}

Vec2 AdaptiveFinish::nearest_legal(Vec2 p) const {
  if (legal_.contains(p)) return p;
  Nearest best{p, 1e300, 0};
  for (const Edge& edge : legal_.edges()) {
    if (distance(edge, p) < best.distance) best = clearcut::nearest(edge, p);
  }
  return best.point;
}

/// A short cut that ends at p from a side that is free: straight within the limit, else round what stands there, else
/// straight.
bool AdaptiveFinish::cut_rest(Vec2 p) {
  return from_gates_about(p, [&](Vec2 gate, const Way& way) { return cut_straight(gate, p, limit_, way); }) ||
         from_gates_about(p, [&](Vec2 gate, const Way& way) { return cut_round(gate, p, way); }) ||
         from_gates_about(p, [&](Vec2 gate, const Way& way) { return cut_straight(gate, p, kPi, way); });
}

/// Whether `cut` cuts from one of the clear places about p, the nearest first.
template <typename Cut>
bool AdaptiveFinish::from_gates_about(Vec2 p, const Cut& cut) {
  for (const double reach : {0.3, 0.6, 1.0, 1.5}) {
    for (int i = 0; i < 8; ++i) {
      const Vec2 gate = p + direction_of(kPi / 4 * i) * (reach * radius_);
      if (!ground_.legal().holds_line(gate, p) || ground_.touches(gate, Ground::kFree)) continue;
      const auto way = path_.way_to(gate, Ground::kFree);
      if (way && cut(gate, *way)) return true;
    }
  }
  return false;
}

bool AdaptiveFinish::cut_straight(Vec2 gate, Vec2 p, double limit, const Way& way) {
  const Edge line = Edge::line(gate, p);
  if (ground_.length_within(line, limit) < line.length()) return false;
  path_.cut({line}, way);
  return true;
}

/// With what stands about p on the right, within the limit.
bool AdaptiveFinish::cut_round(Vec2 gate, Vec2 p, const Way& way) {
  path_.note_start(gate);
  for (const double turn : {0.25, 0.5, 0.0}) {
    const std::size_t before = ground_.cuts();
    const Path cut = cut_on(gate, rotated(unit(p - gate), turn * kPi));
    if (length(cut) > kLeastRound * radius_) {
      path_.append(cut, way);
      return true;
    }
    ground_.forget_beyond(before);
  }
  return false;
}

/// What no free way leads to is entered from above.
bool AdaptiveFinish::enter_rest(Vec2 p) {
  for (const double reach : {0.5, 0.2, 0.05, 0.01, 0.002}) {
    for (int i = 0; i < 8; ++i) {
      const Vec2 from = p + direction_of(kPi / 4 * i) * (reach * radius_);
      if (!ground_.legal().holds_line(from, p)) continue;
      path_.finish_pass();
      path_.cut({Edge::line(from, p)}, {});
      return true;
    }
  }
  return false;
}

}  // namespace clearcut::plan::adaptive
