#include "pipeline/tour/tour.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/progress.h"
#include "base/text.h"
#include "geometry/box.h"
#include "geometry/region.h"
#include "order/lattice.h"
#include "order/length/neighbours.h"
#include "order/tsplib.h"
#include "pipeline/tour/convergence.h"
#include "pipeline/tour/engagement_model.h"
#include "pipeline/tour/tour_solver.h"

namespace clearcut::pipeline {
namespace {

order::ObjectivePtr single_objective(ObjectiveKind kind, double feed) {
  switch (kind) {
    case ObjectiveKind::kLength:
      return order::length_objective();
    case ObjectiveKind::kTurns:
      return order::turns_objective();
    case ObjectiveKind::kAngle:
      return order::angle_objective();
    case ObjectiveKind::kTime:
      return order::time_objective(feed);
    default:
      throw InputError("--objective", fmt::format("'{}' needs a cutter; use length, turns, angle, time, or "
                                                  "weights such as 1:length,20:turns",
                                                  name_of(kind)));
  }
}

constexpr const char* kOption = "--objective";

order::Problem problem_of(const std::string& input, const TourOptions& options) {
  const auto lattice = order::parse_lattice(input);
  if (!lattice && order::is_like_lattice(input))
    throw InputError(input, "a lattice has 1 to 10000 columns and rows; write for example 30x20");
  order::Problem problem = lattice ? order::lattice_problem(lattice->columns, lattice->rows)
                                   : order::read_tsplib(read_file(input), input);
  const bool closed = options.closed.value_or(!lattice);
  problem.shape = closed ? order::Shape::kClosedTour : order::Shape::kOpenPath;
  return problem;
}

}  // namespace

order::ObjectivePtr objective_named(const std::string& text, double feed) {
  return objective_of(parse_objective(text, kOption),
                      [&](ObjectiveKind kind) { return single_objective(kind, feed); });
}

namespace {

order::Solution solve_published(const order::Problem& problem, const order::Objective& objective,
                                const TourOptions& options, const std::atomic<bool>& stop,
                                const std::function<void(const order::Progress&)>& progress) {
  order::GeneticOptions genetic = options.genetic;
  genetic.stop.cancel = &stop;
  genetic.seed = options.seed;
  genetic.stop.seconds = options.time_s;
  genetic.neighbours = options.genetic_neighbours.value_or(problem.neighbour_count);
  genetic.progress = progress;
  return order::solve_genetic(problem, objective, genetic);
}

/// mm between a point and its nearest: the median; 1 if there is none.
double pitch_of(const order::Problem& problem) {
  if (problem.size() < 2) return 1;
  const auto near = order::nearest_neighbours(problem.points, 1);
  std::vector<double> steps;
  for (int v = 0; v < problem.size(); ++v)
    steps.push_back(order::straight_distance(problem, v, near.of(v)[0]));
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle > 0 ? *middle : 1;
}

/// Greatest extent of a block in radii of the cutter: the raster has about eleven pixels per radius.
constexpr double kMostRadii = 800;

/// A cutter in a block extending a radius beyond the points, as if they were the centres of a rectangular pocket.
EngagementTask engagement_task(const order::Problem& problem, const TourOptions& options) {
  EngagementTask task;
  task.points = problem.points;
  task.radius = options.diameter.value_or(2 * pitch_of(problem)) / 2;
  Box block;
  for (const Vec2 p : problem.points) block.add(p);
  block = block.grown(task.radius);
  if (block.width() > kMostRadii * task.radius || block.height() > kMostRadii * task.radius) {
    throw InputError(
        "--diameter",
        fmt::format("{} mm is too small for points that reach over {} mm; engagement needs a "
                    "cutter of at least {} mm here",
                    trimmed(2 * task.radius, 4), trimmed(std::max(block.width(), block.height()), 3),
                    trimmed(2 * std::max(block.width(), block.height()) / kMostRadii, 4)));
  }
  task.target = {rectangular_region(block)};
  return task;
}

order::ObjectivePtr objective_for(const order::Problem& problem, const TourOptions& options) {
  return objective_of(parse_objective(options.objective, kOption), [&](ObjectiveKind kind) {
    const double target = options.engagement_percent / 100;
    const auto task = [&] { return engagement_task(problem, options); };
    if (kind == ObjectiveKind::kEngagement)
      return engagement_objective(target, [given = task()] { return raster_engagement(given); });
    if (kind == ObjectiveKind::kEngagementInverse)
      return engagement_objective(
          target, [given = task()] { return raster_engagement(given); }, inverse_engagement_cost);
    if (kind == ObjectiveKind::kEngagementExact)
      return engagement_objective(target, [given = task()] { return exact_engagement(given); });
    return single_objective(kind, options.feed);
  });
}

}  // namespace

TourResult solve_tour(const std::string& input, const TourOptions& options) {
  return solve_tour(problem_of(input, options), options);
}

TourResult solve_tour(const order::Problem& problem, const TourOptions& options) {
  order::check(problem);
  if (options.solver != "modern" && options.solver != "published")
    throw InputError("--solver", fmt::format("'{}' is unknown; use modern or published", options.solver));
  TourResult result{problem, {}, options.objective};
  Convergence convergence(options.improved);
  const auto progress = [&convergence](const order::Progress& at) {
    convergence.add({at.seconds, at.objective});
  };
  const auto objective = objective_for(problem, options);
  std::atomic<bool> stop = false;
  const std::stop_callback on_cancel(options.cancel, [&stop] { stop = true; });
  if (options.solver == "published") {
    result.solution = solve_published(problem, *objective, options, stop, progress);
  } else {
    order::SolveOptions solve_options;
    solve_options.stop.seconds = options.time_s;
    solve_options.stop.cancel = &stop;
    solve_options.seed = options.seed;
    solve_options.threads = options.threads;
    solve_options.progress = progress;
    result.solution = order::solve(problem, *objective, solve_options);
  }
  throw_if_cancelled(options.cancel);
  result.convergence = convergence.take();
  return result;
}

std::string tour_json(const TourResult& result) {
  const auto& s = result.solution;
  nlohmann::ordered_json json;
  json["name"] = result.problem.name;
  json["objective"] = s.objective;
  json["objective_name"] = result.objective;
  json["length"] = s.length;
  json["turns"] = s.turns;
  json["angle_deg"] = s.angle_deg;
  json["bound"] = s.bound;
  json["bound_basis"] = s.bound_basis;
  json["gap"] = s.gap;
  json["time_s"] = s.seconds;
  json["seed"] = s.seed;
  json["rounds"] = s.rounds;
  json["method"] = s.method;
  json["closed"] = result.problem.closed();
  json["convergence"] = nlohmann::ordered_json::array();
  for (const TourSample& sample : result.convergence)
    json["convergence"].push_back({sample.seconds, sample.best});
  json["tour"] = s.tour;
  return json.dump() + "\n";
}

std::string tour_svg(const TourResult& result) {
  Box box;
  for (const auto p : result.problem.points) box.add(p);
  const double size = std::max({box.width(), box.height(), 1e-9});
  const Box page = box.grown(0.03 * size);
  std::string path;
  for (const int i : result.solution.tour) {
    const Vec2 p = result.problem.points[static_cast<std::size_t>(i)];
    path += fmt::format("{}{} {}", path.empty() ? "M" : " L", trimmed(p.x, 4),
                        trimmed(page.min.y + page.max.y - p.y, 4));
  }
  if (result.problem.closed()) path += " Z";
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\" width=\"1200\">"
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"white\"/>"
      "<path d=\"{}\" fill=\"none\" stroke=\"#1d4f91\" stroke-width=\"{}\" "
      "stroke-linejoin=\"round\"/></svg>\n",
      page.min.x, page.min.y, page.width(), page.height(), page.min.x, page.min.y, page.width(),
      page.height(), path, size / 600);
}

std::string tour_line(const TourResult& result) {
  const auto& s = result.solution;
  return fmt::format(
      "{}: {} points, {} {}, length {}, turns {}, angle {} deg, bound {} ({}), gap {:.4f} %, {:.2f} s, "
      "seed {}, {}",
      result.problem.name, result.problem.size(), result.objective, trimmed(s.objective, 4),
      trimmed(s.length, 4), s.turns, trimmed(s.angle_deg, 3), trimmed(s.bound, 4), s.bound_basis, 100 * s.gap,
      s.seconds, s.seed, s.method);
}

}  // namespace clearcut::pipeline
