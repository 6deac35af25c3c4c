#include "read/common/b_spline.h"

#include <algorithm>
#include <optional>

#include "base/text/format.h"
#include "read/common/curve_fit.h"

namespace clearcut::read {
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
