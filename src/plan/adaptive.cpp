#include "plan/adaptive.h"

#include <algorithm>
#include <cmath>

#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "plan/adaptive_corners.h"
#include "plan/adaptive_front.h"
#include "plan/adaptive_peel.h"
#include "plan/adaptive_trace.h"
#include "plan/clearing_path.h"
#include "plan/contour_cover.h"

namespace clearcut {
namespace {

/// Radians. What rounding in the program, arcs fitted to traced curves and the sampling of the contact may add.
constexpr double kContactMargin = 0.003;
/// Tool radii that the centre must have to each side where an entry is made later.
constexpr double kLeastRoom = 0.15;
/// Radius of the entry circle as a share of the cutter's: below 1 no post is left in its middle.
constexpr double kEntryCircle = 0.8;
/// Tool radii between the marks on walls.
constexpr double kMarkPitch = 0.1;
/// The same where nothing may stay: what stands between two marks is no thicker than 1/8 of its square.
constexpr double kFinePitch = 0.06;
/// Tool radii that clearing keeps off the walls, for what arcs deviate from the curves they are fitted to.
constexpr double kKeepOff = 0.0035;
/// Tool radii. A cut begins no farther before the material that it is after.
constexpr double kLongestApproach = 1.5;
/// Tool radii. A start from which a cut advances less along the wall is given up.
constexpr double kLeastAdvance = 0.03;
/// Entries for what the cuts from elsewhere cannot reach.
constexpr int kMostEntries = 20;
/// Tool radii that the centre may run beyond an open side.
constexpr double kBeyondOpenSides = 1.01;
/// Tool radii between the places beside the stock from where cuts are tried, how far inside their outline these are, and
/// how near the stock is there.
constexpr double kAirPitch = 0.5;
constexpr double kBesideAir = 0.005;
constexpr double kNearStock = 0.05;
/// Tool radii of wall without contact that end a cut while clearing.
constexpr double kAir = 0.3;
/// Tool radii of wall that are cut after a corner before the corner itself.
constexpr double kCornerReach = 0.9;
constexpr double kEndless = 1e300;
/// mm. Material thinner than this may stay on walls, and in corners.
constexpr double kWallFilm = 1.5e-3;
constexpr double kCornerFilm = 2e-3;
/// mm. What ways to corners may graze: walls there are cut to within kWallFilm.
constexpr double kCornerFree = 3e-3;
/// Length along a wall of the last move onto it over the distance that it comes from.
constexpr double kGateSlopes[] = {0, 2, 6, 16};
constexpr double kLongestGate = 3;  // tool radii
/// Gates beside a wall to which a way is looked for.
constexpr int kMostGates = 3;
/// mm. Rests thinner than this stay. More rests than so many are not cut one by one.
constexpr double kRest = 0.004;
constexpr int kMostRests = 60;
/// mm. Links through what is cleared may graze as much.
constexpr double kFree = 1e-3;
/// mm. Where no more than this stands the cutter goes straight down.
constexpr double kClear = 5e-4;
/// Tool radii. Shorter stretches of wall that are finished already are run over at the cutting feed.
constexpr double kMergeGap = 0.8;
/// Tool radii from a wall from where bites towards it are tried.
constexpr double kGates[] = {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.4};
/// Tool radii between looks at a wall that is cut by bites.
constexpr double kPeelPitch = 0.02;
/// mm. Bites that take less of the wall are idle.
constexpr double kLeastBite = 1e-3;
constexpr int kMostBites = 300;
/// Times that all walls are gone over with bites.
constexpr int kMostRounds = 30;
/// Tool radii of wall on both sides of its end that are run along where something still stands there.
constexpr double kBeyondEnd = 0.2;
/// Share of a disc that must be uncut for an entry of its own.
constexpr double kFreshShare = 0.6;

/// Whether the cutter may be far beside what is to be removed.
bool has_open_side(const Layer& layer) {
  const Box reach = box(layer.target).grown(layer.tool_radius), allowed = box(layer.allowed);
  return !reach.contains(allowed.min) || !reach.contains(allowed.max);
}

/// Where the cutter may be, less what lies far beyond open sides: there it cuts air.
Regions area_near_target(const Layer& layer, const Tolerances& tol) {
  if (!has_open_side(layer)) return layer.allowed;
  const double reach = (1 + kBeyondOpenSides) * layer.tool_radius + layer.wall_stock;
  return intersect(layer.allowed, dilate(layer.target, reach, tol), tol);
}

/// Walls to cut along, and the cuts that begin there.
struct Stage {
  Walls walls;
  Tracer tracer;
};

/// Where traced cuts may run: `clearing` beside what a wall pass takes later, `finishing` beside the walls.
struct InnerAreas {
  Regions clearing;
  Regions finishing;
};

/// The passes of one connected legal area.
class AdaptivePlanner {
 public:
  AdaptivePlanner(const Region& legal, const InnerAreas& inner, const Clearance& clearance,
                  const Layer& layer, double limit, std::optional<Vec2> start)
      : legal_(legal),
        front_(front_area(legal, layer.tool_radius, limit)),
        clearance_(clearance),
        radius_(layer.tool_radius),
        reach_(layer.tool_radius + layer.wall_stock),
        depth_(layer.z_top - layer.z),
        limit_(limit),
        ground_({legal}, radius_, layer.stock),
        ways_(clearance.axis(), reach_, 2 * radius_),
        clearing_{{front_, legal, kMarkPitch * radius_, film()},
                  {ground_, clearing_.walls, inner.clearing, limit, {kAir * radius_, 0}}},
        finishing_{
            {legal, kFinePitch * radius_, kWallFilm},
            {ground_, finishing_.walls, inner.finishing, limit, {kMergeGap * radius_, kMarkPitch * radius_}}},
        path_(ground_, ways_),
        open_(layer.stock && has_open_side(layer)),
        target_(layer.target),
        start_(start),
        holes_(layer.holes) {
    for (const PredrilledHole& hole : holes_) ground_.remove_disc(hole.center, hole.diameter / 2);
  }

  std::vector<Pass> plan() {
    if (open_) cut_from_outside();
    rooms_ = choose_rooms();
    for (std::size_t i = 0; i < rooms_.size(); ++i) {
      if (!path_.empty()) finish_pass();
      clear_room(rooms_[i]);
      cut_fronts(clearing_, [&](Vec2 p) { return nearest_room(p) == i; });
    }
    cut_fronts(clearing_, [](Vec2) { return true; });
    enter_what_is_left();
    finish_walls();
    cut_walls();
    if (open_) cut_wall_ends();
    cut_rests();
    if (!path_.empty()) finish_pass();
    return std::move(passes_);
  }

 private:
  /// In at open sides, as far as that leads.
  void cut_from_outside() {
    const auto everywhere = [](Vec2) { return true; };
    clearing_.walls.update(ground_, legal_.box());
    cut_fronts(clearing_, everywhere);
    const Wall outline(legal_.outer());
    const double end = outline.length();
    for (double s = 0; s < end; s += kAirPitch * radius_) {
      if (cut_from_air(outline, s)) cut_fronts(clearing_, everywhere);
    }
  }

  /// Round the stock with it on the right, nearer until the contact is at the limit, and on. Whether it stands beside
  /// the outline at s, with nothing on it.
  bool cut_from_air(const Wall& outline, double s) {
    const Vec2 along = outline.heading(s), inwards = left_of(along),
               p = outline.at(s) + inwards * (kBesideAir * radius_);
    if (ground_.touches(p, kClear) || !ground_.touches(p + inwards * (kNearStock * radius_), kFree))
      return false;
    const auto way = path_.empty() ? std::nullopt : path_.way_to(p, kFree);
    const Path cut = finishing_.tracer.cut_on(p, -along, 0);
    if (cut.empty()) return false;
    path_.append(cut, way ? *way : hop_to(p));
    clearing_.walls.update(ground_, box(cut).grown(2 * radius_));
    return true;
  }

  /// What the cuts could not reach is entered from above.
  void enter_what_is_left() {
    for (int i = 0; i < kMostEntries && !clearing_.walls.starts().empty() && !path_.empty(); ++i) {
      finish_pass();
      cut_fronts(clearing_, [](Vec2) { return true; });
    }
    resume_pass();
    for (int i = 0; i < kMostEntries; ++i) {
      const auto room = widest_uncut();
      if (!room) return;
      if (!path_.empty()) finish_pass();
      clear_room(*room);
      cut_fronts(clearing_, [](Vec2) { return true; });
    }
  }

  std::optional<Disc> widest_uncut() const {
    std::optional<Disc> best;
    for (const AxisPoint& place : clearance_.axis().points) {
      if (place.clearance < reach_ || (best && place.clearance - reach_ + radius_ <= best->radius)) continue;
      if (ground_.is_removed(place.point) || !front_.contains(place.point)) continue;
      const double wide = front_.boundary_distance(place.point);
      if (wide > kLeastRoom * radius_) best = Disc{place.point, wide + radius_};
    }
    return best;
  }

  /// A spiral in the room, and on round it. A last thin turn of the spiral would waste most of a round; it is needed only
  /// where no cut leads on without it.
  void clear_room(const Disc& room) {
    path_.open(room, kEntryCircle * radius_, limit_, hole_at(room.center));
    const Walls walls = clearing_.walls;
    const std::size_t spiral = ground_.cuts();
    Path round = go_round();
    if (!leads_on()) {
      ground_.forget_beyond(spiral);
      clearing_.walls = walls;
      path_.widen_to_rim(room, limit_);
      round = go_round();
    }
    path_.append(round, {});
  }

  /// On from the last turn of the spiral.
  Path go_round() {
    const auto last = path_.last_arc();
    Path round = last ? clearing_.tracer.cut_on(last->to, last->tangent_at(1), 1 / last->radius()) : Path{};
    clearing_.walls.update(ground_, legal_.box());
    return round;
  }

  /// Whether a cut can be made from a wall.
  bool leads_on() {
    const std::size_t before = ground_.cuts();
    const auto starts = clearing_.walls.starts();
    return std::any_of(starts.begin(), starts.end(), [&](const WallPlace& start) {
      const Path cut = clearing_.tracer.cut_from(start, start.s);
      ground_.forget_beyond(before);
      return length(cut) > radius_;
    });
  }

  std::size_t nearest_room(Vec2 p) const {
    const auto nearer = [&](const Disc& a, const Disc& b) {
      return distance(a.center, p) - a.radius < distance(b.center, p) - b.radius;
    };
    return static_cast<std::size_t>(std::min_element(rooms_.begin(), rooms_.end(), nearer) - rooms_.begin());
  }

  /// What cuts that end at a wall leave between them.
  double film() const {
    return std::max(0.16 * step() * step() / radius_, radius_ * (1 - std::cos(limit_ / 3)));
  }
  double step() const { return radius_ * (1 - std::cos(limit_)); }

  /// The widest places, each worth an entry of its own. The radius is that of the material cleared.
  std::vector<Disc> choose_rooms() const {
    std::vector<Disc> rooms;
    if (const auto first = first_room()) rooms.push_back(*first);
    for (const AxisPoint& center : clearance_.centers()) {
      if (center.clearance < reach_ || !front_.contains(center.point)) continue;
      if (ground_.is_removed(center.point)) continue;
      const Disc disc{center.point, front_.boundary_distance(center.point) + radius_};
      if (rooms.empty() || (is_worth_entry(disc) && is_fresh(disc, rooms))) rooms.push_back(disc);
    }
    return rooms;
  }

  /// At the place asked for, else at the hole that is farthest from walls.
  std::optional<Disc> first_room() const {
    std::vector<Vec2> places;
    if (start_) places.push_back(*start_);
    std::optional<Disc> best;
    if (!start_) {
      for (const PredrilledHole& hole : holes_) places.push_back(hole.center);
    }
    for (const Vec2 place : places) {
      if (!front_.contains(place)) continue;
      const double wide = front_.boundary_distance(place);
      if (wide > kLeastRoom * radius_ && (!best || wide + radius_ > best->radius))
        best = Disc{place, wide + radius_};
    }
    return best;
  }

  /// Radius of the widest hole about a place.
  double hole_at(Vec2 place) const {
    double radius = 0;
    for (const PredrilledHole& hole : holes_)
      radius = std::max(radius, hole.diameter / 2 - distance(hole.center, place));
    return radius;
  }

  /// A spiral saves the returns of arcs, about a quarter of their time; an entry costs a helix and a hop.
  bool is_worth_entry(const Disc& disc) const {
    const double spiral = kPi * disc.radius * disc.radius / step();
    const double helix = 2 * depth_ / std::tan(3 * kPi / 180) + 40;
    return 0.25 * spiral > helix;
  }

  static bool is_fresh(const Disc& disc, const std::vector<Disc>& rooms) {
    constexpr int kRings = 6, kSpokes = 24;
    int fresh = 0;
    for (int i = 0; i < kRings * kSpokes; ++i) {
      const int ring = i / kSpokes;
      const double rho = disc.radius * std::sqrt((ring + 0.5) / kRings);
      const Vec2 p = disc.center + direction_of(2 * kPi * (i % kSpokes) / kSpokes) * rho;
      fresh += std::none_of(rooms.begin(), rooms.end(),
                            [&](const Disc& room) { return distance(room.center, p) < room.radius; });
    }
    return fresh > kFreshShare * kRings * kSpokes;
  }

  /// Cuts from wall to wall, the nearest start first, until no wall that is wanted touches material. What
  /// cannot be reached now is tried again after everything else.
  template <typename Wanted>
  void cut_fronts(Stage& stage, const Wanted& wanted) {
    std::vector<WallPlace> unreached;
    for (bool cut_since = false;;) {
      auto starts = stage.walls.starts();
      std::erase_if(starts, [&](const WallPlace& start) {
        return !wanted(stage.walls.point(start)) ||
               std::find(unreached.begin(), unreached.end(), start) != unreached.end();
      });
      if (starts.empty()) {
        if (unreached.empty() || !cut_since) return;
        unreached.clear();
        cut_since = false;
        continue;
      }
      const WallPlace start = nearest(stage, starts);
      if (cut_from(stage, start)) {
        cut_since = true;
      } else {
        unreached.push_back(start);
      }
    }
  }

  WallPlace nearest(const Stage& stage, const std::vector<WallPlace>& starts) const {
    const Vec2 at = path_.at();
    return *std::min_element(starts.begin(), starts.end(), [&](const WallPlace& a, const WallPlace& b) {
      return distance(stage.walls.point(a), at) < distance(stage.walls.point(b), at);
    });
  }

  bool cut_from(Stage& stage, const WallPlace& start) {
    Walls& walls = stage.walls;
    const auto approach = approach_to(walls, start);
    if (!approach) return false;
    note_start(approach->way.empty() ? walls.point(approach->first) : approach->way.back());
    const Path cut = stage.tracer.cut_from(approach->first, start.s);
    if (cut.empty()) {
      walls.give_up(start);
      return true;
    }
    Path whole = approach->lead;
    for (const Edge& edge : approach->lead) ground_.cut(edge);
    const Vec2 gate = whole.empty() ? approach->way.back() : whole.back().to;
    if (gate != cut.front().from) whole.push_back(Edge::line(gate, cut.front().from));
    whole.insert(whole.end(), cut.begin(), cut.end());
    path_.append(whole, approach->way);
    walls.update(ground_, box(cut).grown(2 * radius_));
    if (walls.is_start(start) &&
        !walls.advances(start, stage.tracer.first_departure(), kLeastAdvance * radius_)) {
      walls.give_up(start);
    }
    return true;
  }

  /// A free way to a gate, from where a short move leads to the first place of a cut.
  struct Approach {
    std::vector<Vec2> way;
    Path lead;  ///< at the cutting feed, through films
    WallPlace first;
  };

  /// The way of a link; a pass may begin anywhere.
  std::optional<std::vector<Vec2>> way_to(Vec2 p) const {
    return path_.empty() ? std::vector<Vec2>{p} : path_.way_to(p, kFree);
  }

  /// Begins a new pass at p, where nothing stands any more, from above.
  std::vector<Vec2> hop_to(Vec2 p) {
    if (!path_.empty()) finish_pass();
    path_.start_clear(true);
    return {p};
  }
  /// The same where nothing stands.
  std::optional<std::vector<Vec2>> hop_if_clear(Vec2 p) {
    if (ground_.touches(p, kClear)) return std::nullopt;
    return hop_to(p);
  }

  /// Whether the contact keeps the limit on a short move.
  bool is_gentle(Vec2 from, Vec2 to) const {
    const Edge line = Edge::line(from, to);
    return ground_.length_within(line, limit_) >= line.length();
  }

  /// Where the wall bears nothing yet; else beside it.
  std::optional<Approach> approach_to(const Walls& walls, const WallPlace& start) const {
    const double farthest = std::min(kLongestApproach * radius_, walls.from_stop(start));
    for (double back = 0; back < farthest; back += kMarkPitch * radius_ / 2) {
      const WallPlace first{start.wall, start.s - back};
      if (ground_.touches(walls.point(first), kFree)) continue;
      if (const auto way = way_to(walls.point(first))) return Approach{*way, {}, first};
      break;
    }
    for (const double back : {0.0, 0.2, 0.5, 1.0}) {
      if (back * radius_ > farthest) break;
      if (const auto approach = approach_from_aside(walls, {start.wall, start.s - back * radius_}))
        return approach;
    }
    return approach_through_films(walls, start);
  }

  /// Over a gate beside the wall.
  std::optional<Approach> approach_from_aside(const Walls& walls, const WallPlace& place) const {
    const Vec2 p = walls.point(place), along = walls.wall(place.wall).heading(place.s);
    int tries = kMostGates;
    for (const double share : {0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5}) {
      for (const double slope : kGateSlopes) {
        const double aside = share * radius_;
        if (share * slope > kLongestGate) continue;
        const Vec2 gate = p - along * (slope * aside) + left_of(along) * aside;
        if (!ground_.legal().holds_line(gate, p) || ground_.touches(gate, kFree) || !is_gentle(gate, p))
          continue;
        if (const auto way = way_to(gate)) return Approach{*way, {}, place};
        if (--tries == 0) return std::nullopt;
      }
    }
    return std::nullopt;
  }

  /// Over what clearing left on the walls behind the start, within the limit.
  std::optional<Approach> approach_through_films(const Walls& walls, const WallPlace& start) const {
    if (path_.empty()) return std::nullopt;
    const double farthest = std::min(kLongestApproach * radius_, walls.from_stop(start));
    for (double back = 0; back < farthest; back += kMarkPitch * radius_) {
      const WallPlace first{start.wall, start.s - back};
      const double film = walls.film(first);
      if (ground_.touches(walls.point(first), film)) continue;
      const auto way = path_.way_to(walls.point(first), film);
      if (!way) continue;
      Approach approach{{}, {}, first};
      Vec2 at = path_.at();
      for (const Vec2 station : *way) {
        if (approach.lead.empty() && ground_.is_free(at, station, kFree)) {
          approach.way.push_back(station);
        } else {
          approach.lead.push_back(Edge::line(at, station));
        }
        at = station;
      }
      if (is_within(approach.lead)) return approach;
    }
    return std::nullopt;
  }

  bool is_within(const Path& path) const {
    return std::all_of(path.begin(), path.end(), [&](const Edge& edge) {
      return ground_.length_within(edge, limit_) >= edge.length();
    });
  }

  /// Along the walls within the limit; where they bear more, it is cut like any front. A corner follows when the walls on
  /// both sides of it are cut.
  void finish_walls() {
    if (path_.empty()) return;
    finishing_.walls.update(ground_, legal_.box());
    corners_ = corners_of(finishing_.walls, limit_);
    std::vector<WallPlace> stops;
    for (const Corner& corner : corners_) stops.push_back(corner.place);
    finishing_.walls.set_stops(std::move(stops));
    for (const WallPlace& place : finishing_.walls.anywhere()) {
      if (!cut_from(finishing_, place) && bite_from_aside(place))
        finishing_.walls.update(ground_, legal_.box());
    }
    for (auto starts = finishing_.walls.starts(); !starts.empty(); starts = finishing_.walls.starts()) {
      const WallPlace start = nearest(finishing_, starts);
      const bool after_corner = finishing_.walls.from_stop(start) < kCornerReach * radius_;
      finishing_.tracer.set_reach(after_corner ? kCornerReach * radius_ : kEndless);
      if (!cut_from(finishing_, start)) {
        finishing_.walls.give_up(start);
      } else if (after_corner) {
        finish_corner(
            std::min_element(corners_.begin(), corners_.end(), NearerCorner{finishing_.walls, path_.at()}));
      }
    }
    for (std::size_t left = corners_.size(); left > 0; --left)
      finish_corner(
          std::min_element(corners_.begin(), corners_.end(), NearerCorner{finishing_.walls, path_.at()}),
          true);
  }

  struct NearerCorner {
    const Walls& walls;
    Vec2 at;
    bool operator()(const Corner& a, const Corner& b) const {
      return distance(walls.point(a.place), at) < distance(walls.point(b.place), at);
    }
  };

  /// Cuts a corner that is prepared; others wait, or are left at `last`.
  void finish_corner(std::vector<Corner>::iterator corner, bool last = false) {
    if (corner == corners_.end()) return;
    const Path cuts = corner_cuts(finishing_.walls, *corner, ground_, limit_, kCornerFilm);
    const auto way = cuts.empty() ? std::nullopt : path_.way_to(cuts.front().from, kCornerFree);
    if (way) append(cuts, *way);
    if (way || last) corners_.erase(corner);
  }

  /// What walls still bear: by bites where that leads on, else straight along, the nearest stretch first.
  void cut_walls() {
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
  void cut_wall_ends() {
    for (const Region& region : target_) {
      for (const Edge& edge : region.edges()) {
        if (!stands_at(edge.from)) continue;
        const Vec2 p = nearest_legal(edge.from);
        for (std::size_t w = 0; w < finishing_.walls.count(); ++w) {
          const auto hit = finishing_.walls.wall(w).nearest(p);
          if (hit.distance > kRest) continue;
          cut_stretch({w, hit.s - kBeyondEnd * radius_, hit.s + kBeyondEnd * radius_});
          break;
        }
      }
    }
  }

  /// Whether anything within reach stands at a corner of the target.
  bool stands_at(Vec2 corner) const {
    for (int i = 0; i < 8; ++i) {
      const Vec2 p = corner + direction_of(kPi / 4 * i) * kRest;
      if (!ground_.is_removed(p) && contains(target_, p) && distance(nearest_legal(p), p) < radius_)
        return true;
    }
    return false;
  }

  std::vector<WallStretch> unfinished() const {
    return unfinished_walls(finishing_.walls, kMarkPitch * radius_, kMergeGap * radius_, ground_);
  }

  std::vector<WallStretch>::const_iterator nearest_stretch(const std::vector<WallStretch>& stretches) const {
    const Vec2 at = path_.at();
    const auto far = [&](const WallStretch& stretch) {
      return distance(finishing_.walls.point({stretch.wall, stretch.from}), at);
    };
    return std::min_element(stretches.begin(), stretches.end(),
                            [&](const WallStretch& a, const WallStretch& b) { return far(a) < far(b); });
  }

  /// By bites within the limit, each from where the wall is clear. Whether that took anything away.
  bool peel(const WallStretch& stretch) {
    const Walls& walls = finishing_.walls;
    Peeler peeler(ground_, walls.wall(stretch.wall), limit_);
    const auto bearing = [&](const WallStretch& within) {
      return bearing_part(walls, within, kPeelPitch * radius_, kCornerFilm, ground_);
    };
    auto left = bearing(stretch);
    const bool began = left.has_value();
    bool idle = false;
    int bites = 0;
    while (left && !idle && bites < kMostBites) {
      const auto way = way_to_bite(*left);
      const Path bite = way ? peeler.bite(left->from, left->to) : Path{};
      if (bite.empty()) break;
      append(bite, *way);
      ++bites;
      const auto before = *left;
      left = bearing(before);
      if (left) idle = before.to - before.from - (left->to - left->from) < kLeastBite;
    }
    if (bites > (idle ? 1 : 0) || !began) return began;
    return bite_from_aside({stretch.wall, (stretch.from + stretch.to) / 2});
  }

  /// Towards the wall at `place` from a clear place beside it, and along it. Whether anything was cut.
  bool bite_from_aside(const WallPlace& place) {
    const Wall& wall = finishing_.walls.wall(place.wall);
    const Vec2 p = wall.at(place.s), inwards = left_of(wall.heading(place.s));
    for (const double share : kGates) {
      const Vec2 gate = p + inwards * (share * radius_);
      if (!ground_.legal().holds_line(p, gate) || ground_.touches(gate, kFree)) continue;
      const Path bite = Peeler(ground_, wall, limit_).bite_from_aside(gate, place.s);
      if (bite.empty()) continue;
      auto way = path_.empty() ? std::nullopt : path_.way_to(gate, kFree);
      if (!way) way = hop_if_clear(gate);
      if (!way) continue;
      append(bite, *way);
      return true;
    }
    return false;
  }

  std::optional<std::vector<Vec2>> way_to_bite(const WallStretch& stretch) {
    const Vec2 p = finishing_.walls.point({stretch.wall, stretch.from});
    if (!path_.empty()) {
      if (auto way = path_.way_to(p, kFree)) return way;
      if (auto way = path_.way_to(p, kCornerFree)) return way;
    }
    return hop_if_clear(p);
  }

  void cut_stretch(const WallStretch& place) {
    const Wall& wall = finishing_.walls.wall(place.wall);
    const bool round = place.to - place.from >= wall.length() * (1 - 1e-9);
    Path stretch = round ? wall.loop() : wall.part(place.from, place.to);
    const Vec2 p = stretch.front().from, inwards = left_of(stretch.front().tangent_at(0));
    for (const double share : {0.0, 0.02, 0.05, 0.1, 0.2, 0.4}) {
      const Vec2 gate = p + inwards * (share * radius_);
      if (!ground_.legal().holds_line(gate, p) || ground_.touches(gate, kFree)) continue;
      const auto way = way_to(gate);
      if (!way) continue;
      if (share > 0) stretch.insert(stretch.begin(), Edge::line(gate, p));
      return append(stretch, *way);
    }
    if (const auto way = path_.way_to(p, step()); way && !path_.empty()) {
      // Over films: at the cutting feed.
      Path lead;
      for (const Vec2 station : *way)
        lead.push_back(Edge::line(lead.empty() ? path_.at() : lead.back().to, station));
      stretch.insert(stretch.begin(), lead.begin(), lead.end());
    } else if (!path_.empty()) {
      finish_pass();
    }
    append(stretch, {});
  }

  /// What is known about the place where a pass begins, before it is cut.
  void note_start(Vec2 p) {
    if (path_.empty()) path_.start_clear(!ground_.touches(p, kClear));
  }

  void append(const Path& cut, const std::vector<Vec2>& way) {
    note_start(cut.front().from);
    for (const Edge& edge : cut) ground_.cut(edge);
    path_.append(cut, way);
  }

  /// What still stands between the cuts: over each place that the check of the whole cover finds.
  void cut_rests() {
    for (int left = kMostRests; left > 0;) {
      const auto holes = Cover(all_cuts(), radius_ + kRest).holes([&](Vec2 p) { return is_reachable(p); });
      const int before = left;
      for (const Vec2 hole : holes) {
        if (left <= 0 || ground_.is_removed(hole)) continue;
        const Vec2 p = nearest_legal(hole);
        if (cut_rest(p) || enter_rest(p)) --left;
      }
      if (left == before) return;
    }
  }

  std::vector<Edge> all_cuts() const {
    std::vector<Edge> cuts;
    for (const Pass& pass : passes_) cuts.insert(cuts.end(), pass.path.begin(), pass.path.end());
    const Path& path = path_.path();
    cuts.insert(cuts.end(), path.begin(), path.end());
    return cuts;
  }

  bool is_reachable(Vec2 p) const { return distance(nearest_legal(p), p) < radius_ - kRest; }

  Vec2 nearest_legal(Vec2 p) const {
    if (legal_.contains(p)) return p;
    Nearest best{p, 1e300, 0};
    for (const Edge& edge : legal_.edges()) {
      if (distance(edge, p) < best.distance) best = clearcut::nearest(edge, p);
    }
    return best.point;
  }

  /// A short cut that ends at p, from the side that is free.
  bool cut_rest(Vec2 p) {
    for (const double reach : {0.3, 0.6, 1.0, 1.5}) {
      for (int i = 0; i < 8; ++i) {
        const Vec2 gate = p + direction_of(kPi / 4 * i) * (reach * radius_);
        if (!ground_.legal().holds_line(gate, p) || ground_.touches(gate, kFree)) continue;
        const auto way = way_to(gate);
        if (!way) continue;
        append({Edge::line(gate, p)}, *way);
        return true;
      }
    }
    return false;
  }

  /// What no free way leads to is entered from above.
  bool enter_rest(Vec2 p) {
    for (const double reach : {0.5, 0.2, 0.05}) {
      for (int i = 0; i < 8; ++i) {
        const Vec2 from = p + direction_of(kPi / 4 * i) * (reach * radius_);
        if (!ground_.legal().holds_line(from, p)) continue;
        if (!path_.empty()) finish_pass();
        append({Edge::line(from, p)}, {});
        return true;
      }
    }
    return false;
  }

  void finish_pass() { passes_.push_back(path_.take()); }

  /// Takes the last pass back where nothing was begun after it.
  void resume_pass() {
    if (!path_.empty() || passes_.empty()) return;
    path_.resume(std::move(passes_.back()));
    passes_.pop_back();
  }

  const Region& legal_;
  Region front_;  ///< where it clears; the rest is the wall pass's
  const Clearance& clearance_;
  double radius_, reach_, depth_, limit_;
  Ground ground_;
  FreeWays ways_;
  Stage clearing_, finishing_;
  ClearingPath path_;
  bool open_;  ///< something beside the target is free
  const Regions& target_;
  std::optional<Vec2> start_;
  std::vector<PredrilledHole> holes_;
  std::vector<Disc> rooms_;
  std::vector<Corner> corners_;  ///< not yet cut
  std::vector<Pass> passes_;
};

/// The passes of one legal area, to run one after the other.
void add_passes(LayerPasses& result, std::vector<Pass> passes) {
  const auto first = static_cast<int>(result.passes.size()), count = static_cast<int>(passes.size());
  for (int i = 0; i < count; ++i) {
    Pass& pass = passes[static_cast<std::size_t>(i)];
    pass.parent = i + 1 < count ? first + i + 1 : -1;
    pass.component = first;
    pass.offset = count - i;
    result.passes.push_back(std::move(pass));
  }
}

/// The areas where traced cuts may run, of each region of `legal`.
std::vector<InnerAreas> inner_areas(const Regions& legal, const Clearance& clearance, const Layer& layer,
                                    double limit) {
  std::vector<InnerAreas> areas(legal.size());
  for (const Region& region : clearance.inset(layer.tool_radius * (1 + kKeepOff) + layer.wall_stock)) {
    const Vec2 p = region.outer().front().from;
    const auto in = std::find_if(legal.begin(), legal.end(), [&](const Region& r) { return r.contains(p); });
    if (in == legal.end()) continue;
    InnerAreas& inner = areas[static_cast<std::size_t>(in - legal.begin())];
    inner.clearing.push_back(front_area(region, layer.tool_radius, limit));
    inner.finishing.push_back(region);
  }
  return areas;
}

void add_fit_lines(LayerPasses& result, const std::vector<Path>& lines) {
  for (const auto& line : lines) {
    Pass pass;
    pass.path = line;
    pass.closed = line.size() > 1 && line.front().from == line.back().to;
    pass.component = static_cast<int>(result.passes.size());
    pass.may_cut_to_start = false;
    result.passes.push_back(std::move(pass));
    result.fit_lines.push_back(line);
  }
}

}  // namespace

LayerPasses plan_adaptive(const Layer& layer, const AdaptiveOptions& options, const Tolerances& tol) {
  LayerPasses result;
  result.z_top = layer.z_top;
  result.z = layer.z;
  result.target = layer.target;
  result.strategy = "adaptive";
  const double first = layer.tool_radius + layer.wall_stock;
  const double limit = options.engagement.radians() - kContactMargin;
  for (const auto& region : area_near_target(layer, tol)) {
    const Clearance clearance(region, tol);
    auto legal = clearance.inset(first);
    const auto inner = inner_areas(legal, clearance, layer, limit);
    for (std::size_t i = 0; i < legal.size(); ++i) {
      add_passes(result, AdaptivePlanner(legal[i], inner[i], clearance, layer, limit, options.start).plan());
      result.legal.push_back(std::move(legal[i]));
    }
    add_fit_lines(result, clearance.fit_lines(first, layer.reserve));
  }
  return result;
}

}  // namespace clearcut
