#include "plan/grid/interpolate.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/elementary.h"
#include "base/tolerances.h"

namespace clearcut::plan::grid {
namespace {

constexpr double kPaperStep = 0.001;    // mm in x; "1 micron" in the paper
constexpr double kPointsPerSquare = 3;  // number of points for each square along a line

/// Angle in [0, 2 pi) from `start` to `p` about the arc's centre, in the arc's direction.
double swept_to(const Edge& arc, Vec2 p) {
  const Vec2 a = arc.from - arc.center, b = p - arc.center;
  const double turned = base::atan2(cross(a, b), dot(a, b)) * (arc.turn == Turn::kClockwise ? -1 : 1);
  return turned < 0 ? turned + 2 * kPi : turned;
}

}  // namespace

std::vector<Vec2> interpolate_line(Vec2 from, Vec2 to, double cell) {
  const Vec2 extent = to - from;
  const double wanted = std::ceil(kPointsPerSquare * norm(extent) / cell);
  const auto count = static_cast<std::size_t>(std::max(2.0, wanted));
  const bool x_drives = std::abs(extent.x) >= std::abs(extent.y);
  const double slope = x_drives ? extent.y / extent.x : extent.x / extent.y;
  std::vector<Vec2> points;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double driven = share * (x_drives ? extent.x : extent.y);
    points.push_back(from + (x_drives ? Vec2{driven, slope * driven} : Vec2{slope * driven, driven}));
  }
  points.push_back(to);
  return points;
}

std::array<Vec2, 2> arc_centers(Vec2 from, Vec2 to, double radius) {
  const Vec2 middle = (from + to) / 2.0;
  const double half = distance(from, to) / 2;
  const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
  const Vec2 aside = left_of(unit(to - from)) * height;
  return {middle + aside, middle - aside};
}

Edge arc_of(const DesignElement& arc) {
  const auto centers = arc_centers(arc.from, arc.to, arc.radius);
  const Vec2 center = arc.direction == Turn::kCounterClockwise ? centers[0] : centers[1];
  return Edge::arc(arc.from, arc.to, center, arc.direction);
}

double circle_step(double radius, double cell) {
  // Beside x = -radius a step dx changes y by sqrt(2 radius dx).
  const double third = cell / kPointsPerSquare;
  return std::min({kPaperStep, third, third * third / (2 * radius)});
}

std::vector<Vec2> circle_at_origin(double radius, double step) {
  std::vector<Vec2> circle;
  const auto steps = static_cast<std::size_t>(std::ceil(2 * radius / step));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double x = std::min(radius, -radius + static_cast<double>(i) * step);
    circle.push_back({x, std::sqrt(std::max(0.0, radius * radius - x * x))});
  }
  for (std::size_t i = circle.size(); i-- > 0;) circle.push_back({circle[i].x, -circle[i].y});
  return circle;
}

std::vector<Vec2> interpolate_arc(const Edge& arc, double cell) {
  const double radius = arc.radius();
  const double whole = std::abs(arc.sweep());
  std::vector<std::pair<double, Vec2>> kept;
  for (const Vec2 p : circle_at_origin(radius, circle_step(radius, cell))) {
    const Vec2 shifted = p + arc.center;
    const double swept = swept_to(arc, shifted);
    if (swept <= whole) kept.push_back({swept, shifted});
  }
  std::stable_sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Vec2> points{arc.from};
  for (const auto& [swept, p] : kept) points.push_back(p);
  points.push_back(arc.to);
  return points;
}

std::vector<Square> activate(const std::vector<Vec2>& points, const SquareGrid& grid) {
  std::vector<Square> squares;
  std::set<Square> active;
  for (const Vec2 p : points) {
    const Square square = grid.nearest(p);
    if (active.insert(square).second) squares.push_back(square);
  }
  return squares;
}

std::vector<Square> activate_rectangle(const DesignElement& rectangle, const SquareGrid& grid) {
  const Square first = grid.nearest(lower_left(rectangle));
  const int columns = static_cast<int>(std::lround(rectangle.length / grid.cell));
  const int rows = static_cast<int>(std::lround(rectangle.width / grid.cell));
  std::vector<Square> squares;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column)
      squares.push_back({first.column + column, first.row + row});
  }
  return squares;
}

std::vector<Square> activate_near(Vec2 from, Vec2 to, double reach, const SquareGrid& grid) {
  Box around;
  around.add(from);
  around.add(to);
  around = around.grown(reach + grid.cell);
  const Square low = grid.nearest(around.min), high = grid.nearest(around.max);
  std::vector<Square> squares;
  for (int row = low.row; row <= high.row; ++row) {
    for (int column = low.column; column <= high.column; ++column) {
      const Vec2 p = grid.center({column, row});
      const double away = from == to ? distance(from, p) : distance(Edge::line(from, to), p);
      if (away <= reach + kRoundingMm) squares.push_back({column, row});
    }
  }
  return squares;
}

std::vector<Square> interpolate(const DesignElement& element, const SquareGrid& grid) {
  switch (element.kind) {
    case ElementKind::kLine:
      return activate(interpolate_line(element.from, element.to, grid.cell), grid);
    case ElementKind::kArc:
      return activate(interpolate_arc(arc_of(element), grid.cell), grid);
    case ElementKind::kRectangle:
      return activate_rectangle(element, grid);
    case ElementKind::kHole:
      return activate_near(element.from, element.from, element.width / 2, grid);
    case ElementKind::kSlot:
      return activate_near(element.from, element.to, element.width / 2, grid);
  }
  return {};
}

}  // namespace clearcut::plan::grid
