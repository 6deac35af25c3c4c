#include "read/dxf/dxf_spline.h"

#include <algorithm>
#include <cmath>

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

Spline read_spline(const DxfDocument& document, const DxfEntity& entity, const Affine& map) {
  Spline spline;
  spline.degree = document.integer(entity, 71, 3);
  std::vector<Vec2> points;
  std::vector<double> weights;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 40) spline.knots.push_back(document.number(group));
    if (group.code == 41) weights.push_back(document.number(group));
    if (group.code == 10) points.push_back({document.number(group), 0});
    if (group.code == 20 && !points.empty()) points.back().y = document.number(group);
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

/// Appends the part of knot span k from `from` through half of it.
void append_half_span(const Spline& spline, int k, double from, Path& path) {
  const double low = spline.knot(k), width = spline.knot(k + 1) - low;
  Path piece;
  append_fitted([&](double t) { return spline.at(k, low + width * (from + t / 2)); }, kCurveTolerance, piece);
  // Neighbouring spans agree to rounding only.
  if (!path.empty() && !piece.empty()) path.back().to = piece.front().from;
  path.insert(path.end(), piece.begin(), piece.end());
}

}  // namespace

std::optional<Path> spline_path(const DxfDocument& document, const DxfEntity& entity, const Affine& map) {
  const Spline spline = read_spline(document, entity, map);
  if (spline.poles.empty()) return std::nullopt;
  check(document, entity, spline);
  Path path;
  for (int k = spline.degree; k < static_cast<int>(spline.poles.size()); ++k) {
    if (!(spline.knot(k + 1) > spline.knot(k))) continue;
    // Halves: a single span may be a whole loop whose ends lie on each other.
    append_half_span(spline, k, 0, path);
    append_half_span(spline, k, 0.5, path);
  }
  return path;
}

}  // namespace clearcut
