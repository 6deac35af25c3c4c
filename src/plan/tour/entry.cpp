#include "plan/common/layers.h"
#include "plan/tour/tour.h"

namespace clearcut::plan::tour {
namespace {

/// Greatest number of grid points for trying a tour.
constexpr double kMostPoints = 1000;

bool is_small_enough(const ClearedSize& size, double radius) {
  const double pitch = TourGridOptions{}.pitch * 2 * radius;
  return size.reached_mm2 / (pitch * pitch) <= kMostPoints;
}

}  // namespace

StrategyEntry entry(std::function<TourSolver(const StrategyRequest&)> solver_for) {
  StrategyEntry entry;
  entry.name = "tour";
  entry.description = "a grid of places in the order a search finds best, then along the walls";
  entry.make = [solver_for = std::move(solver_for)](const StrategyRequest& request) {
    auto grid = request.stepover.is_given() ? parse_tour_grid(request.stepover.text) : TourGridOptions{};
    if (request.step.published_grid) {
      grid.published = true;
      if (!request.stepover.is_given())
        grid.pitch = 1;  // one diameter, as published (Tour 4.2.4), if no stepover is given
    }
    return once_per_outline([grid, solve = solver_for(request), tol = request.plan.tol](const Layer& layer) {
      return plan_tour(layer, grid, solve, tol);
    });
  };
  entry.keeps_direction = false;
  entry.in_auto = AutoUse::kBriefly;
  entry.tried_when_open = true;
  entry.margin = 1.35;  // factor on its least time; in 120 random pockets tours took 1.37 to 3 times as long
  entry.is_small_enough = is_small_enough;
  entry.orders = {ObjectiveKind::kTime, ObjectiveKind::kLength, ObjectiveKind::kTurns, ObjectiveKind::kAngle,
                  ObjectiveKind::kEngagement};
  return entry;
}

}  // namespace clearcut::plan::tour
