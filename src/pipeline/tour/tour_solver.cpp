#include "pipeline/tour/tour_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stop_token>

#include "base/elementary.h"
#include "base/error.h"
#include "base/progress.h"
#include "order/genetic/genetic.h"
#include "order/search/solve.h"
#include "pipeline/tour/engagement_model.h"

namespace clearcut::pipeline {
namespace {

/// Seconds of one core for a population, and rounds, if no search time is stated.
constexpr double kTourEffort = 0.1, kBriefEffort = 0.02;
constexpr long long kTourRounds = 2;
/// Fewer points make no population.
constexpr std::size_t kFewPoints = 5;

class MachineTime final : public order::Objective {
 public:
  MachineTime(const Machine& machine, MmPerMin feed)
      : speed_(feed.mm_per_min() / 60),
        acceleration_(machine.acceleration),
        deviation_(machine.junction_deviation),
        lost_square_(lost_at(0)) {}
  std::string name() const override { return "time"; }
  std::string unit() const override { return "s"; }
  double edge(const order::Moves& moves, int a, int b) const override {
    if (!moves.has_detours()) return moves.length(a, b) / speed_;
    const auto shape = moves.shape(a, b);
    if (shape.inner_turns == 0) return shape.length / speed_;
    const double bend = Radians::of_degrees(shape.inner_angle / shape.inner_turns).radians();
    return shape.length / speed_ + shape.inner_turns * lost_at(base::cos(bend));
  }
  double corner(const order::Moves& moves, int a, int b, int c) const override {
    const auto [in, out] = moves.directions(a, b, c);
    const double along = dot(in, out);
    if (along > 0 && cross(in, out) == 0) return 0;  // most corners of grids are straight on or square
    const double lengths = norm_squared(in) * norm_squared(out);
    if (lengths == 0) return 0;
    if (along == 0) return lost_square_;
    return order::is_turn(in, out) ? lost_at(along / std::sqrt(lengths)) : 0;
  }
  Linear linear() const override { return {.length = 1 / speed_, .exact = false}; }

 private:
  /// Seconds lost in a corner, (v - v_j)^2 / (a v), from the cosine of its change of direction.
  double lost_at(double cosine) const {
    const double s = std::sqrt(std::max(0.0, (1 + cosine) / 2));
    const double junction =
        s >= 1 ? speed_ : std::min(speed_, std::sqrt(acceleration_ * deviation_ * s / (1 - s)));
    return (speed_ - junction) * (speed_ - junction) / (acceleration_ * speed_);
  }
  double speed_, acceleration_, deviation_;
  double lost_square_;  ///< in a corner of 90 degrees
};

/// Data of the plan used by a search.
struct Search {
  Objective objective;
  std::optional<double> engagement_deg;
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  int threads = 1;
  Machine machine;
  MmPerMin feed;
  std::stop_token cancel;
};

order::ObjectivePtr layer_objective(ObjectiveKind kind, const plan::tour::TourTask& task,
                                    const Search& search) {
  const EngagementTask engagement{task.points, task.path, task.layer->target, task.layer->tool_radius};
  const double target = engagement_target(search.engagement_deg);
  switch (kind) {
    case ObjectiveKind::kLength:
      return order::length_objective();
    case ObjectiveKind::kTurns:
      return order::turns_objective();
    case ObjectiveKind::kAngle:
      return order::angle_objective();
    case ObjectiveKind::kTime:
      return machine_time_objective(search.machine, search.feed);
    case ObjectiveKind::kEngagement:
      return engagement_objective(target, [=] { return raster_engagement(engagement); });
    case ObjectiveKind::kEngagementInverse:
      return engagement_objective(
          target, [=] { return raster_engagement(engagement); }, inverse_engagement_cost);
    case ObjectiveKind::kEngagementExact:
      return engagement_objective(target, [=] { return exact_engagement(engagement); });
    case ObjectiveKind::kForce:
    case ObjectiveKind::kEnergy:
    case ObjectiveKind::kWear:
    case ObjectiveKind::kClimb:
      break;
  }
  throw InputError("--objective", fmt::format("'{}' is no quantity of an order of points", name_of(kind)));
}

}  // namespace

order::ObjectivePtr objective_of(const Objective& objective, const ObjectiveMaker& make) {
  if (!objective.weighted) return make(objective.terms.front().kind);
  std::vector<std::pair<double, order::ObjectivePtr>> parts;
  for (const ObjectiveTerm& term : objective.terms) parts.emplace_back(term.weight, make(term.kind));
  return order::weighted_sum(std::move(parts));
}

order::ObjectivePtr machine_time_objective(const Machine& machine, MmPerMin feed) {
  return std::make_shared<MachineTime>(machine, feed);
}

order::Problem grid_problem(const plan::tour::TourTask& task) {
  order::Problem problem;
  problem.name = "grid";
  problem.points = task.points;
  problem.shape = order::Shape::kOpenPath;
  problem.detour = task.path;
  return problem;
}

order::GeneticResult published_order(const order::Problem& problem, const order::Objective& objective,
                                     const PublishedOrder& how) {
  if (problem.points.size() < kFewPoints) {
    order::SolveOptions exact;
    exact.stop.rounds = 1;
    order::GeneticResult few;
    const auto solution = order::solve(problem, objective, exact);
    few.tour = solution.tour;
    few.value = solution.objective;
    return few;
  }
  const PublishedSolver& published = how.solver;
  order::GeneticOptions genetic;
  genetic.seed = how.seed;
  if (published.generations) {
    genetic.stop.rounds = *published.generations;
    genetic.patience = *published.generations;
  }
  genetic.population = genetic.children = published.population.value_or(genetic.population);
  genetic.selection = published.selection.value_or(genetic.selection);
  genetic.crossover = published.crossover.value_or(genetic.crossover);
  genetic.mutation = published.mutation.value_or(genetic.mutation);
  genetic.crossover_rate = published.crossover_rate.value_or(genetic.crossover_rate);
  genetic.mutation_rate = published.mutation_rate.value_or(genetic.mutation_rate);
  genetic.most_shared = published.most_shared.value_or(genetic.most_shared);
  if (how.seconds) genetic.stop.seconds = *how.seconds;
  std::atomic<bool> stop = false;
  const std::stop_callback on_cancel(how.cancel, [&stop] { stop = true; });
  genetic.stop.cancel = &stop;
  auto result = order::run_genetic(problem, objective, genetic);
  throw_if_cancelled(how.cancel);
  return result;
}

plan::tour::TourSolver tour_solver(const ResolvedPlan& plan, const ResolvedStep& step, const Objective& order,
                                   bool briefly) {
  const Search search{order,        plan.engagement_deg, plan.search_s, plan.seed,
                      plan.threads, plan.machine,        step.feed,     plan.cancel};
  return [search, briefly, solver = step.solver](const plan::tour::TourTask& task) {
    const auto objective = objective_of(
        search.objective, [&](ObjectiveKind kind) { return layer_objective(kind, task, search); });
    if (solver.is_published)
      return published_order(grid_problem(task), *objective,
                             {solver.published, search.seed, search.seconds, search.cancel})
          .tour;
    order::SolveOptions solve;
    solve.seed = search.seed;
    solve.threads = search.threads;
    solve.stop.effort = search.seconds.value_or(briefly ? kBriefEffort : kTourEffort);
    solve.stop.seconds = search.seconds.value_or(std::numeric_limits<double>::infinity());
    if (!search.seconds) solve.stop.rounds = kTourRounds;
    std::atomic<bool> stop = false;
    const std::stop_callback on_cancel(search.cancel, [&stop] { stop = true; });
    solve.stop.cancel = &stop;
    auto tour = order::solve(grid_problem(task), *objective, solve).tour;
    throw_if_cancelled(search.cancel);
    return tour;
  };
}

}  // namespace clearcut::pipeline
