#include "model/design_element.h"

#include <algorithm>
#include <cmath>

#include "base/tolerances.h"

namespace clearcut::inline model {

const char* name_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::kLine:
      return "line";
    case ElementKind::kArc:
      return "arc";
    case ElementKind::kRectangle:
      return "rectangle";
    case ElementKind::kHole:
      return "hole";
    case ElementKind::kSlot:
      return "slot";
  }
  return "element";
}

Vec2 lower_left(const DesignElement& rectangle) {
  const bool right = rectangle.base == Corner::kLowerRight || rectangle.base == Corner::kUpperRight;
  const bool upper = rectangle.base == Corner::kUpperLeft || rectangle.base == Corner::kUpperRight;
  return rectangle.from - Vec2{right ? rectangle.length : 0, upper ? rectangle.width : 0};
}

const Tool* tool_of(const ElementJob& job, const DesignElement& element) {
  return tool_numbered(job.tools, element.tool);
}

Square SquareGrid::nearest(Vec2 p) const {
  const Vec2 steps = (p - origin) / cell;
  return {static_cast<int>(std::floor(steps.x + 0.5)), static_cast<int>(std::floor(steps.y + 0.5))};
}

SquareGrid grid_of(const ElementJob& job) {
  const Box& plan = job.stock.plan;
  const auto squares = [&](double extent) {
    return static_cast<int>(std::floor(extent / job.resolution + kRoundingMm)) + 1;
  };
  return {plan.min, job.resolution, squares(plan.width()), squares(plan.height())};
}

std::size_t count_reduced(const PointTable& table) {
  return static_cast<std::size_t>(
      std::count_if(table.points.begin(), table.points.end(), [](const GridPoint& p) { return p.reduced; }));
}

}  // namespace clearcut::inline model
