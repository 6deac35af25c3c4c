#include "read/dxf/dxf_spline.h"

#include <algorithm>
#include <cmath>

#include "read/dxf/fit_points.h"
#include "read/outline/curve_fit.h"

namespace clearcut {
namespace {

constexpr int kHighestDegree = 25;

/// Point times weight, and weight.
struct Homogeneous {
  Vec2 p;
  double w = 1;
};

struct Spline {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Homogeneous> poles;

  double knot(int i) const { return knots[static_cast<std::size_t>(i)]; }
  /// de Boor: the point at u in knot span k (knot(k) <= u <= knot(k + 1)).
  Vec2 at(int k, double u) const {
    std::vector<Homogeneous> d(poles.begin() + (k - degree), poles.begin() + (k + 1));
    for (int r = 1; r <= degree; ++r) {
      for (int j = degree; j >= r; --j) {
        const double low = knot(j + k - degree), high = knot(j + 1 + k - r);
        const double t = high > low ? (u - low) / (high - low) : 0;
        const Homogeneous& a = d[static_cast<std::size_t>(j - 1)];
        Homogeneous& b = d[static_cast<std::size_t>(j)];
        b = {lerp(a.p, b.p, t), (1 - t) * a.w + t * b.w};
      }
    }
    return d.back().p / d.back().w;
  }
};

void check(const DxfDocument& document, const DxfEntity& entity, const Spline& spline) {
  const auto fail = [&](const std::string& what) {
    document.fail(entity.line, "SPLINE with " + what + "; the file is damaged here");
  };
  if (spline.degree < 1 || spline.degree > kHighestDegree) fail("degree " + std::to_string(spline.degree));
  const auto degree = static_cast<std::size_t>(spline.degree);
  if (spline.poles.size() <= degree || spline.knots.size() != spline.poles.size() + degree + 1) {
    fail(std::to_string(spline.knots.size()) + " knots for " + std::to_string(spline.poles.size()) +
         " control points of degree " + std::to_string(degree));
  }
  if (!std::is_sorted(spline.knots.begin(), spline.knots.end())) fail("falling knots");
  for (const Homogeneous& pole : spline.poles) {
    if (!(pole.w > 0)) fail("a weight of 0 or less");
  }
}

/// Points of the groups x_code and x_code + 10.
std::vector<Vec2> points_of(const DxfDocument& document, const DxfEntity& entity, int x_code) {
  std::vector<Vec2> points;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == x_code) points.push_back({document.number(group), 0});
    if (group.code == x_code + 10 && !points.empty()) points.back().y = document.number(group);
  }
  return points;
}

Spline read_spline(const DxfDocument& document, const DxfEntity& entity, const Affine& map) {
  Spline spline;
  spline.degree = document.integer(entity, 71, 3);
  const std::vector<Vec2> points = points_of(document, entity, 10);
  std::vector<double> weights;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 40) spline.knots.push_back(document.number(group));
    if (group.code == 41) weights.push_back(document.number(group));
  }
  if (!weights.empty() && weights.size() != points.size()) {
    document.fail(entity.line, "SPLINE with " + std::to_string(weights.size()) + " weights for " +
                                   std::to_string(points.size()) +
                                   " control points; the file is damaged here");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = weights.empty() ? 1 : weights[i];
    spline.poles.push_back({map(points[i]) * w, w});
  }
  return spline;
}

void append_piece(const ParametricCurve& curve, Path& path) {
  Path piece;
  append_fitted(curve, kCurveTolerance, piece);
  // Neighbouring spans agree to rounding only.
  if (!path.empty() && !piece.empty()) path.back().to = piece.front().from;
  path.insert(path.end(), piece.begin(), piece.end());
}

/// In halves: a single span may be a whole loop whose ends lie on each other.
void append_span(const ParametricCurve& curve, Path& path) {
  append_piece([&](double t) { return curve(t / 2); }, path);
  append_piece([&](double t) { return curve(0.5 + t / 2); }, path);
}

std::optional<Vec2> direction_of_end(const DxfDocument& document, const DxfEntity& entity, int x_code) {
  const auto given = points_of(document, entity, x_code);
  if (given.empty() || norm(given.front()) == 0) return std::nullopt;
  return given.front();
}

/// Through fit points, where the program that drew it left out the control points that follow from them.
std::optional<Path> path_through_points(const DxfDocument& document, const DxfEntity& entity,
                                        const Affine& map) {
  constexpr int kClosed = 1;
  FitEnds ends{direction_of_end(document, entity, 12), direction_of_end(document, entity, 13)};
  ends.closed = document.integer(entity, 70, 0) & kClosed;
  Path path;
  for (const FitSpan& span : cubic_through(points_of(document, entity, 11), ends))
    append_span([&](double t) { return map(span.at(t)); }, path);
  if (path.empty()) return std::nullopt;
  return path;
}

}  // namespace

std::optional<Path> spline_path(const DxfDocument& document, const DxfEntity& entity, const Affine& map) {
  const Spline spline = read_spline(document, entity, map);
  if (spline.poles.empty()) return path_through_points(document, entity, map);
  check(document, entity, spline);
  Path path;
  for (int k = spline.degree; k < static_cast<int>(spline.poles.size()); ++k) {
    if (!(spline.knot(k + 1) > spline.knot(k))) continue;
    const double low = spline.knot(k), width = spline.knot(k + 1) - low;
    append_span([&](double t) { return spline.at(k, low + width * t); }, path);
  }
  return path;
}

}  // namespace clearcut
