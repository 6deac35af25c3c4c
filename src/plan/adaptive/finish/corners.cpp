#include "plan/adaptive/finish/corners.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "base/elementary.h"
#include "base/units.h"
#include "plan/adaptive/clearing/arcs.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// mm. Arcs need not come nearer to the corner than this.
constexpr double kNearest = 1e-3;
/// mm. Two centres nearer than kNear are taken for one. A centre counts as visited if kVisited or less stands there.
constexpr double kNear = 1e-4;
constexpr double kVisited = 2.5e-3;
/// Share of the tool radius: distance between samples along a wall when cusps are searched for.
constexpr double kCuspStep = 0.02;
/// Factor between the distances from the corner at which a wall is sampled.
constexpr double kFarther = 1.25;
/// mm. Arcs shorter than kShortArc become lines. Cusps up to kCusp may stay on the wall between arcs.
constexpr double kShortArc = 0.0025;
constexpr double kCusp = 2e-3;
/// Radians. Arcs are aimed this much above the limit; an excess up to kAbove is accepted.
constexpr double kAim = 0.012;
constexpr double kAbove = 0.02;
constexpr int kMostArcs = 400;
/// Radians. Walls that open by less, as beside a passage that the cutter just fits, leave no room to come nearer on kMostArcs arcs.
constexpr double kSharpest = 0.03;
/// Arcs and spirals are compared by the natural logarithm of (distance from the corner before / after). An arc is
/// good enough if that is kGoodGain, or kArcShare of what a spiral would have.
constexpr double kGoodGain = 0.7;
constexpr double kArcShare = 0.45;
/// Radians. Margins to the limit on spirals, tried in this order; greatest and least turn of their arcs.
constexpr double kMargins[] = {0, 0.05, 0.12};
constexpr double kWidestSpiralTurn = 0.8;
constexpr double kLeastSpiralTurn = 0.3;
/// Two distances within this factor are taken for equal.
constexpr double kCloseTo = 1.01;
/// Tries for one arc; factors applied to its end when the arc, or its end alone, exceeds the limit.
constexpr int kMostTries = 6;
constexpr double kNotSoNear = 1.15;
constexpr double kNearer = 0.8;
/// After up to kMostStraight ends on the second wall the cutter may go straight back over the cusps of the
/// first wall, unless the path round the corner has more than kLong moves.
constexpr int kMostStraight = 2;
constexpr std::size_t kLong = 12;
/// The distance that is searched for is expected to be within this factor of the guess.
constexpr double kGuessed = 1.04;
/// Radians by which the turn off the wall grows in the first tries.
constexpr double kMoreTurn = 0.02;
/// Share of the distance from the corner: the engagement is sampled this far ahead, as nothing is touched here.
constexpr double kAhead = 0.05;
/// Greatest number of times that a heading is turned to bring its engagement to the limit.
constexpr int kMostTurns = 5;
/// Shares of the distance from the corner: arcs have to end within kLeastGain of it, moves along within the other.
constexpr double kLeastGain = 0.97;
constexpr double kEnoughAlong = 0.8;

/// The angle from u to v in radians, positive to the left.
double angle_between(Vec2 u, Vec2 v) {
  return base::atan2(cross(u, v), dot(u, v));
}

/// Builds the path round one corner. Distances: mm from the corner along its first (0) or second wall (1).
class CornerCuts {
 public:
  /// `straight`: number of cuts that end on the second wall; after that many the path goes straight back to the first wall, over the
  /// cusps.
  CornerCuts(const Wall& wall, const Corner& corner, RemainingStock& remaining, double limit, int straight)
      : wall_(wall),
        remaining_(remaining),
        radius_(remaining.tool_radius()),
        s_(corner.place.s),
        turn_(corner.turn),
        limit_(limit),
        straight_(straight) {}

  /// The path from `a` mm before the corner to `b` mm after it, until at most `residual` mm stay.
  std::optional<CornerRound> cuts(double a, double b, double residual) {
    cut_[0] = a;
    cut_[1] = b;
    for (int i = 0; i < kMostArcs && left() > residual; ++i) {
      if (side_ == 0) go_along_first(i == 0 ? 1 : kEnoughAlong);
      if (left() > residual && !go_across()) return std::nullopt;
    }
    if (path_.empty() || left() > residual) return std::nullopt;
    if (may_end_on_first(residual)) return CornerRound{std::move(path_), s_ - cut_[0], 0, aside()};
    if (!go_to_second(residual)) return std::nullopt;
    return CornerRound{std::move(path_), s_ + cut_[1], residual_before_};
  }

  /// Whether it had to cut along the first wall again because of cusps.
  bool leaves_cusps() const { return cusps_ > 0; }

 private:
  Vec2 at(int side, double x) const { return wall_.at(side == 0 ? s_ - x : s_ + x); }
  /// The wall's heading towards the corner.
  Vec2 into(int side, double x) const { return side == 0 ? wall_.heading(s_ - x) : -wall_.heading(s_ + x); }
  /// u turned by `angle` radians; positive towards the other wall.
  static Vec2 turned(int side, Vec2 u, double angle) { return rotated(u, side == 0 ? angle : -angle); }

  double angle(Vec2 u, Vec2 v) const { return side_ == 0 ? angle_between(u, v) : angle_between(v, u); }

  Vec2 here() const { return path_.empty() ? at(side_, cut_[side_]) : path_.back().to; }

  void take(const Edge& edge) {
    if (distance(edge.from, edge.to) < kNear) return;
    remaining_.cut(edge);
    path_.push_back(edge);
  }

  /// Cuts along the edge if that keeps the limit.
  bool take_within(const Edge& edge) {
    if (!remaining_.is_legal(edge) || remaining_.length_within(edge, limit_ + kAbove) < edge.length())
      return false;
    take(edge);
    return true;
  }

  bool ends_within(const Edge& edge) const {
    return remaining_.engagement(edge.to, edge.tangent_at(1)) <= limit_ + kAim;
  }

  /// The least number x in (0, most] for which the end of edge_to(x) keeps the limit, if larger ones do;
  /// nothing if `most` does not. Numbers near `guess` are tried first.
  template <typename EdgeTo>
  std::optional<double> nearest_within(double most, double guess, const EdgeTo& edge_to) const {
    double low = std::min(kNearest, most), high = guess * kGuessed;
    if (guess > 0 && high < most && ends_within(edge_to(high))) {
      if (guess / kGuessed > low && !ends_within(edge_to(guess / kGuessed))) low = guess / kGuessed;
    } else {
      high = most;
      for (int i = 0; !ends_within(edge_to(high)); ++i, high *= kNearer) {
        if (i == kMostTries) return std::nullopt;
      }
      low = std::min(low, high);
      if (ends_within(edge_to(low))) return low;
    }
    // Geometric bisection, because an arc may come nearer by a factor of a hundred.
    while (high > low * kCloseTo) {
      const double middle = std::sqrt(low * high);
      (ends_within(edge_to(middle)) ? high : low) = middle;
    }
    return high;
  }

  /// Goes along the first wall, as near to the corner as the limit allows.
  void go_along_first(double least) {
    const double from = cut_[0];
    const auto along = [&](double to) { return Edge::line(at(0, to + kNear), at(0, to)); };
    if (least < 1 && !ends_within(along(from * least))) return;
    const double to = nearest_within(from, 0, along).value_or(from);
    if (to > from * least - kNear) return;
    for (const Edge& edge : wall_.part(s_ - from, s_ - to)) {
      const double within = remaining_.length_within(edge, limit_ + kAbove);
      if (within < edge.length()) {
        if (within > kNear) take(edge.part(0, within / edge.length()));
        cut_[0] -= within;
        return;
      }
      take(edge);
      cut_[0] -= edge.length();
    }
  }

  /// A path to the other wall, and the distance from the corner at which it ends.
  struct Crossing {
    Path path;
    double to = 0;
  };

  /// Goes to the other wall, nearer to the corner than before: on an arc or, if that gains much less, on a
  /// spiral.
  bool go_across() {
    if (side_ == 1 && --straight_ == 0 && go_back()) return true;
    const double most = cut_[1 - side_];
    if (spiral_arcs_[side_] > 0) {
      if (const auto spiral = spiral_across(-base::log(kLeastGain))) return go(*spiral);
    }
    const auto arc = arc_across();
    const double gain = arc ? base::log(most / arc->to) : 0;
    if (gain < kGoodGain) {
      if (const auto spiral = spiral_across(gain / kArcShare)) return go(*spiral);
    }
    return arc ? go(*arc) : side_ == 1 && go_back();
  }

  bool go(const Crossing& crossing) {
    const int other = 1 - side_;
    const double from = std::exchange(cut_[other], crossing.to);
    for (const Edge& edge : crossing.path) take(edge);
    side_ = other;
    if (side_ == 0 && cusps_ == 0 && remaining_.touches(at(0, (from + cut_[0]) / 2), kCusp)) cusps_ = from;
    return true;
  }

  std::optional<Crossing> arc_across() {
    const int other = 1 - side_;
    const double most = cut_[other];
    // Arcs on the same side are similar to each other: the last one is the first guess.
    Crossed& before = crossed_[side_];
    const double first = first_turn();
    double turn = first + before.more_turn, more = kMoreTurn, short_of = 1;
    for (int i = 0; i < kMostTries; ++i) {
      const Vec2 heading = turned(side_, into(side_, cut_[side_]), turn);
      const auto arc_to = [&](double x) { return arc_along(here(), heading, at(other, x)); };
      const double to = short_of * nearest_within(most, most * before.gain, arc_to).value_or(most);
      const Edge arc = arc_to(to);
      if (to > most * kLeastGain || !remaining_.is_legal(arc)) return std::nullopt;
      const double within = remaining_.length_within(arc, limit_ + kAbove);
      if (within >= arc.length()) {
        before = {to / short_of / most, (turn - first) / 2};
        return Crossing{{arc}, to};
      }
      if (within < arc.length() / 2) {
        turn += more;
        more *= 2;
      } else {
        short_of *= kNotSoNear;
      }
    }
    return std::nullopt;
  }

  /// A spiral about the last centre on the other wall, the pole, on which the heading is off the direction to
  /// the pole by `limit` radians: its radius shrinks by exp(-turn / tan(limit)).
  struct Spiral {
    Vec2 pole;
    Vec2 ray;  ///< from the pole to the beginning, mm
    double limit = 0;
    double radius(double turn) const { return norm(ray) * base::exp(-turn / base::tan(limit)); }
  };

  /// A spiral to the other wall; nothing if the logarithm of (distance before / after) is less than `least`.
  std::optional<Crossing> spiral_across(double least) {
    const int other = 1 - side_;
    if (cut_[other] >= RadiusShares::kCornerReach * radius_) return std::nullopt;
    const Vec2 pole = at(other, cut_[other]);
    // A smaller margin and one arc fewer than for the last spiral are tried first.
    int& arcs = spiral_arcs_[side_];
    arcs = std::max(0, arcs - 1);
    if (arcs == 0 && margin_ > 0) --margin_;
    for (; margin_ < std::size(kMargins); ++margin_) {
      const Spiral spiral{pole, here() - pole, limit_ - kMargins[margin_]};
      const double to = end_of(spiral);
      if (base::log(cut_[other] / to) < least) break;
      const double whole = angle(spiral.ray, at(other, to) - pole);
      for (arcs = std::max(arcs, static_cast<int>(whole / kWidestSpiralTurn) + 1);
           arcs <= whole / kLeastSpiralTurn + 1; ++arcs) {
        Path path = arcs_of(spiral, to, whole, arcs);
        const bool legal = std::all_of(path.begin(), path.end(),
                                       [&](const Edge& edge) { return remaining_.is_legal(edge); });
        if (legal && remaining_.keeps_limit(path, limit_ + kAbove, 0)) return Crossing{std::move(path), to};
      }
      arcs = 0;
    }
    margin_ = 0;
    arcs = 0;
    return std::nullopt;
  }

  /// The distance from the corner at which the spiral meets the other wall, mm.
  double end_of(const Spiral& spiral) const {
    const int other = 1 - side_;
    double low = 0, high = cut_[other];
    while (high - low > (kCloseTo - 1) * (cut_[other] - low)) {
      const double middle = (low + high) / 2, turn = angle(spiral.ray, at(other, middle) - spiral.pole);
      (cut_[other] - middle <= spiral.radius(turn) ? high : low) = middle;
    }
    return high;
  }

  Path arcs_of(const Spiral& spiral, double to, double whole, int arcs) const {
    Path path;
    for (int i = 1; i <= arcs; ++i) {
      const Vec2 begin = path.empty() ? here() : path.back().to;
      const double turn = whole * i / arcs;
      const Vec2 end = i == arcs ? at(1 - side_, to)
                                 : spiral.pole + turned(side_, unit(spiral.ray), turn) * spiral.radius(turn);
      path.push_back(arc_along(begin, turned(side_, unit(spiral.pole - begin), -spiral.limit), end));
    }
    return path;
  }

  /// Goes straight back to the first wall, to where it is already cut. False if the limit forbids it.
  bool go_back() {
    const double to = std::max(cut_[0], cusps_);
    if (back_ == to || !take_within(Edge::line(here(), at(0, to)))) return false;
    back_ = cut_[0] = to;
    cusps_ = 0;
    side_ = 0;
    return true;
  }

  /// Ends the path: cuts the cusps that arcs left on the first wall, then goes to where the second wall is
  /// cut on from.
  bool go_to_second(double residual) {
    if (cusps_ > 0 && (cut_cusps_from_second(residual) || cut_cusps())) side_ = 0;
    if (side_ == 1) return true;
    const Edge line = Edge::line(here(), at(1, cut_[1]));
    if (remaining_.is_legal(line)) return take_within(line);
    // Between walls that curve into the area the line is not legal: along the wall again.
    for (const Edge& edge : wall_.part(s_ - cusps_, s_ - cut_[0])) take(edge);
    return take_within(Edge::line(here(), at(1, cut_[1])));
  }

  bool cut_cusps() {
    if (side_ == 1 && !take_within(Edge::line(here(), at(0, cut_[0])))) return false;
    side_ = 0;
    const Path cusps = reversed(wall_.part(s_ - cusps_, s_ - cut_[0]));
    return std::all_of(cusps.begin(), cusps.end(), [&](const Edge& edge) { return take_within(edge); });
  }

  /// Cuts the cusps by going from the second wall at once to their far end, if the residual that then stays
  /// on the first wall is thin enough.
  bool cut_cusps_from_second(double residual) {
    if (side_ == 0) return false;
    const std::size_t before = remaining_.cuts();
    if (!take_within(Edge::line(here(), at(0, cusps_)))) return false;
    const double step = kCuspStep * radius_;
    double x = kNearest;
    while (x < cusps_ && !remaining_.touches(at(0, x), residual)) x = std::min(x * kFarther, x + step);
    if (x >= cusps_) {
      residual_before_ = cusps_;
      return true;
    }
    path_.pop_back();
    remaining_.forget_beyond(before);
    return false;
  }

  /// Radians; the least turn off the wall after which the engagement keeps the limit.
  double first_turn() const {
    const Vec2 from = here(), along = into(side_, cut_[side_]),
               across = at(1 - side_, cut_[1 - side_]) - from;
    const double between = angle(along, across);
    double turn =
        cut_[1 - side_] < RadiusShares::kCornerReach * radius_ ? std::max(0.0, between - limit_) : 0.0;
    const double ahead = std::max(kNearest, kAhead * cut_[side_]);
    for (int i = 0; i < kMostTurns; ++i) {
      const Vec2 heading = turned(side_, along, turn);
      const double excess = remaining_.engagement(from + heading * ahead, heading) - limit_ - kAim;
      if (excess <= 0) break;
      turn += excess;
    }
    return turn;
  }

  /// mm from the end of the cut on the first wall to the line of the second wall.
  double aside() const { return cut_[0] * base::sin(turn_); }

  /// Whether the cut along the second wall may begin on the first wall, leaving a wedge.
  bool may_end_on_first(double residual) const {
    return side_ == 0 && cusps_ == 0 && aside() <= residual - Walls::kWedge;
  }

  /// mm; thickness of what stays in the corner.
  double left() const {
    const double a = cut_[0], b = cut_[1];
    return a * b * base::sin(turn_) / std::sqrt(a * a + b * b + 2 * a * b * base::cos(turn_));
  }

  static Edge arc_along(Vec2 from, Vec2 heading, Vec2 to) {
    return distance(from, to) < kShortArc ? Edge::line(from, to) : tangent_arc(from, heading, to);
  }

  const Wall& wall_;
  RemainingStock& remaining_;
  double radius_, s_, turn_, limit_;
  int straight_;
  double cut_[2] = {};
  int side_ = 0;
  double cusps_ = 0;  ///< mm from the corner: the first wall has cusps up to there; 0: none
  /// mm from the corner: the residual in the corner touches the first wall up to there.
  double residual_before_ = 0;
  /// The last arc from each side.
  struct Crossed {
    /// Distance from the corner at its end / distance up to which that wall was cut before: less than 1.
    double gain = 0;
    double more_turn = 0;  ///< radians by which it left its wall beyond first_turn()
  } crossed_[2];
  std::size_t margin_ = 0;   ///< index into kMargins: that of the last spiral
  int spiral_arcs_[2] = {};  ///< number of arcs of the last spiral from each side; 0: none
  double back_ = -1;         ///< mm from the corner: where it last went back to the first wall
  Path path_;
};

/// mm from the corner to the first centre on a wall that touches nothing thicker than kVisited.
std::optional<double> first_visited(const Wall& wall, double s, double sign,
                                    const RemainingStock& remaining) {
  for (double x = kNearest; x < RadiusShares::kCornerReach * remaining.tool_radius(); x *= kFarther) {
    if (!remaining.touches(wall.at(s + sign * x), kVisited)) return x;
  }
  return std::nullopt;
}

}  // namespace

double arc_gain(double turn, double limit) {
  const double chord = 2 * (turn - limit) / 3;
  return base::sin(chord) / base::sin(turn - chord);
}

std::vector<Corner> corners_of(const Walls& walls, double limit) {
  std::vector<Corner> corners;
  for (std::size_t w = 0; w < walls.count(); ++w) {
    const Loop& loop = walls.wall(w).loop();
    double s = 0;
    for (std::size_t e = 0; e < loop.size(); ++e) {
      const Vec2 before = loop[(e + loop.size() - 1) % loop.size()].tangent_at(1),
                 after = loop[e].tangent_at(0);
      const double turn = angle_between(before, after);
      if (turn > limit) corners.push_back({{w, s}, turn});
      s += loop[e].length();
    }
  }
  return corners;
}

std::vector<WallPlace> places_of(const std::vector<Corner>& corners) {
  std::vector<WallPlace> places;
  for (const Corner& corner : corners) places.push_back(corner.place);
  return places;
}

std::optional<CornerRound> round_corner(const Walls& walls, const Corner& corner, double from,
                                        RemainingStock& remaining, double limit, double residual) {
  if (corner.turn > kPi - kSharpest) return std::nullopt;
  const std::size_t before = remaining.cuts();
  const Wall& wall = walls.wall(corner.place.wall);
  const double second = first_visited(wall, corner.place.s, 1, remaining)
                            .value_or(RadiusShares::kCornerReach * remaining.tool_radius());
  std::optional<CornerRound> best;
  for (int straight = 0; straight <= kMostStraight; ++straight) {
    CornerCuts corner_cuts(wall, corner, remaining, limit, straight);
    auto found = corner_cuts.cuts(from, second, residual);
    remaining.forget_beyond(before);
    if (found && (!best || found->path.size() < best->path.size())) best = std::move(found);
    if ((straight == 0 && !corner_cuts.leaves_cusps()) || (best && best->path.size() > kLong)) break;
  }
  return best;
}

std::optional<double> prepared_before(const Walls& walls, const Corner& corner,
                                      const RemainingStock& remaining) {
  return first_visited(walls.wall(corner.place.wall), corner.place.s, -1, remaining);
}

}  // namespace clearcut::plan::adaptive
