// Closed loops, the regions they bound, and what every region guarantees.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "geometry/box.h"
#include "geometry/edge.h"

namespace clearcut::inline geometry {

/// A closed run of edges: each ends exactly where the next begins, the last where the first begins.
using Loop = std::vector<Edge>;

/// Signed area in mm2, > 0 for counter-clockwise loops.
double signed_area(const Loop& loop);
/// Loop from vertices with bulges: (x, y, bulge) of the edge that leaves each vertex.
struct BulgeVertex {
  Vec2 point;
  double bulge = 0;
};
Loop loop_from_bulges(std::span<const BulgeVertex> vertices);
Loop loop_from_points(std::span<const Vec2> points);
std::vector<BulgeVertex> to_bulges(const Loop& loop);
/// Polygon of a loop, without repeating the first point; see append_flattened.
std::vector<Vec2> flattened(const Loop& loop, double chord);
/// Contribution of one edge to the winding number around p, to be summed over the edges of closed loops. Zero for
/// edges wholly above, wholly below (bows included) or wholly left of p, so that an index may skip them.
int winding(const Edge& edge, Vec2 p);
/// Non-zero winding, exact for arcs; points on the boundary (within 1e-12 relative) may give either result.
bool contains(const Loop& loop, Vec2 p);

/// One connected area: closed, oriented (outer counter-clockwise, islands clockwise, so the material to cut is on the
/// left of every edge), free of crossings, islands inside the outer loop. Islands may touch each other or the outer
/// loop in points. Valid by construction: no later stage checks again.
class Region {
 public:
  /// Orients the loops. The caller promises the rest; readers get their regions from read/outline repair,
  /// booleans and offsets from geometry/.
  static Region from_valid_loops(Loop outer, std::vector<Loop> islands);

  const Loop& outer() const { return outer_; }
  const std::vector<Loop>& islands() const { return islands_; }
  double area() const;  ///< mm2
  Box box() const;
  bool contains(Vec2 p) const;
  /// Distance from p to the nearest boundary edge, >= 0 (not signed). O(edges).
  double boundary_distance(Vec2 p) const;
  /// All edges, outer first.
  std::vector<Edge> edges() const;

 private:
  Loop outer_;
  std::vector<Loop> islands_;
};

Region disc_about(Vec2 center, double radius);

/// Regions with disjoint interiors.
using Regions = std::vector<Region>;
double area(const Regions& regions);
/// Edges of all regions, one after the other.
std::vector<Edge> edges_of(const Regions& regions);
std::size_t edge_count(const Regions& regions);
Box box(const Regions& regions);
bool contains(const Regions& regions, Vec2 p);

/// The outline of a box that is not empty, counter-clockwise from its lowest corner.
Loop rectangle(const Box& box);

/// All of a box whose sides are longer than 0.
Region rectangular_region(const Box& box);

/// The frame around a box, `width` (mm, > 0) wide on all sides.
Region frame_around(const Box& box, double width);

/// "" if the loops, in either direction, make a valid region: closed, the outer one around an area, without
/// crossings, islands inside the outer loop and beside each other. An island may be a wall of no thickness: a line
/// and back. Else a text with the fault and its place. Loops that cross by less than 1 um touch. Cost O(n log n) for
/// edges that are short against the whole.
std::string broken_promise(const Loop& outer, const std::vector<Loop>& islands);

}  // namespace clearcut::inline geometry
