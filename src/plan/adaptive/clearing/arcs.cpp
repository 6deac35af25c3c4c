#include "plan/adaptive/clearing/arcs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::plan::adaptive {
namespace {

/// mm. Arcs with a sagitta below kFlat or a radius above kWidest are replaced by lines.
constexpr double kFlat = 1e-4;
constexpr double kWidest = 5000;
/// Radians: greatest turn of an arc.
constexpr double kMostSweep = 3;
/// Radians: two edges are joined only if their headings at the joint differ by less.
constexpr double kSameHeading = 0.008;
/// mm. An arc whose end is nearer than this to the line along its heading is a line.
constexpr double kAside = 1e-6;
/// Smallest number of points that an arc is fitted to.
constexpr std::size_t kFewest = 5;

std::optional<Vec2> circle_center(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a, v = c - a;
  const double d = 2 * cross(u, v);
  if (std::abs(d) < 1e-12) return std::nullopt;
  return a +
         Vec2{v.y * norm_squared(u) - u.y * norm_squared(v), u.x * norm_squared(v) - v.x * norm_squared(u)} /
             d;
}

/// The arc from a to c through b; a line if it is flat.
Edge edge_through(Vec2 a, Vec2 b, Vec2 c) {
  const double sagitta = std::abs(cross(unit(c - a), b - a));
  const auto center = circle_center(a, b, c);
  if (sagitta < kFlat || !center || distance(*center, a) > kWidest) return Edge::line(a, c);
  return Edge::arc(a, c, *center, cross(b - a, c - b) > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

bool is_same_heading(Vec2 a, Vec2 b) {
  return dot(a, b) > 0 && std::abs(cross(a, b)) < kSameHeading;
}

/// The edge from the first point to the last through a middle one, if all others are within `tolerance` mm of
/// it.
std::optional<Edge> fitted(std::span<const Vec2> points, double tolerance) {
  // Fewer points always lie on some arc, even if they turn a corner.
  const Edge edge = points.size() < kFewest
                        ? Edge::line(points.front(), points.back())
                        : edge_through(points.front(), points[points.size() / 2], points.back());
  if (std::abs(edge.sweep()) > kMostSweep) return std::nullopt;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (i > 0 && distance(edge, points[i]) > tolerance) return std::nullopt;
    // Also between points, so that an arc of quite another circle through the points is not taken.
    const Vec2 middle = (points[i] + points[i + 1]) / 2.0;
    if (distance(edge, middle) > 2 * tolerance + norm_squared(points[i + 1] - points[i])) return std::nullopt;
  }
  return edge;
}

}  // namespace

Edge tangent_arc(Vec2 from, Vec2 heading, Vec2 to) {
  const Vec2 chord = to - from, normal = left_of(heading);
  const double aside = dot(normal, chord);
  if (std::abs(aside) < kAside) return Edge::line(from, to);
  return Edge::arc(from, to, from + normal * (norm_squared(chord) / (2 * aside)),
                   aside > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

std::optional<Edge> joined(const Edge& first, const Edge& second, double tolerance) {
  const double sweep = first.sweep() + second.sweep();
  if (std::abs(sweep) > kMostSweep || first.is_arc() != second.is_arc() ||
      first.sweep() * second.sweep() < 0 || !is_same_heading(first.tangent_at(1), second.tangent_at(0)))
    return std::nullopt;
  const Edge whole =
      first.is_arc() ? edge_through(first.from, first.to, second.to) : Edge::line(first.from, second.to);
  if (whole.is_arc() != first.is_arc() || !is_same_heading(first.tangent_at(0), whole.tangent_at(0)) ||
      !is_same_heading(second.tangent_at(1), whole.tangent_at(1)))
    return std::nullopt;
  for (const Vec2 p : {first.at(0.5), first.to, second.at(0.5)}) {
    if (distance(whole, p) > tolerance) return std::nullopt;
  }
  return whole;
}

Path fit_arcs(std::span<const Vec2> points, double tolerance) {
  Path out;
  for (std::size_t at = 0; at + 1 < points.size();) {
    std::size_t good = 1, bad = points.size() - at;
    Edge edge = Edge::line(points[at], points[at + 1]);
    const auto try_count = [&](std::size_t count) {
      const auto found = fitted(points.subspan(at, count + 1), tolerance);
      if (found) edge = *found;
      (found ? good : bad) = count;
      return found.has_value();
    };
    for (std::size_t count = kFewest - 1; count < bad && try_count(count);)
      count = std::min(count * 2, std::max(count + 1, bad - 1));
    while (bad - good > 1) try_count(good + (bad - good) / 2);
    out.push_back(edge);
    at += good;
  }
  return out;
}

namespace {

/// Radians. Controls do not slow down in smaller turns; larger ones are no kinks.
constexpr double kLeastKink = 5e-4;
constexpr double kLargestKink = 0.3;
/// Of a move's length: what the arc at one of its ends may take.
constexpr double kTakenOfMove = 0.45;
/// mm. Shorter arcs are not made.
constexpr double kShortestEase = 5e-3;
/// Greatest number of steps until both tangents agree, and radians within which they do.
constexpr int kMostSteps = 20;
constexpr double kAgreed = 1e-10;
/// Number of tries with shorter arcs where one deviates too far, and how much shorter than in proportion each is.
constexpr int kMostShortenings = 4;
constexpr double kShortening = 0.9;
constexpr double kNoBound = 1e300;
/// Seconds that a replaced run of cuts has to save for each additional move.
constexpr double kLeastSaved = 1e-3;
/// Number of moves before and after a run of cuts that are timed with it.
constexpr std::size_t kTimedBeside = 6;

double turn_between(Vec2 u, Vec2 v) {
  return base::atan2(cross(u, v), dot(u, v));
}

/// 1 / mm, positive to the left.
double curvature_of(const Edge& edge) {
  return edge.is_arc() ? (edge.turn == Turn::kCounterClockwise ? 1 : -1) / edge.radius() : 0;
}

double turn_at_joint(const Edge& before, const Edge& after) {
  return turn_between(before.tangent_at(1), after.tangent_at(0));
}

}  // namespace

std::optional<EasedJoint> eased_joint(const Edge& before, const Edge& after, double taken) {
  const double first_length = before.length(), second_length = after.length();
  const double t = 1 - taken / first_length;
  const Vec2 from = before.at(t), heading = before.tangent_at(t);
  // How much more the chord turns off the first tangent than the second tangent turns off the chord: zero on one circle.
  const auto excess = [&](double along) {
    const Vec2 chord = unit(after.at(along / second_length) - from);
    return turn_between(heading, chord) - turn_between(chord, after.tangent_at(along / second_length));
  };
  const double turn = turn_at_joint(before, after), bends = curvature_of(after) - curvature_of(before);
  const double guess = turn * taken / (turn - bends * taken);  // where all turns are small
  if (!(guess > 0 && guess < second_length / 2)) return std::nullopt;
  double a = guess * 0.95, b = guess, f_a = excess(a), f_b = excess(b);
  for (int i = 0; i < kMostSteps && std::abs(f_b) > kAgreed; ++i) {
    if (f_a == f_b) return std::nullopt;
    const double next = b - f_b * (b - a) / (f_b - f_a);
    if (!(next > 0 && next < second_length / 2)) return std::nullopt;
    a = std::exchange(b, next);
    f_a = std::exchange(f_b, excess(b));
  }
  if (std::abs(f_b) > kAgreed || t <= 0.5) return std::nullopt;
  const double s = b / second_length;
  return EasedJoint{before.part(0, t), tangent_arc(from, heading, after.at(s)), after.part(s, 1)};
}

namespace {

class Easer {
 public:
  Easer(Pass& pass, const Deviation& deviation, const MachineClock& clock)
      : pass_(pass), deviation_(deviation), clock_(clock) {}

  std::vector<Edge> run() {
    std::vector<Edge> path;
    std::vector<MoveKind> kinds;
    const auto& all = pass_.kinds;
    for (std::size_t i = 0; i < all.size();) {
      std::size_t end = i + 1;
      while (end < all.size() && all[end] == all[i]) ++end;
      Path cuts(pass_.path.begin() + static_cast<std::ptrdiff_t>(i),
                pass_.path.begin() + static_cast<std::ptrdiff_t>(end));
      if (all[i] == MoveKind::kCut) ease_if_faster(cuts, i, end);
      kinds.insert(kinds.end(), cuts.size(), all[i]);
      path.insert(path.end(), cuts.begin(), cuts.end());
      i = end;
    }
    pass_.path = std::move(path);
    pass_.kinds = std::move(kinds);
    return std::move(changed_);
  }

 private:
  /// `cuts`: the moves of the pass from `first` to before `end`.
  void ease_if_faster(Path& cuts, std::size_t first, std::size_t end) {
    std::vector<Edge> changed;
    Path eased = with_eased_joints(cuts, changed);
    const double least = kLeastSaved * static_cast<double>(eased.size() - cuts.size());
    if (changed.empty() || timed(eased, first, end) > timed(cuts, first, end) - least) return;
    cuts = std::move(eased);
    changed_.insert(changed_.end(), changed.begin(), changed.end());
  }

  Path with_eased_joints(const Path& cuts, std::vector<Edge>& changed) const {
    Path eased{cuts.front()};
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const auto joint = ease(eased.back(), cuts[i], cuts[i - 1].length());
      if (joint) {
        changed.insert(changed.end(), {cuts[i - 1], cuts[i]});
        eased.back() = joint->before;
        eased.insert(eased.end(), {joint->arc, joint->after});
      } else {
        eased.push_back(cuts[i]);
      }
    }
    return eased;
  }

  /// `whole`: mm; the length of `before` until an arc took its beginning.
  std::optional<EasedJoint> ease(const Edge& before, const Edge& after, double whole) const {
    if (before.to != after.from) return std::nullopt;
    const double turn = std::abs(turn_at_joint(before, after));
    if (turn < kLeastKink || turn > kLargestKink) return std::nullopt;
    const bool at_wall = deviation_.legal.is_near_boundary(before.to, deviation_.most);
    const double within = at_wall ? deviation_.at_wall : deviation_.most;
    const double full = clock_.radius_at(clock_.feed.mm_per_s()) * base::tan(turn / 2);
    const double of_before = std::min({full, kTakenOfMove * whole, kTakenOfMove * before.length()}),
                 of_after = std::min(full, kTakenOfMove * after.length());
    double taken = std::min(of_before, taken_for(before, after, of_after));
    for (int i = 0; i < kMostShortenings && taken > kShortestEase / 2; ++i) {
      const auto joint = eased_joint(before, after, taken);
      if (!joint) return std::nullopt;
      const double deviation = distance(joint->arc, before.to);
      if (deviation <= within) return is_legal(joint->arc) ? joint : std::nullopt;
      taken *= kShortening * within / deviation;
    }
    return std::nullopt;
  }

  /// Length, mm, by which a rounding arc shortens `before` if it shortens `after` by `of_after` mm.
  static double taken_for(const Edge& before, const Edge& after, double of_after) {
    const double turn = turn_at_joint(before, after),
                 bends = (curvature_of(after) - curvature_of(before)) * (turn > 0 ? 1 : -1),
                 share = std::abs(turn) + bends * of_after;
    return share > 0 ? std::abs(turn) * of_after / share : kNoBound;
  }

  bool is_legal(const Edge& arc) const {
    const Vec2 middle = arc.at(0.5);
    return deviation_.legal.holds_line(arc.from, middle) && deviation_.legal.holds_line(middle, arc.to) &&
           (!arc.is_arc() || deviation_.legal.contains(middle));
  }

  /// Seconds of `cuts` in place of the moves from `first` to before `end`, with some moves beside them.
  double timed(const Path& cuts, std::size_t first, std::size_t end) const {
    const std::size_t from = first - std::min(first, kTimedBeside),
                      to = std::min(pass_.path.size(), end + kTimedBeside);
    const auto at = [](const auto& list, std::size_t i) {
      return list.begin() + static_cast<std::ptrdiff_t>(i);
    };
    Path moves(at(pass_.path, from), at(pass_.path, first));
    std::vector<MoveKind> kinds(at(pass_.kinds, from), at(pass_.kinds, first));
    moves.insert(moves.end(), cuts.begin(), cuts.end());
    kinds.insert(kinds.end(), cuts.size(), MoveKind::kCut);
    moves.insert(moves.end(), at(pass_.path, end), at(pass_.path, to));
    kinds.insert(kinds.end(), at(pass_.kinds, end), at(pass_.kinds, to));
    return clock_.seconds(moves, kinds);
  }

  Pass& pass_;
  const Deviation& deviation_;
  const MachineClock& clock_;
  std::vector<Edge> changed_;
};

}  // namespace

std::vector<Edge> ease_joints(Pass& pass, const Deviation& deviation, const MachineClock& clock) {
  if (!clock.runs() || pass.path.empty() || pass.kinds.size() != pass.path.size()) return {};
  return Easer(pass, deviation, clock).run();
}

namespace {

/// As few lines as deviate from the arc by no more than `within` mm.
Path lines_along(const Edge& arc, double within) {
  std::vector<Vec2> points{arc.from};
  append_flattened(arc, within, points);
  Path lines;
  for (std::size_t i = 1; i < points.size(); ++i) lines.push_back(Edge::line(points[i - 1], points[i]));
  return lines;
}

/// The lines in place of a wide arc, or none: at walls closer to it than elsewhere.
Path straightened(const Edge& arc, const Deviation& deviation) {
  for (const double within : {deviation.most, deviation.at_wall}) {
    Path lines = lines_along(arc, within);
    const bool fits = std::all_of(lines.begin(), lines.end(), [&](const Edge& line) {
      return deviation.legal.holds_line(line.from, line.to) &&
             (within <= deviation.at_wall || !deviation.legal.is_near_boundary(line.to, within));
    });
    if (fits) return lines;
  }
  return {};
}

}  // namespace

bool is_wide_arc(const Edge& edge) {
  return edge.is_arc() && edge.radius() > kNarrowArc &&
         std::max(std::abs(edge.center.x), std::abs(edge.center.y)) > kFarthestCenter;
}

std::vector<Edge> straighten_wide_arcs(Pass& pass, const Deviation& deviation) {
  std::vector<Edge> replaced;
  Path path;
  std::vector<MoveKind> kinds;
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    const Edge& edge = pass.path[i];
    Path lines = is_wide_arc(edge) ? straightened(edge, deviation) : Path{};
    if (!lines.empty()) replaced.push_back(edge);
    if (lines.empty()) lines.push_back(edge);
    path.insert(path.end(), lines.begin(), lines.end());
    if (!pass.kinds.empty()) kinds.insert(kinds.end(), lines.size(), pass.kinds[i]);
  }
  if (replaced.empty()) return replaced;
  pass.path = std::move(path);
  pass.kinds = std::move(kinds);
  return replaced;
}

}  // namespace clearcut::plan::adaptive
