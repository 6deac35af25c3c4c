// Element of an offset: an edge of the boundary or one of its vertices, with exact distances.
#pragma once

#include <optional>
#include <vector>

#include "geometry/edge.h"

namespace clearcut::inline geometry::voronoi {

/// Shape of an element seen from the material to cut, which is on the left of every boundary edge.
enum class Wall : unsigned char { kLine, kConcave, kConvex, kPoint };

struct Element {
  Wall wall = Wall::kPoint;
  Edge edge;            ///< points: edge.from and edge.center are the vertex
  double radius = 0;    ///< arcs: radius of the circle; points: 0
  int end_vertex = -1;  ///< edges: the point element at edge.to

  static Element of_edge(const Edge& edge);
  static Element of_point(Vec2 p);
  bool is_point() const { return wall == Wall::kPoint; }
  bool is_round() const { return wall != Wall::kLine; }
};

/// Distance from p, exact. mm.
double distance(const Element& element, Vec2 p);
/// Unit vector at p away from the nearest point of the element: the gradient of the distance.
Vec2 away_from(const Element& element, Vec2 p);

/// The curve at distance d from an element, unbounded: a line or a full circle.
struct OffsetCurve {
  bool straight = false;
  Vec2 point;         ///< a point of the line, or the centre
  Vec2 direction;     ///< lines
  double radius = 0;  ///< circles; negative if a concave arc has shrunk past its centre
  Turn turn = Turn::kStraight;
};
OffsetCurve offset_curve(const Element& element, double d);
/// Intersection of two offset curves nearest to `guess`; curves that pass each other within `slack` mm count as
/// tangent.
std::optional<Vec2> meeting_near(const OffsetCurve& a, const OffsetCurve& b, Vec2 guess, double slack);

/// Place equally far from two elements, of smallest or largest distance along their bisector.
struct Critical {
  Vec2 point;
  double clearance = 0;
};
/// The critical place between p and q, two places of the bisector; none if the distance is monotone there.
std::optional<Critical> critical_between(const Element& a, const Element& b, Vec2 p, Vec2 q);

}  // namespace clearcut::inline geometry::voronoi
