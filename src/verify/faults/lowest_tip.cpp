#include "verify/faults/lowest_tip.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::verify {
namespace {

/// A stretch of a move, as parameters of its path.
struct Span {
  double from = 0;
  double to = 0;
};

/// Spans of a path on which a disc of radius r contains p; at most two.
std::vector<Span> held_by_disc(const Edge& path, Vec2 p, double r) {
  std::vector<Span> spans;
  const auto add = [&](double from, double to) {
    from = std::max(from, 0.0);
    to = std::min(to, 1.0);
    if (from < to) spans.push_back({from, to});
  };
  if (!path.is_arc()) {
    const Vec2 way = path.to - path.from;
    const double all = norm(way), middle = dot(p - path.from, way) / all,
                 aside = cross(way, p - path.from) / all;
    const double half = r * r - aside * aside;
    if (half > 0) add((middle - std::sqrt(half)) / all, (middle + std::sqrt(half)) / all);
    return spans;
  }
  const double own = path.radius(), out = distance(path.center, p);
  const double cosine = (own * own + out * out - r * r) / (2 * own * out);
  if (cosine >= 1) return spans;
  const double half = cosine <= -1 ? kPi : base::acos(cosine), sweep = path.sweep();
  const double middle = angle_of(p - path.center) - angle_of(path.from - path.center);
  for (const double turn : {-2 * kPi, 0.0, 2 * kPi}) {
    const double a = (middle + turn - half) / sweep, b = (middle + turn + half) / sweep;
    add(std::min(a, b), std::max(a, b));
  }
  return spans;
}

}  // namespace

std::optional<double> lowest_tip(const CheckedMove& checked, Vec2 p) {
  const Move& move = *checked.move;
  std::optional<double> lowest;
  if (move.is_vertical()) {
    if (distance(move.path.from, p) < checked.radius()) lowest = checked.low_z();
    return lowest;
  }
  if (!move.path.box().grown(checked.radius()).contains(p)) return lowest;
  for (const Span& span : held_by_disc(move.path, p, checked.radius())) {
    const double t = move.z_to < move.z_from ? span.to : span.from;
    const double z = move.z_from + (move.z_to - move.z_from) * t;
    if (!lowest || z < *lowest) lowest = z;
  }
  return lowest;
}

}  // namespace clearcut::verify
