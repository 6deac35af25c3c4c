#include "verify/program/blend.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/tolerances.h"

namespace clearcut::verify {
namespace {

/// Radians. Smaller turns are due to rounding of smooth joins: the cut-off there is thousandths of a move's length.
constexpr double kSmoothTurn = 0.01;

bool may_round(const CheckedMove& checked) {
  return checked.feeds() && !checked.move->is_vertical();
}

double turn_between(const Move& before, const Move& after) {
  const Vec2 in = before.path.tangent_at(1), out = after.path.tangent_at(0);
  return std::abs(base::atan2(cross(in, out), dot(in, out)));
}

bool is_corner(const CheckedMove& before, const CheckedMove& after) {
  return may_round(before) && may_round(after) &&
         distance(before.move->path.to, after.move->path.from) < kSamePlaceMm &&
         turn_between(*before.move, *after.move) > kSmoothTurn;
}

/// The piece of a move from one point to another replacing its end: an arc keeps its curvature, because its chord
/// would cut off more than a control within the tolerance.
Edge bent(const Edge& path, Vec2 from, Vec2 to) {
  return path.is_arc() ? Edge::from_bulge(from, to, base::tan(path.sweep() / 4)) : Edge::line(from, to);
}

}  // namespace

std::optional<std::array<Move, 2>> rounded_corner(const CheckedMove& before, const CheckedMove& after,
                                                  double tolerance) {
  if (tolerance <= 0 || !is_corner(before, after)) return std::nullopt;
  const Move &a = *before.move, &b = *after.move;
  // The circle tangent to both moves that passes the corner at the tolerance, on at most half of each move.
  const double half = (kPi - turn_between(a, b)) / 2;
  const double legs = std::min(a.path.length(), b.path.length()) / 2;
  const double sine = std::max(base::sin(half), 1e-6);
  const double along = std::min(legs, tolerance * base::cos(half) / std::max(1 - sine, 1e-9));
  if (along <= kSamePlaceMm) return std::nullopt;
  const double ta = 1 - along / a.path.length(), tb = along / b.path.length();
  const Vec2 leave = a.path.at(ta), join = b.path.at(tb), corner = a.path.to;
  const Vec2 inward = (leave + join) / 2 - corner;
  if (norm(inward) <= kSamePlaceMm) return std::nullopt;
  const Vec2 inside = corner + unit(inward) * std::min(tolerance, norm(inward));
  const double za = std::lerp(a.z_from, a.z_to, ta), zb = std::lerp(b.z_from, b.z_to, tb);
  Move first = a, second = b;
  first.path = bent(a.path.part(ta, 1), leave, inside);
  first.z_from = za, first.z_to = a.z_to;
  second.path = bent(b.path.part(0, tb), inside, join);
  second.z_from = a.z_to, second.z_to = zb;
  return std::array<Move, 2>{first, second};
}

double corner_tolerance(std::span<const CheckedMove> moves) {
  double most = 0;
  for (std::size_t i = 1; i < moves.size(); ++i) {
    const double tolerance = std::max(moves[i - 1].path_tolerance, moves[i].path_tolerance);
    if (tolerance > most && is_corner(moves[i - 1], moves[i])) most = tolerance;
  }
  return most;
}

}  // namespace clearcut::verify
