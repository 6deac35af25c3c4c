// A directed line segment or circular arc: the one curve the whole software is made of.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "geometry/vec2.h"

namespace clearcut::inline geometry {

enum class Turn : signed char { kClockwise = -1, kStraight = 0, kCounterClockwise = 1 };

/// From `from` to `to`, straight or along the circle about `center`.
/// An arc sweeps more than 0 and less than a full turn: a full circle is two edges. from != to.
struct Edge {
  Vec2 from;
  Vec2 to;
  Vec2 center;  ///< arcs only
  Turn turn = Turn::kStraight;

  static Edge line(Vec2 from, Vec2 to) { return {from, to, {}, Turn::kStraight}; }
  static Edge arc(Vec2 from, Vec2 to, Vec2 center, Turn turn) { return {from, to, center, turn}; }
  /// bulge = tan(included angle / 4), > 0 counter-clockwise; 0 gives a line.
  static Edge from_bulge(Vec2 from, Vec2 to, double bulge);

  bool is_arc() const { return turn != Turn::kStraight; }
  /// mm; mean of the distances of the two ends from the center (they agree to rounding).
  double radius() const;
  /// Signed swept angle in radians, > 0 counter-clockwise, in (-2 pi, 2 pi); 0 for a line.
  double sweep() const;
  double length() const;
  double bulge() const;
  /// Point at parameter t in [0, 1], proportional to arc length.
  Vec2 at(double t) const;
  /// Unit direction of travel at t.
  Vec2 tangent_at(double t) const;
  Edge reversed() const;
  /// The part between parameters t0 < t1.
  Edge part(double t0, double t1) const;
  Box box() const;
  /// Contribution to the signed area enclosed by a loop (Green): sum over a closed loop, > 0 CCW. mm2.
  double signed_area() const;

  friend bool operator==(const Edge&, const Edge&) = default;
};

/// Nearest place on an edge.
struct Nearest {
  Vec2 point;
  double distance = 0;  ///< mm
  double t = 0;         ///< parameter in [0, 1]
};
Nearest nearest(const Edge& edge, Vec2 p);
/// The parts of nearest() that need no trigonometry, for inner loops.
Vec2 nearest_point(const Edge& edge, Vec2 p);
double distance(const Edge& edge, Vec2 p);
/// Smallest distance between two edges (0 when they cross). Exact for lines and arcs. mm.
double distance(const Edge& a, const Edge& b);
/// Places at which two edges are within 1e-9 mm of each other: at most two, or the ends of shared stretches.
/// Ends of edges are returned bitwise.
std::vector<Vec2> intersections(const Edge& a, const Edge& b);
/// Winding contribution is internal; see contains() in region.h.

/// Chord points of an edge without its first point, none farther than `chord` mm from the curve
/// (number of chords by P = sweep / (2 acos((r - e) / r)), Tour eq. 4.6, rounded up; at least one a quarter
/// turn).
void append_flattened(const Edge& edge, double chord, std::vector<Vec2>& out);

/// A run of edges joined end to start.
using Path = std::vector<Edge>;
double length(const Path& path);
Path reversed(const Path& path);
/// The first `mm` of a path, or the whole path if it is no longer.
Path beginning(const Path& path, double mm);
Box box(const Path& path);

/// Lines through the points, without points that are on the line between their neighbours (within 0.001 degree)
/// or repeat the one before. Empty for fewer than two different points. Cost O(points).
Path line_path(std::span<const Vec2> points);

}  // namespace clearcut::inline geometry
