#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "base/elementary.h"
#include "base/parallel.h"
#include "base/units.h"
#include "pipeline/tour/engagement_model.h"
#include "pipeline/tour/tour_solver.h"
#include "plan/common/layers.h"
#include "resolve/resolve.h"
#include "studies/fishhead.h"
#include "studies/reproduce/page/reproduction_figures.h"
#include "studies/reproduce/published_comparisons.h"
#include "studies/reproduce/reproduce_parts.h"
#include "studies/reproduce/table_runs.h"

namespace clearcut::studies {
namespace {

constexpr double kObjectivesMill = 10;  // mm
constexpr double kPitch = 5;
constexpr double kFeed = 1000;  // mm/min
constexpr double kEngagementShare = 0.5;
/// Of the search; objectives of the whole path are dear to ask.
constexpr long long kLocalRounds = 60, kPathRounds = 5;

struct NamedLayer {
  std::string name;
  Layer layer;
};

/// The first layer of every feature, as the text would make its grid: a closed pocket, the 10 mm end mill.
std::vector<NamedLayer> fishhead_layers() {
  PlanOptions options;
  options.stepdown = 2;
  const Part part = resolve::prepare(fishhead(false, {}), options);
  std::vector<NamedLayer> layers;
  for (const auto& step : part.workplan) {
    const auto& feature = feature_of(part, step);
    const auto of_feature = plan::layers_of(feature, step.operation, kObjectivesMill / 2, {});
    if (of_feature.empty()) continue;
    layers.push_back({feature.name, of_feature.front()});
  }
  return layers;
}

Loop rectangle(Vec2 low, Vec2 high, bool is_island) {
  std::array<Vec2, 4> corners{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}};
  if (is_island) std::reverse(corners.begin(), corners.end());
  return loop_from_points(corners);
}

NamedLayer plate(const std::string& name, Vec2 size, const std::vector<std::pair<Vec2, Vec2>>& islands) {
  std::vector<Loop> inner;
  for (const auto& [low, high] : islands) inner.push_back(rectangle(low, high, true));
  NamedLayer result{name, {}};
  result.layer.target = {Region::from_valid_loops(rectangle({0, 0}, size, false), std::move(inner))};
  return result;
}

/// Lattices with holes.
std::vector<NamedLayer> plates() {
  return {plate("120x80, 1 island", {120, 80}, {{{40, 30}, {70, 55}}}),
          plate("150x100, 3 islands", {150, 100},
                {{{25, 20}, {50, 35}}, {{70, 55}, {85, 80}}, {{105, 20}, {125, 60}}}),
          plate("100x100, 4 islands", {100, 100},
                {{{20, 20}, {35, 35}}, {{65, 20}, {80, 35}}, {{20, 65}, {35, 80}}, {{65, 65}, {80, 80}}})};
}

std::vector<NamedLayer> all_layers() {
  std::vector<NamedLayer> layers = fishhead_layers();
  for (NamedLayer& plate : plates()) layers.push_back(std::move(plate));
  for (NamedLayer& named : layers) {
    named.layer.allowed = named.layer.target;
    named.layer.tool_radius = kObjectivesMill / 2;
  }
  return layers;
}

/// Percent above the least.
std::string over(double value, double least) {
  return least > 0 ? fmt::format("{:.1f}", 100 * (value / least - 1)) : "";
}

pipeline::EngagementTask engagement_task(const plan::tour::TourTask& task) {
  return {task.points, task.path, task.layer->target, task.layer->tool_radius};
}

/// A printed row of table 6.4.
struct PrintedTour {
  const char* objective;
  double length;  ///< mm
  int turns;
  const char* seconds;
};
constexpr PrintedTour kPrintedTours[] = {{"length", 2937, 185, "10"},
                                         {"turns", 3615, 41, "10"},
                                         {"engagement 50 %", 3999, 260, "30"},
                                         {"all three", 3012, 42, "30"}};
/// 6.3.4: by how much all three at once are above the least of each.
constexpr double kPrintedOverLength = 2.6, kPrintedOverTurns = 2.4;

/// The shares that the text states follow from its own table.
void add_printed(Reproduction& result) {
  const PrintedTour &shortest = kPrintedTours[0], &straightest = kPrintedTours[1], &all = kPrintedTours[3];
  for (const PrintedTour& row : kPrintedTours) {
    const double length = 100 * (row.length / shortest.length - 1);
    const double turns = 100 * (static_cast<double>(row.turns) / straightest.turns - 1);
    const bool is_stated = &row == &all;
    result.add({"printed", "", row.objective, fmt::format("{:.0f}", row.length),
                is_stated ? of_print(length, kPrintedOverLength, 1) : Cell(fmt::format("{:.1f}", length)),
                std::to_string(row.turns),
                is_stated ? of_print(turns, kPrintedOverTurns, 1) : Cell(fmt::format("{:.1f}", turns)), "",
                "", "", "", row.seconds, ""});
  }
}

double mean_deviation(const plan::tour::TourTask& task, const order::Tour& tour) {
  double sum = 0;
  const auto shares = pipeline::raster_engagement(engagement_task(task))->along(tour);
  for (const double share : shares) sum += std::abs(share - kEngagementShare);
  return sum / static_cast<double>(std::max<std::size_t>(shares.size(), 1));
}

struct Asked {
  const char* name;
  order::ObjectivePtr objective;
};

std::vector<Asked> objectives_for(const plan::tour::TourTask& task) {
  const auto length = order::length_objective(), turns = order::turns_objective();
  const auto engagement = pipeline::engagement_objective(
      kEngagementShare, [&task] { return pipeline::raster_engagement(engagement_task(task)); });
  return {{"length", length},
          {"turns", turns},
          {"turn angle", order::angle_objective()},
          {"time", order::time_objective(kFeed)},
          {"engagement 50 %", engagement},
          {"1 : 20 : 0.1", order::weighted_sum({{1, length}, {20, turns}, {0.1, engagement}})},
          {"1 : 20 : 1", order::weighted_sum({{1, length}, {20, turns}, {1, engagement}})}};
}

/// Of a tour, in this order; what its bound rests on follows letter by letter.
enum TourFigure : std::size_t {
  kTourLength,
  kTourTurns,
  kTourDeviation,
  kTourValue,
  kTourBound,
  kTourGap,
  kTourSeconds,
  kTourBasis
};

RunFigures tour_figures(const plan::tour::TourTask& task, const order::Solution& solution) {
  RunFigures figures{solution.length,
                     static_cast<double>(solution.turns),
                     mean_deviation(task, solution.tour),
                     solution.objective,
                     solution.bound,
                     solution.gap,
                     solution.seconds};
  for (const char letter : solution.bound_basis) figures.push_back(letter);
  return figures;
}

std::string basis_of(const RunFigures& figures) {
  std::string basis;
  for (std::size_t i = kTourBasis; i < figures.size(); ++i) basis += static_cast<char>(figures[i]);
  return basis;
}

std::string objective_in_words(const RunFigures& figures) {
  return fmt::format("{:.0f} mm, {:.0f} turns, {:.1f} s", figures[kTourLength], figures[kTourTurns],
                     figures[kTourSeconds]);
}

/// The least of what several tours have of one figure.
double least_of(const std::vector<RunFigures>& tours, TourFigure figure) {
  double least = std::numeric_limits<double>::infinity();
  for (const RunFigures& tour : tours) least = std::min(least, tour[figure]);
  return least;
}

/// A grid's tours for one objective at a time and for three at once.
void add_objectives(TextTable& table, const std::string& name, const plan::tour::TourTask& task,
                    TableRuns& runs) {
  const auto problem = pipeline::grid_problem(task);
  const auto asked = objectives_for(task);
  std::vector<RunFigures> tours(asked.size());
  parallel_for(std::size_t{0}, asked.size(), [&](std::size_t i) {
    const long long rounds = asked[i].objective->path_dependent() ? kPathRounds : kLocalRounds;
    tours[i] = runs.run(
        fmt::format("{}, {}", name, asked[i].name),
        [&] { return tour_figures(task, solved(problem, *asked[i].objective, 1, rounds)); },
        objective_in_words);
  });
  const double least_length = least_of(tours, kTourLength), least_turns = least_of(tours, kTourTurns);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const RunFigures& tour = tours[i];
    const bool has_bound = tour[kTourBound] > 0;
    table.add({name, std::to_string(task.points.size()), asked[i].name,
               fmt::format("{:.0f}", tour[kTourLength]), over(tour[kTourLength], least_length),
               fmt::format("{:.0f}", tour[kTourTurns]), over(tour[kTourTurns], least_turns),
               fmt::format("{:.3f}", tour[kTourDeviation]), fmt::format("{:.1f}", tour[kTourValue]),
               has_bound ? fmt::format("{:.1f}", tour[kTourBound]) : "none",
               has_bound ? fmt::format("{:.2f}", 100 * tour[kTourGap]) : "",
               fmt::format("{:.1f}", tour[kTourSeconds]), basis_of(tour)});
  }
}

/// Nothing to visit: every tour is as long as its bound.
void add_empty(TextTable& table, const std::string& name) {
  for (const char* objective : {"length", "turns", "turn angle", "time", "engagement 50 %"})
    table.add({name, "0", objective, "0", "", "0", "", "0.000", "0.0", "0.0", "0.00", "", "no grid point"});
}

std::array<double, 10> histogram(const std::vector<double>& shares) {
  std::array<double, 10> bins{};
  for (const double share : shares) {
    bins[static_cast<std::size_t>(std::clamp(share * 10, 0.0, 9.0))] +=
        100 / static_cast<double>(std::max<std::size_t>(shares.size(), 1));
  }
  return bins;
}

void add_histogram(TextTable& table, const plan::tour::TourTask& task, int target, const char* model,
                   const std::vector<double>& shares) {
  std::vector<std::string> row{fmt::format("{} %", target), fmt::format("{:.2f}", task.pitch),
                               std::to_string(task.points.size()), model};
  double mean = 0;
  for (const double share : shares) mean += 100 * share / static_cast<double>(shares.size());
  row.push_back(fmt::format("{:.1f}", mean));
  for (const double bin : histogram(shares)) row.push_back(fmt::format("{:.0f}", bin));
  table.add(row);
}

/// A row beside a row at this distance has the target's share of the leading half in material.
double matching_pitch(int target) {
  return kObjectivesMill * (1 - base::cos(kPi * target / 100)) / 2;
}

void add_engagement(TextTable& table, const plan::tour::TourTask& task, int target) {
  const auto objective = pipeline::engagement_objective(
      target / 100.0, [&] { return pipeline::raster_engagement(engagement_task(task)); });
  const auto solution = solved(pipeline::grid_problem(task), *objective, 1);
  for (const bool exact : {false, true}) {
    const auto model = exact ? pipeline::exact_engagement(engagement_task(task))
                             : pipeline::raster_engagement(engagement_task(task));
    add_histogram(table, task, target, exact ? "exact" : "raster", model->along(solution.tour));
  }
}

/// Engagement alone in both readings of eq. 4.22, alone with the other objectives, and all three at once.
std::vector<Asked> single_and_multi(const plan::tour::TourTask& task) {
  const auto make = [&task] { return pipeline::raster_engagement(engagement_task(task)); };
  const auto linear = pipeline::engagement_objective(kEngagementShare, make);
  const auto inverse =
      pipeline::engagement_objective(kEngagementShare, make, pipeline::inverse_engagement_cost);
  const auto length = order::length_objective(), turns = order::turns_objective();
  return {{"engagement, linear", linear},
          {"engagement, 1 / deviation", inverse},
          {"length", length},
          {"turns", turns},
          {"1 : 20 : 0.1", order::weighted_sum({{1, length}, {20, turns}, {0.1, linear}})}};
}

/// Returns the tour.
order::Tour add_asked(TextTable& table, const plan::tour::TourTask& task, const Asked& asked) {
  const long long rounds = asked.objective->path_dependent() ? kPathRounds : kLocalRounds;
  const auto solution = solved(pipeline::grid_problem(task), *asked.objective, 1, rounds);
  const auto shares = pipeline::raster_engagement(engagement_task(task))->along(solution.tour);
  std::vector<std::string> row{asked.name, fmt::format("{:.0f}", solution.length),
                               std::to_string(solution.turns),
                               fmt::format("{:.3f}", mean_deviation(task, solution.tour))};
  for (const double bin : histogram(shares)) row.push_back(fmt::format("{:.0f}", bin));
  table.add(row);
  return solution.tour;
}

}  // namespace

Reproduction single_multi_table() {
  constexpr const char* kFeature = "POCKET1";
  Reproduction result;
  TextTable& table = result.table;
  table.title = fmt::format(
      "Tour figures 6-16 and 6-17: percent of the moves by mean engagement, {}, 10 mm end mill, target 50 %",
      kFeature);
  table.columns = {{"objective", Align::kLeft}, {"length"}, {"turns"}, {"deviation"}};
  for (int bin = 0; bin < 10; ++bin) table.columns.push_back({fmt::format("{}-{}", 10 * bin, 10 * bin + 10)});
  for (const auto& [name, layer] : all_layers()) {
    if (name != kFeature) continue;
    with_largest_grid(layer, kPitch, [&](const plan::tour::TourTask& task) {
      order::Tour last;
      for (const Asked& asked : single_and_multi(task)) last = add_asked(table, task, asked);
      result.figures.push_back(
          tour_figure(fmt::format("as figure 6-16: {} by all three objectives", kFeature), task.layer->target,
                      task.points, last));
    });
  }
  result.figures.push_back(
      histograms_figure("as figure 6-17: engagement, one objective against several", table,
                        {.first = 4, .name_column = 0, .begin = 0, .end = table.rows.size()}));
  table.notes.push_back("the figures are drawn, not printed as numbers: nothing to compare cell by cell");
  table.notes.push_back(
      "deviation: mean |engagement - 50 %|, raster model; 1 : 20 : 0.1 are ours, the text prints no weights");
  return result;
}

Reproduction objectives_table(const TableWatch& watch) {
  Reproduction result;
  TextTable& table = result.table;
  table.title =
      "Tour table 6.4: the fishhead's features and plates with islands, grid of 5 mm, 10 mm end mill, legal "
      "ways "
      "only";
  table.columns = {{"feature", Align::kLeft},
                   {"points"},
                   {"objective", Align::kLeft},
                   {"length"},
                   {"over least %"},
                   {"turns"},
                   {"over least %"},
                   {"deviation"},
                   {"value"},
                   {"bound"},
                   {"gap %"},
                   {"s"},
                   {"bound by", Align::kLeft}};
  add_printed(result);
  table.add_rule();
  constexpr std::size_t kObjectives = 7;
  const auto layers = all_layers();
  TableRuns runs(watch, layers.size() * kObjectives);
  for (const auto& [name, layer] : layers) {
    if (!with_largest_grid(layer, kPitch, [&, &of = name](const plan::tour::TourTask& task) {
          add_objectives(table, of, task, runs);
        }))
      add_empty(table, name);
  }
  table.notes.push_back(
      "1 : 20 : 0.1 are weights of length (mm), turns and engagement; the text states neither its weights "
      "nor its "
      "feature or grid");
  table.notes.push_back("deviation: mean |engagement - 50 %|, raster model; engagement has no bound but 0");
  table.notes.push_back(
      "time: CPO-rho eq. 9 at 1000 mm/min, s; turn bounds hold for unit steps, those by line cover for any");
  return result;
}

Reproduction engagement_table() {
  constexpr const char* kFeature = "POCKET1";
  Reproduction result;
  TextTable& table = result.table;
  table.title =
      fmt::format("Tour figure 6-15: percent of the moves by mean engagement, {}, 10 mm end mill", kFeature);
  table.columns = {{"target"}, {"grid, mm"}, {"points"}, {"model", Align::kLeft}, {"mean %"}};
  for (int bin = 0; bin < 10; ++bin) table.columns.push_back({fmt::format("{}-{}", 10 * bin, 10 * bin + 10)});
  for (const auto& [name, layer] : all_layers()) {
    if (name != kFeature) continue;
    for (const bool is_matched : {false, true}) {
      for (int target = 20; target <= 100; target += 20) {
        const double pitch = is_matched ? matching_pitch(target) : kObjectivesMill * target / 100;
        with_largest_grid(layer, pitch,
                          [&](const plan::tour::TourTask& task) { add_engagement(table, task, target); });
      }
      if (!is_matched) table.add_rule();
    }
  }
  const std::size_t half = table.rows.size() / 2;
  for (const bool is_matched : {false, true})
    result.figures.push_back(histograms_figure(
        is_matched ? "as figure 6-15, spacing matched to the target" : "as figure 6-15, spacing by eq. 4.8",
        table,
        {.first = 5,
         .name_column = 0,
         .begin = is_matched ? half + 1 : 0,
         .end = is_matched ? table.rows.size() : half,
         .model_column = 3,
         .model = "exact"}));
  table.notes.push_back("optimised by the raster model, then measured by both; a slot is 100 %");
  table.notes.push_back(
      "above: spacing D times target (eq. 4.8), where a row beside a row has 30, 44, 56, 70, 100 % of the "
      "leading "
      "half in material; below: the spacing at which that is the target itself");
  return result;
}

}  // namespace clearcut::studies
