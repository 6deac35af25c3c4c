#include "pipeline/elements.h"

#include <fmt/format.h>

#include <functional>

#include "base/progress.h"
#include "base/text.h"
#include "features/standing.h"
#include "geometry/voronoi/clearance.h"
#include "model/results/findings.h"
#include "order/search/solve.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/steps/certify.h"
#include "pipeline/tour/tour_solver.h"
#include "plan/common/layers.h"
#include "plan/grid/shape.h"
#include "plan/grid/visit.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

constexpr double kSearchSeconds = 2;  // default for one order
constexpr long long kSearchRounds = 200;

order::Problem visit_problem(const std::vector<Vec2>& points) {
  order::Problem problem;
  problem.points = points;
  problem.shape = order::Shape::kOpenPath;
  return problem;
}

order::Solution shortest_visit(const std::vector<Vec2>& points, const PlanOptions& options,
                               const std::function<void(const order::Progress&)>& progress = {}) {
  order::SolveOptions solve;
  solve.seed = options.seed;
  solve.threads = options.threads;
  solve.stop.seconds = options.time_s.value_or(kSearchSeconds);
  solve.stop.rounds = kSearchRounds;
  solve.progress = progress;
  return order::solve(visit_problem(points), *order::length_objective(), solve);
}

bool is_published(const PlanOptions& options) {
  return options.published.solver && options.published.solver->is_published;
}

/// The order found by a solver, with its convergence.
std::vector<int> searched_visit(const std::vector<Vec2>& points, const PlanOptions& options,
                                VisitSearch& search) {
  search.points = points.size();
  if (!is_published(options)) {
    search.solver = "modern";
    const auto solution = shortest_visit(points, options, [&](const order::Progress& at) {
      search.step.push_back(static_cast<double>(search.step.size()));
      search.best.push_back(at.objective);
    });
    search.length = solution.length;
    return solution.tour;
  }
  search.solver = "published";
  const auto result =
      published_order(visit_problem(points), *order::length_objective(),
                      {options.published.solver->published, options.seed, options.time_s, options.cancel});
  for (const auto& sample : result.samples) {
    search.step.push_back(static_cast<double>(sample.generation));
    search.best.push_back(sample.best);
  }
  search.length = result.value;
  return result.tour;
}

Workingstep step_of(std::size_t element, const ElementJob& job) {
  const auto& from = job.elements[element];
  Workingstep step;
  step.name = from.id;
  step.source = from.source;
  step.feature = static_cast<int>(element);
  step.operation.name = from.id;
  step.operation.tool = static_cast<int>(tool_of(job, from) - job.tools.data());
  step.operation.cutting = from.cutting;
  step.operation.stepdown = from.stepdown;
  return step;
}

/// The part described by the elements, its workplan in the order of the visits.
Part part_of(const ElementJob& job, const std::vector<plan::grid::ElementVisit>& visits,
             const Tolerances& tol) {
  Part part;
  part.name = job.name;
  part.source_file = job.source_file;
  part.stock = job.stock;
  part.tools = job.tools;
  for (const auto& element : job.elements) part.features.push_back(plan::grid::feature_of(element, job));
  for (const auto& visit : visits) part.workplan.push_back(step_of(visit.element, job));
  for (const auto& noticed : plan::grid::off_grid(job)) part.diagnostics.warn(noticed.place, noticed.text);
  features::stack_tops(part, tol);
  return part;
}

/// Legal area of the tool's centre. Grooves as wide as the tool have room only for their own line.
Regions legal_of(const Region& target, double tool_radius, const Tolerances& tol) {
  const Clearance clearance(target, tol);
  Regions legal = clearance.inset(tool_radius);
  return legal.empty() ? clearance.inset(tool_radius - tol.fit) : legal;
}

std::vector<LayerPasses> passes_of(const plan::grid::ElementVisit& visit, const ResolvedPlan& plan,
                                   std::size_t index) {
  const Workingstep& step = plan.part.workplan[index];
  const auto& feature = feature_of(plan.part, step);
  const Regions legal = legal_of(feature.target.front(), tool_of(plan.part, step).radius(), plan.tol);
  std::vector<LayerPasses> layers;
  double top = feature.top_z;
  for (const double z : plan::layer_heights(feature.top_z, feature.floor_z, plan.steps[index].stepdown)) {
    LayerPasses layer;
    layer.z_top = top;
    layer.z = z;
    layer.legal = legal;
    layer.target = feature.target;
    layer.strategy = "grid";
    Pass pass;
    pass.path = visit.path;
    layer.passes.push_back(std::move(pass));
    layers.push_back(std::move(layer));
    top = z;
  }
  return layers;
}

/// A visit of one point is a plunge and no more.
void drop_standing_moves(Section& section) {
  std::erase_if(section.moves,
                [](const Move& move) { return move.path.from == move.path.to && move.z_from == move.z_to; });
}

Toolpath toolpath_of(const std::vector<plan::grid::ElementVisit>& visits, const ResolvedPlan& plan) {
  Toolpath toolpath;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const auto passes = passes_of(visits[i], plan, i);
    const EntryKind entry = plan.part.workplan[i].operation.entry.value_or(EntryKind::kPlunge);
    Section section = link_step(passes, static_cast<int>(i), entry, plan);
    drop_standing_moves(section);
    if (!section.moves.empty()) toolpath.sections.push_back(std::move(section));
  }
  return toolpath;
}

std::vector<ElementFigures> figures_of(const ElementJob& job, const PointTable& table,
                                       const std::vector<plan::grid::ElementVisit>& visits) {
  std::vector<ElementFigures> figures(job.elements.size());
  for (std::size_t i = 0; i < figures.size(); ++i) figures[i].id = job.elements[i].id;
  for (const auto& point : table.points) {
    auto& own = figures[static_cast<std::size_t>(point.element) - 1];
    ++own.squares;
    if (point.reduced) ++own.reduced;
  }
  for (const auto& visit : visits) figures[visit.element].visit_mm = length(visit.path);
  return figures;
}

}  // namespace

ElementsResult plan_elements(const ElementJob& job, const PlanOptions& options) {
  plan::grid::check(job);
  ElementsResult result;
  result.points = plan::grid::tabulate(job);
  ProgressMeter meter(options.progress, options.cancel);
  meter.begin(Stage::kPlanning, job.elements.size());
  const auto visits = plan::grid::plan_visits(job, result.points, [&](const std::vector<Vec2>& points) {
    auto order = searched_visit(points, options, result.searches.emplace_back());
    meter.add();
    return order;
  });
  throw_if_cancelled(options.cancel);
  result.elements = figures_of(job, result.points, visits);
  const ResolvedPlan plan =
      resolve::resolve(part_of(job, visits, options.tol), options, strategies_of(options));
  result.plan.part = plan.part;
  result.plan.values = plan.values;
  const Toolpath planned = toolpath_of(visits, plan);
  certify(result.plan, planned, plan);
  add_not_machined(result.plan.part.diagnostics, result.plan.findings);
  sign(result.plan, planned, plan);
  return result;
}

std::vector<SquareSearch> search_squares(const ElementJob& job, const PointTable& points,
                                         const PlanOptions& options) {
  const PublishedSolver solver =
      options.published.solver ? options.published.solver->published : PublishedSolver{};
  const auto search = [&](const std::vector<Vec2>& at) {
    return published_order(visit_problem(at), *order::length_objective(),
                           {solver, options.seed, options.time_s, options.cancel});
  };
  std::vector<SquareSearch> searches;
  for (std::size_t i = 0; i < job.elements.size(); ++i) {
    std::vector<Vec2> all, reduced;
    for (const GridPoint& point : points.points) {
      if (static_cast<std::size_t>(point.element) != i + 1) continue;
      all.push_back(point.at);
      if (point.reduced) reduced.push_back(point.at);
    }
    const auto of_all = search(all), of_reduced = search(reduced);
    searches.push_back({job.elements[i].id, all.size(), reduced.size(), of_all.value, of_all.seconds,
                        of_reduced.value, of_reduced.seconds});
  }
  return searches;
}

TextTable square_table(const std::vector<SquareSearch>& searches) {
  TextTable table;
  table.title = "The published genetic algorithm on all squares, and on those that the reduction keeps";
  table.columns = {
      {"element", Align::kLeft}, {"squares"}, {"visit mm"}, {"s"}, {"reduced"}, {"visit mm"}, {"s"}};
  for (const SquareSearch& one : searches)
    table.add({one.id, std::to_string(one.squares), fmt::format("{:.2f}", one.all_mm),
               fmt::format("{:.3f}", one.all_s), std::to_string(one.reduced),
               fmt::format("{:.2f}", one.reduced_mm), fmt::format("{:.3f}", one.reduced_s)});
  return table;
}

TextTable element_table(const ElementsResult& result) {
  TextTable table;
  table.columns = {{"element", Align::kLeft}, {"squares"}, {"reduced"}, {"kept %"}, {"visit mm"}};
  for (const auto& element : result.elements) {
    const double share = 100.0 * static_cast<double>(element.reduced) / static_cast<double>(element.squares);
    table.add({element.id, std::to_string(element.squares), std::to_string(element.reduced),
               fmt::format("{:.1f}", share), fmt::format("{:.2f}", element.visit_mm)});
  }
  return table;
}

}  // namespace clearcut::pipeline
