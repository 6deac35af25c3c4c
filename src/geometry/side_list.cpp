#include "geometry/side_list.h"

#include <cmath>
#include <numeric>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"

namespace clearcut::inline geometry {
namespace {

Vec2 direction(double angle) {
  return {base::cos(angle), base::sin(angle)};
}

/// The arc that turns from `heading` by `turn`, to the left if positive.
Edge corner_arc(Vec2 from, double heading, double turn, double radius) {
  const double side = turn > 0 ? 1 : -1;
  const Vec2 center = from + direction(heading + side * kPi / 2) * radius;
  const Vec2 to = center - direction(heading + turn + side * kPi / 2) * radius;
  return Edge::arc(from, to, center, turn > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

}  // namespace

double tangent_length(const Side& corner) {
  return corner.radius * std::abs(base::tan((kPi - corner.angle) / 2));
}

double arc_length(const Side& corner) {
  return corner.radius * std::abs(kPi - corner.angle);
}

double angle_excess(const SideList& list) {
  const double sum = std::accumulate(list.sides.begin(), list.sides.end(), 0.0,
                                     [](double total, const Side& side) { return total + side.angle; });
  return sum - (static_cast<double>(list.sides.size()) - 2) * kPi;
}

Path traced(const SideList& list) {
  CLEARCUT_ASSERT(!list.sides.empty());
  Path trace;
  Vec2 at = list.start;
  double heading = list.orientation;
  for (const auto& side : list.sides) {
    const Vec2 to = at + direction(heading) * side.length;
    if (to != at) trace.push_back(Edge::line(at, to));
    at = to;
    const double turn = kPi - side.angle;
    if (side.radius > 0) {
      trace.push_back(corner_arc(at, heading, turn, side.radius));
      at = trace.back().to;
    }
    heading += turn;
  }
  return trace;
}

Vec2 closing_error(const Path& trace) {
  return trace.front().from - trace.back().to;
}

Loop closed_by_compass_rule(const Path& trace) {
  const Vec2 error = closing_error(trace);
  const double whole = length(trace);
  Loop loop;
  double before = 0;
  Vec2 at = trace.front().from;
  for (const auto& edge : trace) {
    before += edge.length();
    const bool last = &edge == &trace.back();
    const Vec2 to = last ? trace.front().from : edge.to + error * (before / whole);
    if (to != at) loop.push_back(Edge::from_bulge(at, to, edge.bulge()));
    at = to;
  }
  return loop;
}

}  // namespace clearcut::inline geometry
