#include "pipeline/tour_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/format.h"
#include "order/genetic/genetic.h"
#include "order/solve.h"
#include "pipeline/engagement_model.h"

namespace clearcut::pipeline {
namespace {

/// Seconds of one core for a population, and rounds, where nobody says how long to search.
constexpr double kEffort = 0.1, kBriefEffort = 0.02;
constexpr long long kRounds = 2;
/// Tour 4.3.3: "1000 generations without any improvement".
constexpr long long kPublishedPatience = 1000;
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
    return shape.length / speed_ + shape.inner_turns * lost_at(std::cos(bend));
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

double weight_of(const std::string& text) {
  double weight = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), weight);
  if (error != std::errc() || end != text.data() + text.size() || !(weight >= 0)) {
    throw InputError("--objective", fmt::format("'{}' is no weight of 0 or more", text));
  }
  return weight;
}

/// Share of the leading half circle; of the angle asked for, else half.
double engagement_target(const resolve::PlanOptions& options) {
  return options.engagement_deg ? *options.engagement_deg / 180 : 0.5;
}

order::ObjectivePtr layer_objective(const std::string& name, const plan::tour::TourTask& task,
                                    const resolve::PlanOptions& options, MmPerMin feed) {
  const EngagementTask engagement{task.points, task.way, task.layer->target, task.layer->tool_radius};
  if (name == "length") return order::length_objective();
  if (name == "turns") return order::turns_objective();
  if (name == "angle") return order::angle_objective();
  if (name == "time") return machine_time_objective(options.machine, feed);
  if (name == "engagement")
    return engagement_objective(engagement_target(options), [=] { return raster_engagement(engagement); });
  if (name == "engagement-exact")
    return engagement_objective(engagement_target(options), [=] { return exact_engagement(engagement); });
  throw InputError("--objective", fmt::format("'{}' is unknown; use length, turns, angle, engagement, "
                                              "engagement-exact, time, or weights such as 1:length,20:turns",
                                              name));
}

}  // namespace

order::ObjectivePtr objective_from(const std::string& text, const ObjectiveMaker& make) {
  if (text.find(':') == std::string::npos) return make(text);
  std::vector<std::pair<double, order::ObjectivePtr>> parts;
  for (const std::string& part : split(text, ',')) {
    const auto colon = part.find(':');
    if (colon == std::string::npos)
      throw InputError("--objective", fmt::format("'{}' lacks its weight", part));
    parts.emplace_back(weight_of(part.substr(0, colon)), make(part.substr(colon + 1)));
  }
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
  problem.detour = task.way;
  return problem;
}

order::Tour published_order(const order::Problem& problem, const order::Objective& objective,
                            const resolve::PlanOptions& options) {
  if (problem.points.size() < kFewPoints) {
    order::SolveOptions exact;
    exact.stop.rounds = 1;
    return order::solve(problem, objective, exact).tour;
  }
  const resolve::PublishedSolver published = options.published_solver.value_or(resolve::PublishedSolver{});
  order::GeneticOptions genetic;
  genetic.patience = kPublishedPatience;
  genetic.seed = options.seed;
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
  if (options.time_s) genetic.stop.seconds = *options.time_s;
  std::atomic<bool> stop = false;
  const std::stop_callback on_cancel(options.cancel, [&stop] { stop = true; });
  genetic.stop.cancel = &stop;
  auto tour = order::run_genetic(problem, objective, genetic).tour;
  throw_if_cancelled(options.cancel);
  return tour;
}

plan::tour::TourSolver tour_solver(const resolve::PlanOptions& options, MmPerMin feed, bool briefly) {
  return [options, feed, briefly](const plan::tour::TourTask& task) {
    const auto objective = objective_from(options.objective, [&](const std::string& name) {
      return layer_objective(name, task, options, feed);
    });
    if (options.published_solver) return published_order(grid_problem(task), *objective, options);
    order::SolveOptions solve;
    solve.seed = options.seed;
    solve.threads = options.threads;
    solve.stop.effort = options.time_s.value_or(briefly ? kBriefEffort : kEffort);
    solve.stop.seconds = options.time_s.value_or(std::numeric_limits<double>::infinity());
    if (!options.time_s) solve.stop.rounds = kRounds;
    std::atomic<bool> stop = false;
    const std::stop_callback on_cancel(options.cancel, [&stop] { stop = true; });
    solve.stop.cancel = &stop;
    auto tour = order::solve(grid_problem(task), *objective, solve).tour;
    throw_if_cancelled(options.cancel);
    return tour;
  };
}

}  // namespace clearcut::pipeline
