#include "geometry/region_promise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace clearcut::inline geometry {
namespace {

/// mm. Loops that cross by less touch: the rounding of booleans and offsets.
constexpr double kCrossing = 1e-3;
/// Sine of the greatest angle between two edges that touch rather than cross at their only common point.
constexpr double kTangent = 1e-4;

struct Placed {
  Edge edge;
  Box box;
  std::size_t loop = 0;
  std::size_t index = 0;
};

std::string at(Vec2 p) {
  return fmt::format(" at ({:.6f}, {:.6f})", p.x, p.y);
}

std::string loop_fault(const Loop& loop, bool may_be_flat) {
  if (loop.empty()) return "a loop is empty";
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i].to != loop[(i + 1) % loop.size()].from) return "a loop is not closed" + at(loop[i].to);
  }
  return signed_area(loop) == 0 && !may_be_flat ? "a loop encloses nothing" + at(loop.front().from) : "";
}

/// Whether the edges go through each other, each with both of its ends clear of the other. Edges with one common
/// point touch if they are tangent there; edges with two common points touch if the piece between stays near.
bool go_through(const Edge& a, const Edge& b) {
  const auto clear = [](const Edge& edge, Vec2 p) { return distance(edge, p) > kCrossing; };
  if (!clear(a, b.from) || !clear(a, b.to) || !clear(b, a.from) || !clear(b, a.to)) return false;
  const std::vector<Vec2> meetings = intersections(a, b);
  if (meetings.empty()) return false;
  const double t = nearest(a, meetings.front()).t, last = nearest(a, meetings.back()).t;
  if (meetings.size() > 1) return clear(b, a.at((t + last) / 2));
  const Vec2 along_b = b.tangent_at(nearest(b, meetings.front()).t);
  return std::abs(cross(a.tangent_at(t), along_b)) > kTangent;
}

std::vector<Placed> placed(const std::vector<const Loop*>& loops) {
  std::vector<Placed> edges;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (std::size_t i = 0; i < loops[l]->size(); ++i)
      edges.push_back({(*loops[l])[i], (*loops[l])[i].box(), l, i});
  }
  std::sort(edges.begin(), edges.end(),
            [](const Placed& a, const Placed& b) { return a.box.min.x < b.box.min.x; });
  return edges;
}

std::string crossing_fault(const std::vector<const Loop*>& loops) {
  const std::vector<Placed> edges = placed(loops);
  std::vector<const Placed*> open;
  for (const Placed& edge : edges) {
    std::erase_if(open, [&](const Placed* other) { return other->box.max.x < edge.box.min.x; });
    for (const Placed* other : open) {
      if (other->box.overlaps(edge.box) && go_through(other->edge, edge.edge))
        return "two edges cross" + at(intersections(other->edge, edge.edge).front());
    }
    open.push_back(&edge);
  }
  return "";
}

/// Whether the loop is inside the other one, decided at a place of the loop well away from the other; `otherwise` if
/// they touch everywhere.
bool lies_inside(const Loop& loop, const Loop& other, bool otherwise) {
  for (const Edge& edge : loop) {
    const Vec2 p = edge.at(0.5);
    const bool touches =
        std::any_of(other.begin(), other.end(), [p](const Edge& e) { return distance(e, p) <= kCrossing; });
    if (!touches) return contains(other, p);
  }
  return otherwise;
}

std::string nesting_fault(const Loop& outer, const std::vector<Loop>& islands) {
  for (std::size_t i = 0; i < islands.size(); ++i) {
    if (!lies_inside(islands[i], outer, true)) return "an island lies outside" + at(islands[i].front().from);
    for (std::size_t k = 0; k < islands.size(); ++k) {
      if (k != i && box(islands[i]).overlaps(box(islands[k])) && lies_inside(islands[i], islands[k], false))
        return "an island lies within another" + at(islands[i].front().from);
    }
  }
  return "";
}

}  // namespace

std::string broken_promise(const Loop& outer, const std::vector<Loop>& islands) {
  std::vector<const Loop*> loops{&outer};
  for (const Loop& island : islands) loops.push_back(&island);
  for (const Loop* loop : loops) {
    if (std::string fault = loop_fault(*loop, loop != &outer); !fault.empty()) return fault;
  }
  std::string fault = crossing_fault(loops);
  return fault.empty() ? nesting_fault(outer, islands) : fault;
}

}  // namespace clearcut::inline geometry
