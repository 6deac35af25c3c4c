// If an edge of one area runs within the gap width along an edge of the other, a patch between the two edges closes
// the gap. The patched stretch ends at the crossings of the first edge with the outline of all points within the gap
// width of the other edge.
#include "geometry/gaps/unite_over_gaps.h"

#include <algorithm>
#include <utility>

#include "geometry/contours/boolean.h"
#include "geometry/spatial/box_tree.h"

namespace clearcut::inline geometry {
namespace {

/// mm. Straight patches reach this far into both areas: more than the grid of polygon booleans.
constexpr double kOverlap = 1e-5;
/// mm. Displacement of two edges against each other by the grid of polygon booleans.
constexpr double kGrid = 2e-6;
/// Taper of a patch's sides: length along the edge over depth into the area.
constexpr double kTaper = 4;
/// mm. Areas whose edges are this near are one to polygon booleans already.
constexpr double kSame = 5e-10;

/// The edge moved to its left, or with a negative distance to its right.
Edge beside(Edge edge, double distance) {
  const Vec2 first = left_of(edge.tangent_at(0)), last = left_of(edge.tangent_at(1));
  edge.from = edge.from + first * distance;
  edge.to = edge.to + last * distance;
  return edge;
}

/// The outline of all points within `gap` of an edge, in pieces.
std::vector<Edge> outline_around(const Edge& edge, double gap) {
  std::vector<Edge> outline;
  for (const Vec2 end : {edge.from, edge.to}) {
    const Vec2 aside{gap, 0};
    outline.push_back(Edge::arc(end + aside, end - aside, end, Turn::kCounterClockwise));
    outline.push_back(Edge::arc(end - aside, end + aside, end, Turn::kCounterClockwise));
  }
  for (const double side : {gap, -gap}) {
    const Edge shifted = beside(edge, side);
    if (shifted.from != shifted.to) outline.push_back(shifted);
  }
  return outline;
}

/// Whether `other` runs back along `edge` at t, on its right hand side and no farther than the gap. Also true if the
/// two overlap by less than the grid: rounding may separate them.
bool is_across(const Edge& edge, double t, const Edge& other, double gap) {
  const Vec2 p = edge.at(t);
  const Nearest there = nearest(other, p);
  const Vec2 back = other.tangent_at(there.t);
  return there.distance > kSame && there.distance <= gap && dot(left_of(back), p - there.point) <= kGrid &&
         dot(edge.tangent_at(t), back) < 0;
}

/// Parameters along the edge at which a gap to `other` may begin or end, with 0 and 1, ascending.
std::vector<double> places_along(const Edge& edge, const Edge& other, double gap) {
  std::vector<double> places{0, 1};
  for (const Edge& limit : outline_around(other, gap)) {
    for (const Vec2 p : intersections(edge, limit)) places.push_back(nearest(edge, p).t);
  }
  for (const Vec2 p : intersections(edge, other)) places.push_back(nearest(edge, p).t);
  std::sort(places.begin(), places.end());
  return places;
}

/// Appends an edge backwards, its middle moved by `aside` to its left and its ends unchanged: areas beyond the ends
/// stay outside the patch, however acute the corner.
void append_bulged(const Edge& edge, double aside, Loop& loop) {
  const double slope = kTaper * aside / edge.length();
  const double first = std::min(slope, 0.3), last = 1 - first;
  const Edge middle = beside(edge.part(first, last), aside);
  loop.push_back(Edge::line(edge.to, middle.to));
  loop.push_back(middle.reversed());
  loop.push_back(Edge::line(middle.from, edge.from));
}

/// The area between a stretch of an edge and the antiparallel edge `other`, plus a thin strip of the areas bounded by
/// both.
Region patch(const Edge& stretch, const Edge& other, const Tolerances& tol) {
  const double overlap = stretch.is_arc() || other.is_arc() ? 1.25 * tol.chord : kOverlap;
  const double first = nearest(other, stretch.to).t, last = nearest(other, stretch.from).t;
  Loop loop;
  append_bulged(stretch, overlap, loop);
  if (last - first > kSame) {
    const Edge far = other.part(first, last);
    if (far.to != stretch.from) loop.push_back(Edge::line(stretch.from, far.to));
    append_bulged(far, overlap, loop);
  } else {
    loop.push_back(Edge::line(stretch.from, other.at(first)));
  }
  if (loop.back().to != stretch.to) loop.push_back(Edge::line(loop.back().to, stretch.to));
  return Region::from_valid_loops(std::move(loop), {});
}

void add_patches(const Edge& edge, const Edge& other, double gap, const Tolerances& tol, Regions& patches) {
  const std::vector<double> places = places_along(edge, other, gap);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double length = (places[i + 1] - places[i]) * edge.length();
    if (length <= kSame || !is_across(edge, (places[i] + places[i + 1]) / 2, other, gap)) continue;
    patches.push_back(patch(edge.part(places[i], places[i + 1]), other, tol));
  }
}

/// Patches over all gaps before the edges of `a`.
Regions patches_between(const std::vector<Edge>& a, const std::vector<Edge>& b, double gap,
                        const Tolerances& tol) {
  BoxTree tree;
  tree.build(static_cast<std::uint32_t>(b.size()), [&](std::uint32_t i) { return b[i].box(); });
  Regions patches;
  for (const Edge& edge : a) {
    const Box near = edge.box().grown(gap);
    tree.descend([&](const Box& box) { return box.overlaps(near); },
                 [&](std::uint32_t i) {
                   if (b[i].box().overlaps(near)) add_patches(edge, b[i], gap, tol, patches);
                 });
  }
  return patches;
}

}  // namespace

Regions unite_over_gaps(const Regions& a, const Regions& b, double gap, const Tolerances& tol) {
  const std::vector<Edge> edges = edges_of(a), others = edges_of(b);
  Regions patches = patches_between(edges, others, gap, tol);
  const Regions more = patches_between(others, edges, gap, tol);
  patches.insert(patches.end(), more.begin(), more.end());
  Regions all = unite(a, b, tol);
  return patches.empty() ? all : unite(all, patches, tol);
}

}  // namespace clearcut::inline geometry
