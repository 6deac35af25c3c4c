#include "plan/grid/shape.h"

#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "plan/grid/interpolate.h"

namespace clearcut::plan::grid {
namespace {

/// All points within `reach` mm of an arc of at most half a turn whose radius is greater than `reach`.
Region bent_stadium(Edge core, double reach) {
  if (core.turn == Turn::kClockwise) core = core.reversed();
  const auto beside = [&](Vec2 p, double away) {
    return core.center + unit(p - core.center) * (core.radius() + away);
  };
  const Vec2 outer_from = beside(core.from, reach), outer_to = beside(core.to, reach);
  const Vec2 inner_from = beside(core.from, -reach), inner_to = beside(core.to, -reach);
  return Region::from_valid_loops({Edge::arc(outer_from, outer_to, core.center, Turn::kCounterClockwise),
                                   Edge::arc(outer_to, inner_to, core.to, Turn::kCounterClockwise),
                                   Edge::arc(inner_to, inner_from, core.center, Turn::kClockwise),
                                   Edge::arc(inner_from, outer_from, core.from, Turn::kCounterClockwise)},
                                  {});
}

Region rectangle_region(const DesignElement& element) {
  const Vec2 low = lower_left(element);
  const Vec2 high = low + Vec2{element.length, element.width};
  const Vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

std::optional<Edge> core_of_line(const DesignElement& line, double tool_radius) {
  const double length = distance(line.from, line.to);
  if (length < 2 * tool_radius + kRoundingMm) return std::nullopt;
  const Vec2 inwards = (line.to - line.from) * (tool_radius / length);
  return Edge::line(line.from + inwards, line.to - inwards);
}

std::optional<Edge> core_of_arc(const DesignElement& element, double tool_radius) {
  const Edge arc = arc_of(element);
  const double radius = arc.radius();
  if (tool_radius >= radius) return std::nullopt;
  const double trim = 2 * base::asin(tool_radius / (2 * radius)) / std::abs(arc.sweep());
  if ((1 - 2 * trim) * arc.length() < kRoundingMm) return std::nullopt;
  return arc.part(trim, 1 - trim);
}

}  // namespace

std::optional<Edge> core_of(const DesignElement& element, double tool_radius) {
  if (element.kind == ElementKind::kLine) return core_of_line(element, tool_radius);
  if (element.kind == ElementKind::kArc) return core_of_arc(element, tool_radius);
  return std::nullopt;
}

Region stadium(Vec2 from, Vec2 to, double reach) {
  const Vec2 along = from == to ? Vec2{1, 0} : unit(to - from);
  const Vec2 aside = left_of(along) * reach;
  Loop loop;
  if (from != to) loop.push_back(Edge::line(from - aside, to - aside));
  loop.push_back(Edge::arc(to - aside, to + aside, to, Turn::kCounterClockwise));
  if (from != to) loop.push_back(Edge::line(to + aside, from + aside));
  loop.push_back(Edge::arc(from + aside, from - aside, from, Turn::kCounterClockwise));
  return Region::from_valid_loops(std::move(loop), {});
}

Region shape_of(const DesignElement& element, double tool_radius) {
  if (element.kind == ElementKind::kRectangle) return rectangle_region(element);
  if (element.kind == ElementKind::kHole) return stadium(element.from, element.from, element.width / 2);
  if (element.kind == ElementKind::kSlot) return stadium(element.from, element.to, element.width / 2);
  const auto core = core_of(element, tool_radius);
  CLEARCUT_ASSERT(core.has_value());
  return core->is_arc() ? bent_stadium(*core, tool_radius) : stadium(core->from, core->to, tool_radius);
}

Feature feature_of(const DesignElement& element, const ElementJob& job) {
  const Tool* tool = tool_of(job, element);
  CLEARCUT_ASSERT(tool != nullptr);
  Feature feature;
  feature.name = element.id;
  feature.source = element.source;
  feature.target = {shape_of(element, tool->radius())};
  feature.allowed = feature.target;
  feature.top_z = job.stock.z_top;
  feature.floor_z = job.stock.z_top - element.depth;
  feature.through = feature.floor_z <= job.stock.z_bottom;
  if (element.kind == ElementKind::kHole) feature.hole_diameter = element.width;
  return feature;
}

}  // namespace clearcut::plan::grid
