#include "plan/grid/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "plan/grid/interpolate.h"
#include "plan/grid/visit.h"

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

namespace {

constexpr double kMostSquares = 4e6;       // greatest number of squares of one grid
constexpr double kMostCirclePoints = 5e7;  // greatest number of points of the circle of one arc

std::string mm(double value) {
  return trimmed(value, 4) + " mm";
}

std::string place_of(const DesignElement& element) {
  return fmt::format("{} {} '{}'", element.source, name_of(element.kind), element.id);
}

/// Number of squares of the stock's grid, about.
double squares_of(const ElementJob& job) {
  const Box& plan = job.stock.plan;
  return (plan.width() / job.resolution + 1) * (plan.height() / job.resolution + 1);
}

bool fits_a_grid(const ElementJob& job) {
  return squares_of(job) <= kMostSquares;
}

/// Collects the faults of one element.
class Checker {
 public:
  Checker(const ElementJob& job, const DesignElement& element, std::vector<ElementFault>& faults)
      : job_(job), element_(element), faults_(faults) {}

  void run() {
    const std::size_t before = faults_.size();
    check_depth();
    check_size();
    const Tool* tool = tool_of(job_, element_);
    if (!tool)
      fault(fmt::format("uses tool {}, which the job does not have; add it as [[tool]]", element_.tool));
    if (!tool || faults_.size() > before) return;
    check_tool(*tool);
    if (faults_.size() > before) return;
    check_stock(*tool);
    if (faults_.size() == before && fits_a_grid(job_)) check_reduction(*tool);
  }

 private:
  void fault(std::string text) { faults_.push_back({place_of(element_), std::move(text)}); }

  void check_depth() {
    const double thickness = job_.stock.z_top - job_.stock.z_bottom;
    if (!(element_.depth > 0))
      fault(fmt::format("has depth {}; it must be above 0", trimmed(element_.depth, 4)));
    if (element_.depth > thickness + kRoundingMm)
      fault(fmt::format("is {} deep in stock of {}; make it shallower", mm(element_.depth), mm(thickness)));
  }

  void check_size() {
    const bool between_points = element_.kind == ElementKind::kLine || element_.kind == ElementKind::kArc;
    if (between_points && distance(element_.from, element_.to) < kRoundingMm)
      return fault("has length 0: both end points are the same; move one");
    if (element_.kind == ElementKind::kArc) check_arc();
    if (element_.kind == ElementKind::kRectangle && !(element_.length > 0 && element_.width > 0))
      fault(fmt::format("has length {} and width {}; both must be above 0", trimmed(element_.length, 4),
                        trimmed(element_.width, 4)));
    const bool has_width = element_.kind == ElementKind::kHole || element_.kind == ElementKind::kSlot;
    if (has_width && !(element_.width > 0))
      fault(fmt::format("is {} wide; it must be above 0", trimmed(element_.width, 4)));
  }

  void check_arc() {
    const double chord = distance(element_.from, element_.to);
    if (element_.radius < chord / 2 - kRoundingMm)
      return fault(fmt::format("has radius {}, too small for its chord of {}: at least {} is needed",
                               mm(element_.radius), mm(chord), mm(chord / 2)));
    if (2 * element_.radius / circle_step(element_.radius, job_.resolution) > kMostCirclePoints)
      fault(fmt::format("has radius {}, too large for squares of {}; make the resolution coarser",
                        mm(element_.radius), mm(job_.resolution)));
  }

  void check_tool(const Tool& tool) {
    const auto too_large = [&](const std::string& what) {
      fault(fmt::format("tool {} of radius {} is too large for {}; use a smaller one", tool.number,
                        mm(tool.radius()), what));
    };
    if (element_.kind == ElementKind::kRectangle) {
      const double shortest = std::min(element_.length, element_.width);
      if (tool.radius() >= shortest / 2 - kRoundingMm) too_large("half the side of " + mm(shortest));
    } else if (element_.kind == ElementKind::kHole || element_.kind == ElementKind::kSlot) {
      if (tool.diameter > element_.width + kRoundingMm) too_large("the width of " + mm(element_.width));
    } else if (element_.kind == ElementKind::kArc && tool.radius() >= element_.radius) {
      too_large("the arc's radius of " + mm(element_.radius));
    } else if (!core_of(element_, tool.radius())) {
      too_large(fmt::format("the {} from end to end", mm(distance(element_.from, element_.to))));
    }
    if (tool.flute_length && *tool.flute_length < element_.depth)
      fault(fmt::format("is {} deep, but tool {} cuts {} at most; use a longer one", mm(element_.depth),
                        tool.number, mm(*tool.flute_length)));
  }

  void check_stock(const Tool& tool) {
    const Box own = shape_of(element_, tool.radius()).box();
    const Box stock = job_.stock.plan.grown(kRoundingMm);
    if (stock.contains(own.min) && stock.contains(own.max)) return;
    fault(fmt::format("reaches x {}..{} y {}..{}, outside the stock x {}..{} y {}..{}; move or shrink it",
                      trimmed(own.min.x, 3), trimmed(own.max.x, 3), trimmed(own.min.y, 3),
                      trimmed(own.max.y, 3), trimmed(stock.min.x, 3), trimmed(stock.max.x, 3),
                      trimmed(stock.min.y, 3), trimmed(stock.max.y, 3)));
  }

  void check_reduction(const Tool& tool) {
    if (element_.kind != ElementKind::kRectangle) return;
    const int step = edge_step(tool.radius() / job_.resolution);
    for (const double side : {element_.length, element_.width}) {
      const int last = static_cast<int>(std::lround(side / job_.resolution));
      if (!kept_rows(0, last, step, job_.middle_row).empty()) continue;
      return fault(fmt::format(
          "no square is left of a side of {} reduced by a tool of radius {}; use a smaller tool{}", mm(side),
          mm(tool.radius()), job_.middle_row == MiddleRow::kStrict ? " or middle_row = \"keep\"" : ""));
    }
  }

  const ElementJob& job_;
  const DesignElement& element_;
  std::vector<ElementFault>& faults_;
};

void check_job(const ElementJob& job, std::vector<ElementFault>& faults) {
  if (job.elements.empty()) faults.push_back({job.source_file, "has no elements; add [[element]]"});
  std::set<int> numbers;
  for (const auto& tool : job.tools) {
    if (!numbers.insert(tool.number).second)
      faults.push_back(
          {job.source_file, fmt::format("has two tools numbered {}; give each its own number", tool.number)});
  }
  if (!fits_a_grid(job))
    faults.push_back(
        {job.source_file, fmt::format("resolution {} gives {:.3g} squares, over {:.0f}; make it coarser",
                                      mm(job.resolution), squares_of(job), kMostSquares)});
}

/// mm; distance from a point to the nearest centre of a square, the greater of both coordinates.
double off(const SquareGrid& grid, Vec2 p) {
  const Vec2 away = p - grid.center(grid.nearest(p));
  return std::max(std::abs(away.x), std::abs(away.y));
}

}  // namespace

std::vector<ElementFault> faults_of(const ElementJob& job) {
  std::vector<ElementFault> faults;
  check_job(job, faults);
  std::set<std::string> ids;
  for (const auto& element : job.elements) {
    if (!ids.insert(element.id).second)
      faults.push_back({place_of(element), "the id is used before; give each element its own"});
    Checker(job, element, faults).run();
  }
  return faults;
}

void check(const ElementJob& job) {
  const auto faults = faults_of(job);
  if (faults.empty()) return;
  std::string all;
  for (const auto& fault : faults) all += (all.empty() ? "" : "; ") + fault.place + ": " + fault.text;
  throw InputError(faults.size() == 1 ? "" : fmt::format("{} faults", faults.size()), all);
}

std::vector<ElementFault> off_grid(const ElementJob& job) {
  const SquareGrid grid = grid_of(job);
  std::vector<ElementFault> noticed;
  for (const auto& element : job.elements) {
    if (element.kind != ElementKind::kRectangle) continue;
    const Vec2 low = lower_left(element);
    const double away = std::max(off(grid, low), off(grid, low + Vec2{element.length, element.width}));
    if (away > kRoundingMm)
      noticed.push_back({place_of(element),
                         fmt::format("corners are up to {} off the squares of {}; a finer resolution helps",
                                     mm(away), mm(grid.cell))});
    const double steps = tool_of(job, element)->radius() / grid.cell;
    if (std::abs(steps - std::round(steps)) > kRoundingMm)
      noticed.push_back(
          {place_of(element),
           fmt::format(
               "the tool's radius of {} is no whole number of squares of {}: rows stay {} off the wall",
               mm(tool_of(job, element)->radius()), mm(grid.cell), mm(std::ceil(steps) * grid.cell))});
  }
  return noticed;
}

}  // namespace clearcut::plan::grid
