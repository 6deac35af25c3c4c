// The points to be ordered, joined by straight moves if those are legal.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::order {

/// Indices of points in visiting order. A closed tour returns from the last to the first.
using Tour = std::vector<int>;

enum class Metric {
  kEuclidean,     ///< real distances
  kRoundedEuc2d,  ///< TSPLIB EUC_2D: floor(distance + 0.5)
};

enum class Shape { kClosedTour, kOpenPath };

/// Points strictly between `from` and `to` on the shortest legal path; empty if the straight move is legal.
/// Symmetric: (to, from) gives the same points backwards. May be called from several threads at once; the searches
/// store the results. An illegal edge costs its legal detour, so every order is legal.
using DetourFunction = std::function<std::vector<Vec2>(int from, int to)>;

/// `before` is visited earlier than `after`; for open paths.
struct Precedence {
  int before = 0;
  int after = 0;
};

struct Problem {
  std::string name;
  std::vector<Vec2> points;
  Metric metric = Metric::kEuclidean;
  Shape shape = Shape::kClosedTour;
  int start = -1;                      ///< first point of an open path; -1: free
  int end = -1;                        ///< last point of an open path; -1: free
  std::vector<Precedence> precedence;  ///< open paths only
  DetourFunction detour;               ///< empty: every straight move is legal
  int neighbour_count = 24;            ///< candidate neighbours of a point (Tour 4.3.2: two rings of a grid)

  int size() const { return static_cast<int>(points.size()); }
  bool closed() const { return shape == Shape::kClosedTour; }
};

/// Throws InputError if the problem contradicts itself: no points, coordinates that are not finite, ends
/// out of range or equal, ends or precedence on a closed tour, cyclic precedence, precedence against a fixed
/// end.
void check(const Problem& problem);

/// Length of the straight move in the problem's metric.
double straight_distance(const Problem& problem, int a, int b);
/// Length of the move from a to b, by its legal detour if the straight move is illegal.
double move_length(const Problem& problem, int a, int b);
/// Length of a path through `points` in the problem's metric (rounded once, as a whole).
double way_length(const Problem& problem, std::span<const Vec2> points);
/// Points of the move from a to b, both ends included.
std::vector<Vec2> move_points(const Problem& problem, int a, int b);
double tour_length(const Problem& problem, std::span<const int> tour);

/// Each point once, ends and precedence kept.
bool is_valid(const Problem& problem, std::span<const int> tour);

/// An order obeying `problem.precedence` (free points by index), start first and end last.
/// Throws InputError for cyclic precedence.
Tour topological_order(const Problem& problem);

/// The same closed tour beginning at point 0 towards the smaller of its neighbours; an open path with free
/// ends begins at the end of smaller index. Two tours are the same walk exactly when their canonical forms
/// are equal.
Tour canonical(const Problem& problem, Tour tour);

}  // namespace clearcut::order
