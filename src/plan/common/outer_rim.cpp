#include "plan/common/outer_rim.h"

#include <algorithm>
#include <vector>

namespace clearcut::plan {
namespace {

/// mm. Least depth of the places of a rim inside the area cleared by other edges: smaller depths would require
/// equally short steps of the proof.
constexpr double kLeastDepth = 2e-4;
/// Share of the radius: no edge is sought that clears a place by more than this.
constexpr double kEnoughDepth = 0.1;

/// A place at some depth inside the area cleared by an edge proves the rim over this length on both sides.
bool all_cleared(const Edge& rim, std::span<const Edge> all, double radius, double deep) {
  const double length = rim.length();
  std::vector<Edge> edges;
  const Box reach = rim.box().grown(radius + kAtRim);
  for (const Edge& edge : all)
    if (reach.overlaps(edge.box())) edges.push_back(edge);
  if (edges.empty()) return false;
  std::size_t last = 0;  // neighbouring places are mostly cleared by the same edge
  for (double s = 0; s <= length;) {
    const Vec2 place = rim.at(length > 0 ? s / length : 0);
    double depth = radius - distance(edges[last], place);
    for (std::size_t i = 0; i < edges.size() && depth < deep + kEnoughDepth * radius; ++i) {
      const double there = radius - distance(edges[i], place);
      if (there > depth) depth = there, last = i;
    }
    if (depth < deep + kLeastDepth) return false;
    s += depth - deep;
  }
  return true;
}

}  // namespace

bool clear_outer_rim(const Edge& first, const Edge& second, std::span<const Edge> edges, double radius,
                     double deep) {
  const Vec2 in = unit(first.to - first.from), out = unit(second.to - second.from), corner = first.to;
  const double side = cross(in, out) > 0 ? -1 : 1, inside = radius - kAtRim;
  const Vec2 a = left_of(in) * (side * inside), b = left_of(out) * (side * inside);
  const Edge rim[] = {
      Edge::arc(corner + a, corner + b, corner, side > 0 ? Turn::kClockwise : Turn::kCounterClockwise),
      Edge::line(first.from + a, corner + a), Edge::line(corner + b, second.to + b)};
  return std::all_of(std::begin(rim), std::end(rim),
                     [&](const Edge& piece) { return all_cleared(piece, edges, radius, deep); });
}

}  // namespace clearcut::plan
