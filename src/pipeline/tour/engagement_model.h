// Engagement of the cutter along a path through points: the published raster model and the exact one.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/region.h"
#include "order/objective.h"
#include "plan/tour/tour.h"

namespace clearcut::pipeline {

/// Input of the models for a tour.
struct EngagementTask {
  std::vector<Vec2> points;
  plan::tour::PathFunction way;  ///< bends between two points; empty: straight
  Regions target;                ///< material before the first move, plan view
  double radius = 0;
};

/// Stores the cuts of the last tour, so that a tour with the same beginning is run from its first changed point.
class EngagementModel {
 public:
  explicit EngagementModel(EngagementTask task) : task_(std::move(task)) {}
  virtual ~EngagementModel() = default;

  /// The share of the cutter's leading half circle in material, 0 to 1: the mean over each move of the tour
  /// (one less than points). Before the first move the cutter is in a hole of its own size.
  const std::vector<double>& along(std::span<const int> tour);
  const EngagementTask& task() const { return task_; }

 protected:
  /// Removes the area cleared by the cutter at p.
  virtual void plunge(Vec2 p) = 0;
  /// The mean over the straight pieces of one move; the move is then cut.
  virtual double cut(const std::vector<Vec2>& move) = 0;
  /// The current state, to which cuts can be undone.
  virtual std::size_t mark() const = 0;
  virtual void back_to(std::size_t mark) = 0;

 private:
  const std::vector<Vec2>& bends(int a, int b);
  std::vector<Vec2> move_points(int a, int b);

  EngagementTask task_;
  std::unordered_map<unsigned long long, std::vector<Vec2>> bends_;
  std::vector<int> last_;
  std::vector<double> engagement_;
  std::vector<std::size_t> marks_;  ///< before the plunge, then before each move
};

/// mm; side of a pixel of the raster model by Tour eq. 4.21. `accuracy`: of the circle.
double raster_pixel(double radius, double accuracy);
/// Tour eq. 4.21: pixels sized so that one of them is `accuracy` of the circle; Bresenham's circle is moved
/// along Bresenham's lines over a ternary map. Departure: the leading half of the circle is counted, not the
/// whole, so that a slot is 100 %.
std::unique_ptr<EngagementModel> raster_engagement(EngagementTask task, double accuracy = 0.02);

/// The exact contact of stock/, at steps of an eighth of the radius.
std::unique_ptr<EngagementModel> exact_engagement(EngagementTask task);

/// Target of the load: the share of the leading half circle that the requested angle is, else half of it.
double engagement_target(std::optional<double> engagement_deg);

/// Cost of a move with a mean engagement differing by `deviation` from the target: |deviation| below it,
/// exp(5 deviation) - 1 above (Tour eq. 4.22 is lost in print; its words: deviation, punished exponentially
/// above the target).
double engagement_cost(double deviation);

/// The reward of Tour eq. 4.22 as a cost: 1 / |deviation| below the target, counted from the largest value
/// distinguished by the raster model and divided by this value, so that the cost is 0 at the target and nears 1 far
/// below; above the target as engagement_cost.
double inverse_engagement_cost(double deviation);

/// Sum of `cost` of the deviation over the moves. `make` gives a fresh model for the objective's points.
order::ObjectivePtr engagement_objective(double target,
                                         std::function<std::unique_ptr<EngagementModel>()> make,
                                         double (*cost)(double) = engagement_cost);

}  // namespace clearcut::pipeline
