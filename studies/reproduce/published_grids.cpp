#include <algorithm>
#include <limits>
#include <numeric>

#include "studies/reproduce/published_comparisons.h"

namespace clearcut::studies {

order::Solution solved(const order::Problem& problem, const order::Objective& objective, std::uint64_t seed,
                       long long rounds) {
  order::SolveOptions options;
  options.seed = seed;
  options.stop.seconds = std::numeric_limits<double>::infinity();
  options.stop.effort = 1;
  options.stop.rounds = rounds;
  return order::solve(problem, objective, options);
}

void ask_published(const Layer& layer, double pitch_mm, const plan::tour::TourSolver& answer) {
  plan::tour::TourGridOptions grid;
  grid.published = true;
  grid.pitch = pitch_mm;
  grid.pitch_in_mm = true;
  plan::tour::plan_tour(layer, grid, answer, {});
}

bool with_largest_grid(const Layer& layer, double pitch_mm,
                       const std::function<void(const plan::tour::TourTask&)>& use) {
  const auto as_they_come = [](const plan::tour::TourTask& task) {
    std::vector<int> order(task.points.size());
    std::iota(order.begin(), order.end(), 0);
    return order;
  };
  std::size_t largest = 0;
  ask_published(layer, pitch_mm, [&](const plan::tour::TourTask& task) {
    largest = std::max(largest, task.points.size());
    return as_they_come(task);
  });
  bool is_used = false;
  ask_published(layer, pitch_mm, [&](const plan::tour::TourTask& task) {
    if (task.points.size() == largest && !is_used) use(task);
    is_used = is_used || task.points.size() == largest;
    return as_they_come(task);
  });
  return is_used;
}

}  // namespace clearcut::studies
