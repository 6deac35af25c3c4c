// The end point is rounded first; I and J are then chosen from the start *as last printed*, so that the radii
// at both ends agree after rounding. An arc that fails its check is halved, and finally replaced by lines.
#include "post/words/steps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::post {

namespace {

/// mm, radius and chord. LinuxCNC refuses printed radii below 0.00127, docs/claim.md below 0.002: printing takes up to kFineDeviation.
constexpr double kSmallestArc = 0.0025;
constexpr double kFewestSteps = 10;            // of the grid; least radius of arcs
constexpr double kSmallestSweep = kPi / 1800;  // 0.1 degree
constexpr double kLargestSweep =
    1.9 * kPi;                       // for greater sweeps the ends are too near to each other to determine
                                     // the side
constexpr double kSweepSlack = 0.2;  // radians; a larger change means the opposite direction
constexpr double kFineDeviation = 0.0003;  // mm; arcs printed this well are never divided
constexpr int kMostHalvings = 3;

/// mm; permitted deviation of a printed arc from the wanted one, including the mismatch of its radii.
double allowed_aside(const PrintGrid& grid) {
  return std::max(grid.step(), kFineDeviation);
}

/// An arc from the origin to `end` about the printed centre, in grid steps, as controls drive it: the radius changes
/// from that of the start to that of the end.
struct PrintedArc {
  Vec2 end;
  Vec2 center;
  double side = 1;  ///< 1 counter-clockwise, -1 clockwise

  double start_radius() const { return norm(center); }
  double end_radius() const { return norm(end - center); }
  double mismatch() const { return std::abs(start_radius() - end_radius()); }
  double angle_to(Vec2 direction) const {
    const double angle = side * base::atan2(cross(-center, direction), dot(-center, direction));
    return angle >= 0 ? angle : angle + 2 * kPi;
  }
  double sweep() const { return angle_to(end - center); }

  /// Largest distance from the circle about `c` of radius `r`. The distance varies with the direction like the offset
  /// of the centres: its extremes are along that offset, or at the ends.
  double deviation(Vec2 c, double r) const {
    double largest = std::max(std::abs(norm(c) - r), std::abs(distance(end, c) - r));
    const Vec2 offset = center - c;
    const double shift = norm(offset), last = sweep();
    for (const double own : {start_radius(), end_radius()}) {
      if (shift > 0 && angle_to(offset) <= last) largest = std::max(largest, std::abs(own - r + shift));
      if (shift > 0 && angle_to(-offset) <= last) largest = std::max(largest, std::abs(own - r - shift));
    }
    return largest;
  }
};

/// Among the printed centres around the ideal one that fulfil the rules, the one with the best agreement of radii,
/// of the arcs and of the centres together; there may be none.
std::optional<Step> arc_step(const Edge& arc, Ticks from, Ticks to, const StepRules& rules) {
  const PrintGrid& grid = rules.grid;
  if (from.same_plan(to)) return std::nullopt;
  const Vec2 start = grid.plan(from);
  const double side = arc.turn == Turn::kCounterClockwise ? 1.0 : -1.0;
  const Vec2 end{static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)};
  const Vec2 center = (arc.center - start) / grid.step();
  const double radius = arc.radius() / grid.step(), sweep = std::abs(arc.sweep());
  const double allowed = allowed_aside(grid) / grid.step();
  std::optional<Step> best;
  double best_cost = HUGE_VAL;
  for (const double di : {-1.0, 0.0, 1.0}) {
    for (const double dj : {-1.0, 0.0, 1.0}) {
      const Vec2 tried{std::round(center.x) + di, std::round(center.y) + dj};
      const PrintedArc printed{end, tried, side};
      const double deviation = printed.deviation(center, radius);
      const double cost = printed.mismatch() + deviation + distance(tried, center);
      if (cost >= best_cost || deviation + printed.mismatch() > allowed) continue;
      if (printed.mismatch() * grid.step() > rules.radius_mismatch) continue;
      if (std::abs(printed.sweep() - sweep) > kSweepSlack) continue;  // opposite direction
      best_cost = cost;
      best = Step{to, arc.turn, std::llround(tried.x), std::llround(tried.y)};
    }
  }
  return best;
}

void append_line(Ticks to, Ticks& at, std::vector<Step>& out) {
  if (to == at) return;
  out.push_back({to, Turn::kStraight, 0, 0});
  at = to;
}

void append_chords(const Move& move, const StepRules& rules, Ticks& at, std::vector<Step>& out) {
  const double radius = move.path.radius();
  const double step = 2 * base::acos(std::max(0.0, 1 - rules.chord / radius));
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(move.path.sweep()) / step)));
  for (int k = 1; k < chords; ++k) {
    const double t = static_cast<double>(k) / chords;
    append_line(rules.grid.ticks(move.path.at(t), std::lerp(move.z_from, move.z_to, t)), at, out);
  }
  append_line(rules.grid.ticks(move.path.to, move.z_to), at, out);
}

bool wants_lines(const Edge& arc, const StepRules& rules) {
  const double radius = arc.radius(), smallest = std::max(kSmallestArc, kFewestSteps * rules.grid.step());
  return !rules.arcs || radius < smallest || radius > rules.largest_radius ||
         std::abs(arc.sweep()) < kSmallestSweep || distance(arc.from, arc.to) < smallest;
}

Move half(const Move& move, int which) {
  Move piece = move;
  piece.path = which == 0 ? move.path.part(0, 0.5) : move.path.part(0.5, 1);
  const double middle = std::lerp(move.z_from, move.z_to, 0.5);
  (which == 0 ? piece.z_to : piece.z_from) = middle;
  return piece;
}

void append_arc(const Move& move, const StepRules& rules, int halvings, Ticks& at, std::vector<Step>& out) {
  const bool nearly_round = std::abs(move.path.sweep()) > kLargestSweep;
  if (!nearly_round && wants_lines(move.path, rules)) return append_chords(move, rules, at, out);
  if (!nearly_round) {
    if (const auto step = arc_step(move.path, at, rules.grid.ticks(move.path.to, move.z_to), rules)) {
      out.push_back(*step);
      at = step->to;
      return;
    }
  }
  if (halvings == kMostHalvings) return append_chords(move, rules, at, out);
  append_arc(half(move, 0), rules, halvings + 1, at, out);
  append_arc(half(move, 1), rules, halvings + 1, at, out);
}

/// The smallest whole steps in the direction from `a` to `b`; none if they are the same place.
Ticks direction_between(const Ticks& a, const Ticks& b) {
  const Ticks way{b.x - a.x, b.y - a.y, b.z - a.z};
  const long long share = std::gcd(std::gcd(way.x, way.y), way.z);
  return share == 0 ? way : Ticks{way.x / share, way.y / share, way.z / share};
}

bool goes_on(const Move& before, const Move& after, const PrintGrid& grid) {
  if (before.path.is_arc() || after.path.is_arc()) return false;
  if (is_rapid(before.kind) != is_rapid(after.kind) || before.feed != after.feed) return false;
  const Ticks joint = grid.ticks(before.path.to, before.z_to);
  const Ticks way = direction_between(grid.ticks(before.path.from, before.z_from), joint);
  if (way == Ticks{} || way != direction_between(joint, grid.ticks(after.path.to, after.z_to))) return false;
  return !is_rapid(before.kind) || way.z == 0 || way.same_plan({});
}

}  // namespace

double largest_deviation(const PrintGrid& grid) {
  return base::hypot(allowed_aside(grid), grid.step() * std::sqrt(0.5));
}

/// Controls check an arc's radii in their own unit: 0.002 mm or 0.0002 inch.
StepRules step_rules(const PostOptions& options, int decimals, double largest_radius) {
  return {.grid = PrintGrid(options.inch, decimals),
          .arcs = options.arcs,
          .largest_radius = largest_radius,
          .chord = options.tol.chord,
          .radius_mismatch = options.inch ? 0.0002 * kMmPerInch : 0.002};
}

Ticks append_steps(const Move& move, Ticks from, const StepRules& rules, std::vector<Step>& out) {
  Ticks at = from;
  if (move.path.is_arc()) {
    append_arc(move, rules, 0, at, out);
  } else {
    append_line(rules.grid.ticks(move.path.to, move.z_to), at, out);
  }
  return at;
}

std::vector<Move> with_lines_joined(std::span<const Move> moves, const PrintGrid& grid) {
  std::vector<Move> joined;
  joined.reserve(moves.size());
  for (const Move& move : moves) {
    if (joined.empty() || !goes_on(joined.back(), move, grid)) {
      joined.push_back(move);
      continue;
    }
    Move& before = joined.back();
    before.path = Edge::line(before.path.from, move.path.to);
    before.z_to = move.z_to;
  }
  return joined;
}

}  // namespace clearcut::post
