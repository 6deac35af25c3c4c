// Objectives by which orders are judged. A new objective is a class in objective.cpp with some of the three parts.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "order/moves.h"
#include "order/problem.h"

namespace clearcut::order {

/// The part of a value that depends on the whole path; stores the last evaluated path, so that a path with the same
/// beginning is evaluated from its first changed point. For one thread.
class PathValue {
 public:
  virtual ~PathValue() = default;
  virtual double of(std::span<const int> tour) = 0;
};

/// value(tour) = constant() + sum of edge(a, b) over moves + sum of corner(a, b, c) over points between two
/// moves
/// + path(tour).
/// Smaller is better. Edges and corners are the same in both directions of travel, so a reversed stretch
/// keeps its value and any exchange is priced from the few moves that the exchange touches (Tour fig. 4-19).
class Objective {
 public:
  virtual ~Objective() = default;
  virtual std::string name() const = 0;
  virtual std::string unit() const = 0;
  virtual double edge(const Moves& /*moves*/, int /*a*/, int /*b*/) const { return 0; }
  virtual double corner(const Moves& /*moves*/, int /*a*/, int /*b*/, int /*c*/) const { return 0; }
  double constant() const { return linear().constant; }
  /// Whether path() is used: such objectives are re-evaluated as a whole.
  virtual bool path_dependent() const { return false; }
  virtual double path(const Moves& /*moves*/, std::span<const int> /*tour*/) const { return 0; }
  /// The same for many paths in turn; without an own one every path is evaluated as a whole.
  virtual std::unique_ptr<PathValue> path_value(const Moves& moves) const;
  /// value >= length * l + turns * t + angle * a + constant for every tour; equal when `exact`. For lower
  /// bounds.
  struct Linear {
    double length = 0, turns = 0, angle = 0, constant = 0;
    bool exact = true;
  };
  virtual Linear linear() const = 0;
  /// Whether the objective is length only: searches made for length may then be used.
  bool is_length() const {
    const Linear l = linear();
    return l.exact && l.length > 0 && l.turns == 0 && l.angle == 0 && l.constant == 0;
  }
};

using ObjectivePtr = std::shared_ptr<const Objective>;

ObjectivePtr length_objective();
/// Number of changes of direction (bidirectional strategy, Tour 4.4.2).
ObjectivePtr turns_objective();
/// Sum of |turn angle| in degrees (spiral strategy, Tour eq. 4.16-4.20).
ObjectivePtr angle_objective();
/// Seconds: length / feed + 2 (1 + turns) tau (CPO-rho eq. 9), tau = 0.177 s.
ObjectivePtr time_objective(double feed_mm_per_min, double tau_s = 0.177);
ObjectivePtr weighted_sum(std::vector<std::pair<double, ObjectivePtr>> parts);

template <class Visit>
void each_edge(const Problem& problem, std::span<const int> tour, Visit visit) {
  for (std::size_t i = 1; i < tour.size(); ++i) visit(tour[i - 1], tour[i]);
  if (problem.closed() && tour.size() > 1) visit(tour.back(), tour.front());
}

template <class Visit>
void each_corner(const Problem& problem, std::span<const int> tour, Visit visit) {
  const std::size_t n = tour.size();
  for (std::size_t i = 2; i < n; ++i) visit(tour[i - 2], tour[i - 1], tour[i]);
  if (problem.closed() && n > 2) {
    visit(tour[n - 2], tour[n - 1], tour[0]);
    visit(tour[n - 1], tour[0], tour[1]);
  }
}

/// Values that differ by no more than this share of themselves are equal: sums are rounded.
inline constexpr double kSameValue = 1e-9;

/// The whole value from scratch.
double evaluate(const Objective& objective, const Moves& moves, std::span<const int> tour);

/// The values of many tours in turn: preparations for the whole path are made once. For one thread; objective and
/// moves must outlive it.
class Evaluator {
 public:
  Evaluator(const Objective& objective, const Moves& moves);
  double operator()(std::span<const int> tour);

 private:
  const Objective& objective_;
  const Moves& moves_;
  std::unique_ptr<PathValue> path_;  ///< null unless the objective depends on the whole path
};

/// Length, turns and angle of a tour, regardless of its objective.
struct TourFigures {
  double length = 0;
  int turns = 0;
  double angle_deg = 0;
};
TourFigures figures(const Moves& moves, std::span<const int> tour);

}  // namespace clearcut::order
