#include "geometry/region.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace clearcut::inline geometry {
namespace {

/// Side of p against the directed chord: > 0 left, < 0 right. Points on the chord are treated as by a ray towards +x
/// just above p, so that the chords and bows below count each point of the plane once.
int side_of_chord(const Edge& edge, Vec2 p) {
  const Vec2 d = edge.to - edge.from;
  const double side = cross(d, p - edge.from);
  if (side != 0) return side > 0 ? 1 : -1;
  if (d.y != 0) return d.y > 0 ? -1 : 1;
  return d.x > 0 ? 1 : -1;
}

/// Crossings of the chord by a ray from p towards +x.
int chord_winding(const Edge& edge, Vec2 p) {
  if (edge.from.y <= p.y) return edge.to.y > p.y && side_of_chord(edge, p) > 0 ? 1 : 0;
  return edge.to.y <= p.y && side_of_chord(edge, p) < 0 ? -1 : 0;
}

/// Winding of the closed curve "arc, then back along its chord": the area between the two.
int bow_winding(const Edge& arc, Vec2 p) {
  const double r2 = 0.5 * (norm_squared(arc.from - arc.center) + norm_squared(arc.to - arc.center));
  if (norm_squared(p - arc.center) >= r2) return 0;
  const int turn = static_cast<int>(arc.turn);
  return side_of_chord(arc, p) == -turn ? turn : 0;
}

Loop oriented(Loop loop, bool counter_clockwise) {
  if ((signed_area(loop) > 0) == counter_clockwise) return loop;
  return reversed(loop);
}

}  // namespace

int winding(const Edge& edge, Vec2 p) {
  return chord_winding(edge, p) + (edge.is_arc() ? bow_winding(edge, p) : 0);
}

double signed_area(const Loop& loop) {
  if (loop.empty()) return 0;
  // About a point of the loop: far from the origin the cross products would cancel.
  const Vec2 origin = loop.front().from;
  double sum = 0;
  for (const Edge& edge : loop) {
    sum += Edge{edge.from - origin, edge.to - origin, edge.center - origin, edge.turn}.signed_area();
  }
  return sum;
}

Loop loop_from_bulges(std::span<const BulgeVertex> vertices) {
  Loop loop;
  loop.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 from = vertices[i].point, to = vertices[(i + 1) % vertices.size()].point;
    if (from != to) loop.push_back(Edge::from_bulge(from, to, vertices[i].bulge));
  }
  return loop;
}

Loop loop_from_points(std::span<const Vec2> points) {
  Loop loop;
  loop.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 from = points[i], to = points[(i + 1) % points.size()];
    if (from != to) loop.push_back(Edge::line(from, to));
  }
  return loop;
}

std::vector<BulgeVertex> to_bulges(const Loop& loop) {
  std::vector<BulgeVertex> vertices;
  vertices.reserve(loop.size());
  for (const Edge& edge : loop) vertices.push_back({edge.from, edge.bulge()});
  return vertices;
}

std::vector<Vec2> flattened(const Loop& loop, double chord) {
  std::vector<Vec2> points;
  points.reserve(loop.size());
  for (const Edge& edge : loop) append_flattened(edge, chord, points);
  // Edges append their last point: turn the first edge's first point to the front.
  if (!points.empty()) std::rotate(points.begin(), points.end() - 1, points.end());
  return points;
}

bool contains(const Loop& loop, Vec2 p) {
  int sum = 0;
  for (const Edge& edge : loop) sum += winding(edge, p);
  return sum != 0;
}

Region Region::from_valid_loops(Loop outer, std::vector<Loop> islands) {
#ifndef NDEBUG
  if (const std::string fault = broken_promise(outer, islands); !fault.empty())
    throw InternalError("a region's promise is broken: " + fault);
#endif
  Region region;
  region.outer_ = oriented(std::move(outer), true);
  region.islands_.reserve(islands.size());
  for (Loop& island : islands) region.islands_.push_back(oriented(std::move(island), false));
  return region;
}

double Region::area() const {
  double sum = signed_area(outer_);
  for (const Loop& island : islands_) sum += signed_area(island);
  return sum;
}

Box Region::box() const {
  return clearcut::box(outer_);
}

bool Region::contains(Vec2 p) const {
  const auto holds = [p](const Loop& loop) { return clearcut::contains(loop, p); };
  return holds(outer_) && std::none_of(islands_.begin(), islands_.end(), holds);
}

double Region::boundary_distance(Vec2 p) const {
  double best = std::numeric_limits<double>::infinity();
  for (const Edge& edge : outer_) best = std::min(best, distance(edge, p));
  for (const Loop& island : islands_) {
    for (const Edge& edge : island) best = std::min(best, distance(edge, p));
  }
  return best;
}

std::vector<Edge> Region::edges() const {
  std::vector<Edge> all = outer_;
  for (const Loop& island : islands_) all.insert(all.end(), island.begin(), island.end());
  return all;
}

double area(const Regions& regions) {
  double sum = 0;
  for (const Region& region : regions) sum += region.area();
  return sum;
}

Region disc_about(Vec2 center, double radius) {
  const Vec2 a = center + Vec2{radius, 0}, b = center - Vec2{radius, 0};
  return Region::from_valid_loops(
      {Edge::arc(a, b, center, Turn::kCounterClockwise), Edge::arc(b, a, center, Turn::kCounterClockwise)},
      {});
}

std::vector<Edge> edges_of(const Regions& regions) {
  std::vector<Edge> edges;
  for (const Region& region : regions) {
    const std::vector<Edge> own = region.edges();
    edges.insert(edges.end(), own.begin(), own.end());
  }
  return edges;
}

std::size_t edge_count(const Regions& regions) {
  std::size_t count = 0;
  for (const Region& region : regions) count += region.edges().size();
  return count;
}

Box box(const Regions& regions) {
  Box all;
  for (const Region& region : regions) all.add(region.box());
  return all;
}

bool contains(const Regions& regions, Vec2 p) {
  return std::any_of(regions.begin(), regions.end(),
                     [p](const Region& region) { return region.contains(p); });
}

Loop rectangle(const Box& box) {
  const Vec2 corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  return loop_from_points(corners);
}

Region rectangular_region(const Box& box) {
  return Region::from_valid_loops(rectangle(box), {});
}

Region frame_around(const Box& box, double width) {
  return Region::from_valid_loops(rectangle(box.grown(width)), {rectangle(box)});
}

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

bool is_clear(const Edge& edge, Vec2 p) {
  return distance(edge, p) > kCrossing;
}

/// Whether neighbouring edges go through each other at a point away from their ends, and the piece of `a` between that point and
/// their common end `corner` does not stay near `b`.
bool cross_beside(Vec2 corner, const Edge& a, const Edge& b) {
  const double from = nearest(a, corner).t;
  const auto meetings = intersections(a, b);
  return std::any_of(meetings.begin(), meetings.end(), [&](Vec2 p) {
    const double t = nearest(a, p).t;
    const bool is_end = std::min({distance(p, a.from), distance(p, a.to), distance(p, b.from),
                                  distance(p, b.to)}) <= kCrossing;
    return !is_end && is_clear(b, a.at((t + from) / 2)) &&
           std::abs(cross(a.tangent_at(t), b.tangent_at(nearest(b, p).t))) > kTangent;
  });
}

/// Whether the edges go through each other, each with both of its ends clear of the other, or neighbours beside their common corner.
/// Edges with one common point touch if they are tangent there; edges with two common points touch if the piece between stays near.
bool go_through(const Edge& a, const Edge& b) {
  if (a.to == b.from) return cross_beside(a.to, a, b);
  if (b.to == a.from) return cross_beside(a.from, a, b);
  if (!is_clear(a, b.from) || !is_clear(a, b.to) || !is_clear(b, a.from) || !is_clear(b, a.to)) return false;
  const std::vector<Vec2> meetings = intersections(a, b);
  if (meetings.empty()) return false;
  const double t = nearest(a, meetings.front()).t, last = nearest(a, meetings.back()).t;
  if (meetings.size() > 1) return is_clear(b, a.at((t + last) / 2));
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
