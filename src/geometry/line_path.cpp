#include "geometry/line_path.h"

namespace clearcut::inline geometry {
namespace {

/// 1 - cosine of the largest change of direction between lines that are drawn as one (0.001 degree).
constexpr double kCollinear = 1.5e-10;

}  // namespace

Path line_path(std::span<const Vec2> points) {
  Path path;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] == points[i - 1]) continue;
    const Edge edge = Edge::line(points[i - 1], points[i]);
    if (!path.empty() && dot(path.back().tangent_at(1), edge.tangent_at(0)) > 1 - kCollinear) {
      path.back().to = edge.to;
    } else {
      path.push_back(edge);
    }
  }
  return path;
}

}  // namespace clearcut::inline geometry
