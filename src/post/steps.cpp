// The end point is rounded first; I and J are then chosen from the start *as last printed*, so that the radii
// at both ends agree after rounding. An arc that fails its check is halved, and at last drawn in lines.
#include "post/steps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace clearcut {

namespace {

constexpr double kSmallestRadius = 0.01;       // mm
constexpr double kSmallestSweep = kPi / 1800;  // 0.1 degree
constexpr double kLargestSweep = 1.9 * kPi;    // beyond it the ends are too near each other to tell side
constexpr double kSweepSlack = 0.2;            // radians; a larger change means the wrong way round
constexpr double kDeviationSteps = 2.0;        // grid steps
constexpr int kMostHalvings = 3;

/// An arc through the origin and `end` whose printed centre is `center`, taken as a control takes it: the
/// nearest circle through both points. In grid steps.
struct PrintedArc {
  Vec2 middle;
  double sweep = 0;
  double mismatch = 0;
};

PrintedArc printed_arc(Vec2 end, Vec2 center, double side) {
  const Vec2 normal = left_of(unit(end)) * side;
  const double half_chord = norm(end) / 2;
  const double height = dot(center - end / 2, normal);
  const double radius = std::hypot(height, half_chord);
  return {end / 2 + normal * (height - radius), 2 * std::atan2(half_chord, height),
          std::abs(norm(center) - norm(end - center))};
}

/// Best printed centre near the ideal one, if any passes the rules.
std::optional<Step> arc_step(const Edge& arc, Ticks from, Ticks to, const PrintGrid& grid) {
  if (from.same_plan(to)) return std::nullopt;
  const Vec2 start = grid.plan(from);
  const double side = arc.turn == Turn::kCounterClockwise ? 1.0 : -1.0;
  const Vec2 end{static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)};
  const Vec2 middle = (arc.at(0.5) - start) / grid.step();
  const long long i = grid.ticks(arc.center.x - start.x), j = grid.ticks(arc.center.y - start.y);
  std::optional<Step> best;
  double best_cost = kDeviationSteps;
  for (long long di = -1; di <= 1; ++di) {
    for (long long dj = -1; dj <= 1; ++dj) {
      const PrintedArc printed =
          printed_arc(end, {static_cast<double>(i + di), static_cast<double>(j + dj)}, side);
      const double cost = printed.mismatch + distance(printed.middle, middle);
      const bool right_way = std::abs(printed.sweep - std::abs(arc.sweep())) < kSweepSlack;
      if (cost >= best_cost || !right_way || printed.mismatch * grid.step() > kRadiusMismatch) continue;
      best_cost = cost;
      best = Step{to, arc.turn, i + di, j + dj};
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
  const double step = 2 * std::acos(std::max(0.0, 1 - rules.chord / radius));
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(move.path.sweep()) / step)));
  for (int k = 1; k < chords; ++k) {
    const double t = static_cast<double>(k) / chords;
    append_line(rules.grid.ticks(move.path.at(t), std::lerp(move.z_from, move.z_to, t)), at, out);
  }
  append_line(rules.grid.ticks(move.path.to, move.z_to), at, out);
}

bool wants_lines(const Edge& arc, const StepRules& rules) {
  const double radius = arc.radius();
  return !rules.arcs || radius < kSmallestRadius || radius > rules.largest_radius ||
         std::abs(arc.sweep()) < kSmallestSweep || distance(arc.from, arc.to) < kSmallestRadius;
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
    if (const auto step = arc_step(move.path, at, rules.grid.ticks(move.path.to, move.z_to), rules.grid)) {
      out.push_back(*step);
      at = step->to;
      return;
    }
  }
  if (halvings == kMostHalvings) return append_chords(move, rules, at, out);
  append_arc(half(move, 0), rules, halvings + 1, at, out);
  append_arc(half(move, 1), rules, halvings + 1, at, out);
}

}  // namespace

Ticks append_steps(const Move& move, Ticks from, const StepRules& rules, std::vector<Step>& out) {
  Ticks at = from;
  if (move.path.is_arc()) {
    append_arc(move, rules, 0, at, out);
  } else {
    append_line(rules.grid.ticks(move.path.to, move.z_to), at, out);
  }
  return at;
}

}  // namespace clearcut
