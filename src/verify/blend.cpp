#include "verify/blend.h"

#include <algorithm>
#include <cmath>

namespace clearcut::verify {
namespace {

/// Radians. Smaller turns come from rounding of smooth joins: what is cut off there is thousandths of a
/// move's length.
constexpr double kSmoothTurn = 0.01;
/// mm. Points nearer than this are equal.
constexpr double kSamePlace = 1e-6;

bool may_round(const JudgedMove& judged) {
  return judged.feeds() && !judged.move->is_vertical();
}

double turn_between(const Move& before, const Move& after) {
  const Vec2 in = before.path.tangent_at(1), out = after.path.tangent_at(0);
  return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

bool is_corner(const JudgedMove& before, const JudgedMove& after) {
  return may_round(before) && may_round(after) &&
         distance(before.move->path.to, after.move->path.from) < kSamePlace &&
         turn_between(*before.move, *after.move) > kSmoothTurn;
}

/// mm. How far along a move from the corner a straight line leaves its path by no more than half of the tolerance.
double straight_along(const Edge& path, double tolerance) {
  return path.is_arc() ? 2 * std::sqrt(path.radius() * tolerance) : path.length();
}

}  // namespace

std::optional<std::array<Move, 2>> rounded_corner(const JudgedMove& before, const JudgedMove& after,
                                                  double tolerance) {
  if (tolerance <= 0 || !is_corner(before, after)) return std::nullopt;
  const Move &a = *before.move, &b = *after.move;
  // The circle that touches both moves and passes the corner at the tolerance. It takes at most half of a move. On arcs the
  // two lines that stand for it start so near that no point of them is farther from the path than the control may go.
  const double half = (kPi - turn_between(a, b)) / 2;
  const double legs = std::min(a.path.length(), b.path.length()) / 2;
  const double sine = std::max(std::sin(half), 1e-6);
  const double straight = std::min(straight_along(a.path, tolerance), straight_along(b.path, tolerance));
  const double along = std::min({legs, straight, tolerance * std::cos(half) / std::max(1 - sine, 1e-9)});
  if (along <= kSamePlace) return std::nullopt;
  const double ta = 1 - along / a.path.length(), tb = along / b.path.length();
  const Vec2 leave = a.path.at(ta), join = b.path.at(tb), corner = a.path.to;
  const Vec2 inward = (leave + join) / 2 - corner;
  if (norm(inward) <= kSamePlace) return std::nullopt;
  const Vec2 inside = corner + unit(inward) * std::min(tolerance, norm(inward));
  const double za = std::lerp(a.z_from, a.z_to, ta), zb = std::lerp(b.z_from, b.z_to, tb);
  Move first = a, second = b;
  first.path = Edge::line(leave, inside);
  first.z_from = za, first.z_to = a.z_to;
  second.path = Edge::line(inside, join);
  second.z_from = a.z_to, second.z_to = zb;
  return std::array<Move, 2>{first, second};
}

double corner_tolerance(std::span<const JudgedMove> moves) {
  double most = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const double tolerance = std::max(moves[i - 1].path_tolerance, moves[i].path_tolerance);
    if (tolerance > most && is_corner(moves[i - 1], moves[i])) most = tolerance;
  }
  return most;
}

}  // namespace clearcut::verify
