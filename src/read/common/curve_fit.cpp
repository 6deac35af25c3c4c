#include "read/common/curve_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/text.h"
#include "base/units.h"

namespace clearcut::read {
namespace {

constexpr int kMostHalvings = 14;
constexpr int kSamples = 7;
/// Part of the tolerance available to the samples: the rest is for the places between them.
constexpr double kBetweenSamples = 0.9;
/// mm. Arcs flatter than this are written as lines.
constexpr double kFlat = 1e-7;
/// mm. Coordinates beyond this are not fitted.
constexpr double kTooLarge = 1e7;

/// The arc from `from` along the unit vector `tangent` to `to`.
Edge arc_along(Vec2 from, Vec2 tangent, Vec2 to) {
  const Vec2 chord = to - from;
  const double aside = dot(chord, left_of(tangent));
  if (std::abs(aside) <= kFlat) return Edge::line(from, to);
  // tan(half the sweep / 2) by the half-angle formula: exact for flat arcs.
  const double along = dot(chord, tangent);
  const double half = base::atan2(aside, along);
  return Edge::from_bulge(from, to, base::tan(half / 2));
}

/// Direction of the curve at t, from one or both sides.
Vec2 direction(const ParametricCurve& curve, double t, double from, double to) {
  const double step = (to - from) * 1e-4;
  const double t0 = std::max(from, t - step), t1 = std::min(to, t + step);
  // One-sided at the ends: second order, from three points.
  Vec2 v = curve(t1) - curve(t0);
  if (t == from) v = curve(t + step) * 4 - curve(t + 2 * step) - curve(t) * 3;
  if (t == to) v = curve(t) * 3 - curve(t - step) * 4 + curve(t - 2 * step);
  return norm(v) > 0 ? unit(v) : Vec2{};
}

/// The joint of the two arcs of the biarc.
Vec2 biarc_joint(Vec2 p0, Vec2 t0, Vec2 p1, Vec2 t1) {
  const Vec2 v = p1 - p0, t = t0 + t1;
  const double vt = dot(v, t), spread = 2 * (1 - dot(t0, t1));
  double d = 0;
  if (spread > 1e-12) {
    d = (-vt + std::sqrt(vt * vt + spread * norm_squared(v))) / spread;
  } else if (std::abs(vt) > 0) {
    d = norm_squared(v) / (2 * vt);
  }
  return (p0 + p1 + (t0 - t1) * d) / 2.0;
}

class Fitter {
 public:
  Fitter(const ParametricCurve& curve, double tolerance, Path& out)
      : curve_(curve), tolerance_(tolerance), out_(out) {}

  void fit(double t0, double t1, int depth) {
    const Vec2 p0 = curve_(t0), p1 = curve_(t1);
    if (!(std::abs(p0.x) + std::abs(p0.y) + std::abs(p1.x) + std::abs(p1.y) < kTooLarge)) {
      return push(Edge::line(p0, p1));  // refused later; not worth 16 000 pieces
    }
    if (fits(t0, t1, Edge::line(p0, p1), Edge::line(p0, p1))) return push(Edge::line(p0, p1));
    const Vec2 u0 = direction(curve_, t0, t0, t1), u1 = direction(curve_, t1, t0, t1);
    const Vec2 joint = biarc_joint(p0, u0, p1, u1);
    const Edge first = arc_along(p0, u0, joint), second = arc_along(p1, -u1, joint).reversed();
    if (depth > 0 && fits(t0, t1, first, second)) {
      push(first);
      push(second);
      return;
    }
    if (depth >= kMostHalvings) return push(Edge::line(p0, p1));
    const double middle = (t0 + t1) / 2;
    fit(t0, middle, depth + 1);
    fit(middle, t1, depth + 1);
  }

 private:
  /// The samples avoid the middles of powers of two, so that a symmetric oscillation is not missed.
  bool fits(double t0, double t1, const Edge& first, const Edge& second) const {
    if (!near_box(first, t0, t1) || !near_box(second, t0, t1)) return false;
    for (int i = 1; i <= kSamples; ++i) {
      const Vec2 p = curve_(t0 + (t1 - t0) * i / (kSamples + 1.0));
      const double off = std::min(off_by(first, p), off_by(second, p));
      if (!(off <= kBetweenSamples * tolerance_)) return false;
    }
    return true;
  }
  static double off_by(const Edge& edge, Vec2 p) {
    return edge.from == edge.to ? distance(edge.from, p) : distance(edge, p);
  }
  /// Both edges stay near the curve too: their middles are within the samples' reach.
  bool near_box(const Edge& edge, double t0, double t1) const {
    if (edge.from == edge.to) return true;
    if (!edge.is_arc()) return true;
    Box box;
    for (int i = 0; i <= kSamples + 1; ++i) box.add(curve_(t0 + (t1 - t0) * i / (kSamples + 1.0)));
    const double slack = tolerance_ + 0.2 * (box.width() + box.height());
    const Box edges = edge.box();
    return box.grown(slack).contains(edges.min) && box.grown(slack).contains(edges.max);
  }
  void push(const Edge& edge) {
    if (edge.from != edge.to) out_.push_back(edge);
  }

  const ParametricCurve& curve_;
  const double tolerance_;
  Path& out_;
};

}  // namespace

void append_fitted(const ParametricCurve& curve, double tolerance, Path& out) {
  Fitter(curve, tolerance, out).fit(0, 1, 0);
}

void append_elliptical(const EllipticArc& arc, double tolerance, Path& out) {
  const Vec2 center = arc.center, u = arc.u, v = arc.v;
  const double start = arc.start, sweep = arc.sweep;
  const auto at = [&](double angle) { return center + u * base::cos(angle) + v * base::sin(angle); };
  const double size = norm(u) + norm(v);
  const bool circular =
      std::abs(norm(u) - norm(v)) <= 1e-9 * size && std::abs(dot(u, v)) <= 1e-9 * size * size;
  const bool full = std::abs(std::abs(sweep) - 2 * kPi) < 1e-9;
  // Quarters at most: each is a smooth piece without a second closest place, and none is a full circle.
  const int pieces =
      circular ? (full ? 2 : 1) : static_cast<int>(std::ceil(std::abs(sweep) / (kPi / 2) - 1e-9));
  const Turn turn = (sweep > 0) == (cross(u, v) > 0) ? Turn::kCounterClockwise : Turn::kClockwise;
  const Vec2 first = at(start);
  Vec2 from = first;
  for (int i = 1; i <= pieces; ++i) {
    const double begin = start + sweep * (i - 1) / pieces, step = sweep / pieces;
    const Vec2 to = full && i == pieces ? first : at(begin + step);
    if (circular) {
      if (from != to) out.push_back(Edge::arc(from, to, center, turn));
    } else {
      append_fitted([&](double t) { return t <= 0   ? from
                                           : t >= 1 ? to
                                                    : at(begin + step * t); }, tolerance,
                    out);
    }
    from = to;
  }
}

void append_mapped(const Edge& edge, const Affine& map, double tolerance, Path& out) {
  if (!edge.is_arc()) {
    const Vec2 from = map(edge.from), to = map(edge.to);
    out.push_back(Edge::line(from, to));
    return;
  }
  if (map.is_similarity()) {
    const Turn turn = map.mirrors() ? edge.reversed().turn : edge.turn;
    out.push_back(Edge::arc(map(edge.from), map(edge.to), map(edge.center), turn));
    return;
  }
  const Vec2 u = edge.from - edge.center;
  append_elliptical({map(edge.center), map.linear(u), map.linear(left_of(u)), 0, edge.sweep()}, tolerance,
                    out);
}

namespace {

constexpr int kHighestDegree = 25;
/// mm. Greatest gap between spans of one curve, due only to rounding.
constexpr double kTear = 1e-4;

double knot(const BSpline& spline, int i) {
  return spline.knots[static_cast<std::size_t>(i)];
}

/// de Boor: the point at u in knot span k (knot(k) <= u <= knot(k + 1)).
Vec2 point_at(const BSpline& spline, int k, double u) {
  const int degree = spline.degree;
  std::vector<BSpline::Pole> d(spline.poles.begin() + (k - degree), spline.poles.begin() + (k + 1));
  for (int r = 1; r <= degree; ++r) {
    for (int j = degree; j >= r; --j) {
      const double low = knot(spline, j + k - degree), high = knot(spline, j + 1 + k - r);
      const double t = high > low ? (u - low) / (high - low) : 0;
      const BSpline::Pole& a = d[static_cast<std::size_t>(j - 1)];
      BSpline::Pole& b = d[static_cast<std::size_t>(j)];
      b = {lerp(a.p, b.p, t), (1 - t) * a.w + t * b.w};
    }
  }
  return d.back().p / d.back().w;
}

/// The gap of a curve at knots coinciding more often than its degree; "" if there is none.
std::string tear_of(const BSpline& spline) {
  std::optional<Vec2> end;
  for (int k = spline.degree; k < static_cast<int>(spline.poles.size()); ++k) {
    if (knot(spline, k + 1) <= knot(spline, k)) continue;
    const Vec2 start = point_at(spline, k, knot(spline, k));
    if (end && distance(*end, start) > kTear) {
      return "a tear of " + trimmed(distance(*end, start), 4) + " mm at knot " + trimmed(knot(spline, k), 6);
    }
    end = point_at(spline, k, knot(spline, k + 1));
  }
  return "";
}

void append_joined(const ParametricCurve& curve, double tolerance, Path& out) {
  Path piece;
  append_fitted(curve, tolerance, piece);
  // Neighbouring spans agree to rounding only.
  if (!out.empty() && !piece.empty()) out.back().to = piece.front().from;
  out.insert(out.end(), piece.begin(), piece.end());
}

}  // namespace

std::string fault_of(const BSpline& spline) {
  if (spline.degree < 1 || spline.degree > kHighestDegree) return "degree " + std::to_string(spline.degree);
  const auto degree = static_cast<std::size_t>(spline.degree);
  if (spline.poles.size() <= degree || spline.knots.size() != spline.poles.size() + degree + 1) {
    return std::to_string(spline.knots.size()) + " knots for " + std::to_string(spline.poles.size()) +
           " control points of degree " + std::to_string(degree);
  }
  if (!std::is_sorted(spline.knots.begin(), spline.knots.end())) return "falling knots";
  const bool positive =
      std::all_of(spline.poles.begin(), spline.poles.end(), [](const auto& pole) { return pole.w > 0; });
  return positive ? tear_of(spline) : "a weight of 0 or less";
}

void append_span(const std::function<Vec2(double)>& curve, double tolerance, Path& out) {
  append_joined([&](double t) { return curve(t / 2); }, tolerance, out);
  append_joined([&](double t) { return curve(0.5 + t / 2); }, tolerance, out);
}

void append_spline(const BSpline& spline, double tolerance, Path& out) {
  for (int k = spline.degree; k < static_cast<int>(spline.poles.size()); ++k) {
    const double low = knot(spline, k), width = knot(spline, k + 1) - low;
    if (width > 0)
      append_span([&](double t) { return point_at(spline, k, low + width * t); }, tolerance, out);
  }
}

}  // namespace clearcut::read
