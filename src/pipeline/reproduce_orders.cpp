#include "pipeline/reproduce_orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "order/lattice.h"
#include "order/solve.h"
#include "part/fishhead.h"
#include "pipeline/engagement_model.h"
#include "pipeline/prepare.h"
#include "pipeline/tour_solver.h"
#include "plan/layers.h"

namespace clearcut {
namespace {

order::Solution solved(const order::Problem& problem, const order::Objective& objective, std::uint64_t seed,
                       long long rounds = 4) {
  order::SolveOptions options;
  options.seed = seed;
  options.stop.seconds = std::numeric_limits<double>::infinity();
  options.stop.effort = 1;
  options.stop.rounds = rounds;
  return order::solve(problem, objective, options);
}

/// Worst value and longest time over seeds.
struct Worst {
  double value = 0, bound = 0, seconds = 0;
};

Worst worst_of(const order::Problem& problem, const order::Objective& objective, int seeds) {
  Worst worst;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto solution = solved(problem, objective, static_cast<std::uint64_t>(seed));
    worst.value = std::max(worst.value, solution.objective);
    worst.bound = solution.bound;
    worst.seconds = std::max(worst.seconds, solution.seconds);
  }
  return worst;
}

order::Problem open_lattice(int columns, int rows) {
  order::Problem problem = order::lattice_problem(columns, rows);
  problem.shape = order::Shape::kOpenPath;
  return problem;
}

void add_lattice(TextTable& table, const std::string& size, const std::string& measure,
                 const std::string& printed, const Worst& worst, int seeds) {
  table.add({size, measure, printed, fmt::format("{:.0f}", worst.value), fmt::format("{:.0f}", worst.bound),
             std::to_string(seeds), fmt::format("{:.3f}", worst.seconds)});
}

constexpr double kEndMill = 10;  // mm
constexpr double kEngagementShare = 0.5;
/// Of the search; objectives of the whole path are dear to ask.
constexpr long long kLocalRounds = 30, kPathRounds = 5;

/// Hands the grids of a layer, made as published, to `answer`.
void ask_published(const Layer& layer, double pitch, const TourSolver& answer) {
  TourGridOptions grid;
  grid.published = true;
  grid.pitch = pitch;
  grid.pitch_in_mm = true;
  plan_tour(layer, grid, answer, {});
}

struct Sum {
  double length = 0, angle = 0;
  int turns = 0;
  Sum& operator+=(const Sum& o) {
    length += o.length, angle += o.angle, turns += o.turns;
    return *this;
  }
};

/// Length, turns and angle of the published grid of a layer in the order that the objective asks for.
Sum grid_figures(const Layer& layer, double pitch, const order::Objective& objective) {
  Sum sum;
  ask_published(layer, pitch, [&](const TourTask& task) {
    const auto solution = solved(grid_problem(task), objective, 1, 1);
    sum += {solution.length, solution.angle_deg, solution.turns};
    return solution.tour;
  });
  return sum;
}

/// How the printed job may be read: grids of half a diameter or a diameter, every layer or one a feature.
struct Reading {
  const char* name;
  double face_pitch, pocket_pitch;  ///< mm
};

struct Job {
  Sum one_layer, all_layers;
};

Job fishhead_figures(const Reading& reading, const order::Objective& objective) {
  PlanOptions options;
  options.stepdown = 2;
  const Part part = prepare(fishhead(false, {}), options);
  Job job;
  for (const auto& step : part.workplan) {
    const double radius = tool_of(part, step).radius();
    auto layers = layers_of(feature_of(part, step), step.operation, radius, {});
    if (layers.empty()) continue;
    const double pitch = radius > kEndMill ? reading.face_pitch : reading.pocket_pitch;
    // All layers have the same outline, so the same tour serves them all. Open sides: the target's own outline,
    // as published (a closed pocket made of it).
    Layer layer = layers.front();
    layer.allowed = layer.target;
    const Sum one = grid_figures(layer, pitch, objective);
    const int count = static_cast<int>(layers.size());
    job.one_layer += one;
    job.all_layers += {one.length * count, one.angle * count, one.turns * count};
  }
  return job;
}

void add_reading(TextTable& table, const std::string& name, const Sum& rows, const Sum& spiral) {
  table.add({name, fmt::format("{:.0f}", rows.length), std::to_string(rows.turns),
             fmt::format("{:.0f}", spiral.length), fmt::format("{:.0f}", spiral.angle),
             fmt::format("{:.2f}", rows.length / 25282)});
}

order::ObjectivePtr seeded(const char* kind) {
  // Among tours of equal turns or angle the shorter one, as the text's multi-objective fitness.
  const auto main = std::string(kind) == "turns" ? order::turns_objective() : order::angle_objective();
  const double weight = std::string(kind) == "turns" ? 20 : 0.2;
  return order::weighted_sum({{weight, main}, {1, order::length_objective()}});
}

/// The grid of a feature of the fishhead as the text would make it; of several the largest. Handed to `use`, since
/// its legal ways can be asked for no longer than that.
void with_grid(const std::string& feature_name, double pitch,
               const std::function<void(const TourTask&)>& use) {
  PlanOptions options;
  options.stepdown = 2;
  const Part part = prepare(fishhead(false, {}), options);
  for (const auto& step : part.workplan) {
    const auto& feature = feature_of(part, step);
    if (feature.name != feature_name) continue;
    Layer layer = layers_of(feature, step.operation, kEndMill / 2, {}).front();
    layer.allowed = layer.target;
    layer.tool_radius = kEndMill / 2;
    std::size_t largest = 0;
    const auto as_they_come = [](const TourTask& task) {
      std::vector<int> order(task.points.size());
      std::iota(order.begin(), order.end(), 0);
      return order;
    };
    ask_published(layer, pitch, [&](const TourTask& task) {
      largest = std::max(largest, task.points.size());
      return as_they_come(task);
    });
    ask_published(layer, pitch, [&](const TourTask& task) {
      if (task.points.size() == largest) use(task);
      return as_they_come(task);
    });
    return;
  }
}

/// Percent above the least.
std::string over(double value, double least) {
  return least > 0 ? fmt::format("{:.1f}", 100 * (value / least - 1)) : "";
}

EngagementTask engagement_task(const TourTask& task) {
  return {task.points, task.way, task.layer->target, task.layer->tool_radius};
}

void add_printed(TextTable& table, const char* objective, double length, int turns) {
  table.add({"printed", "", objective, fmt::format("{:.0f}", length), over(length, 2937),
             std::to_string(turns), over(turns, 41), "", "", ""});
}

double mean_deviation(const TourTask& task, const order::Tour& tour) {
  double sum = 0;
  const auto shares = raster_engagement(engagement_task(task))->along(tour);
  for (const double share : shares) sum += std::abs(share - kEngagementShare);
  return sum / static_cast<double>(std::max<std::size_t>(shares.size(), 1));
}

/// A grid's tours for one objective at a time and for all at once.
void add_objectives(TextTable& table, const char* feature, const TourTask& task) {
  const auto problem = grid_problem(task);
  const auto length = order::length_objective(), turns = order::turns_objective();
  const auto engagement =
      engagement_objective(kEngagementShare, [&] { return raster_engagement(engagement_task(task)); });
  const std::pair<const char*, order::ObjectivePtr> objectives[] = {
      {"length", length},
      {"turns", turns},
      {"engagement 50 %", engagement},
      {"all three", order::weighted_sum({{1, length}, {20, turns}, {0.1, engagement}})}};
  double least_length = 0;
  int least_turns = 0;
  for (const auto& [name, objective] : objectives) {
    const auto solution =
        solved(problem, *objective, 1, objective->path_dependent() ? kPathRounds : kLocalRounds);
    if (objective == length) least_length = solution.length;
    if (objective == turns) least_turns = solution.turns;
    const bool knows_turns = least_turns > 0;
    table.add({feature, std::to_string(task.points.size()), name, fmt::format("{:.0f}", solution.length),
               over(solution.length, least_length), std::to_string(solution.turns),
               knows_turns ? over(solution.turns, least_turns) : "",
               fmt::format("{:.3f}", mean_deviation(task, solution.tour)),
               fmt::format("{:.0f}", solution.bound), fmt::format("{:.2f}", 100 * solution.gap)});
  }
}

std::array<double, 10> histogram(const std::vector<double>& shares) {
  std::array<double, 10> bins{};
  for (const double share : shares) {
    bins[static_cast<std::size_t>(std::clamp(share * 10, 0.0, 9.0))] +=
        100 / static_cast<double>(std::max<std::size_t>(shares.size(), 1));
  }
  return bins;
}

void add_histogram(TextTable& table, int target, const char* model, const std::vector<double>& shares) {
  std::vector<std::string> row{fmt::format("{} %", target), model};
  double mean = 0;
  for (const double share : shares) mean += 100 * share / static_cast<double>(shares.size());
  row.push_back(fmt::format("{:.1f}", mean));
  for (const double bin : histogram(shares)) row.push_back(fmt::format("{:.0f}", bin));
  table.add(row);
}

}  // namespace

TextTable lattice_table() {
  TextTable table;
  table.title = "Tour tables 6.3 and 6.6: lattices, open paths; ours is the worst over all seeds";
  table.columns = {{"lattice", Align::kLeft},
                   {"measure", Align::kLeft},
                   {"printed"},
                   {"ours"},
                   {"bound"},
                   {"seeds"},
                   {"longest s"}};
  const auto ten = open_lattice(10, 10);
  add_lattice(table, "10x10", "turns", "18.33", worst_of(ten, *order::turns_objective(), 100), 100);
  add_lattice(table, "10x10", "angle, deg", "1636.8", worst_of(ten, *order::angle_objective(), 100), 100);
  const std::tuple<int, int, const char*> sizes[] = {
      {10, 10, "99.91 %"}, {100, 100, "97.34 %"}, {100, 75, "97.52 %"}, {100, 80, "97.43 %"}};
  for (const auto& [columns, rows, printed] : sizes) {
    const auto problem = open_lattice(columns, rows);
    const std::string size = fmt::format("{}x{}", columns, rows);
    const auto length = worst_of(problem, *order::length_objective(), 3);
    add_lattice(table, size, fmt::format("length ({:.2f} %)", 100 * length.bound / length.value), printed,
                length, 3);
    add_lattice(table, size, "turns", "", worst_of(problem, *order::turns_objective(), 3), 3);
    add_lattice(table, size, "angle, deg", "", worst_of(problem, *order::angle_objective(), 3), 3);
  }
  table.notes.push_back("printed percentages are the text's fitness: optimum / result");
  return table;
}

TextTable fishhead_table() {
  constexpr std::array<Reading, 2> kReadings{{{"50 % of D", 20, 5}, {"D", 40, 10}}};
  TextTable table;
  table.title = "Tour table 6.5: the fishhead, 40 mm face mill and 10 mm end mill, layers of 2 mm";
  table.columns = {{"reading", Align::kLeft}, {"feed, bidirectional"}, {"turns"},
                   {"feed, spiral"},          {"turn angle, deg"},     {"feed / printed"}};
  table.add({"printed: GA", "25282", "423", "24103", "34686", "1.00"});
  table.add({"printed: NX", "24950", "415", "23830", "34090", "0.99"});
  table.add({"printed: FeatureCAM", "24395", "412", "23740", "34358", "0.96"});
  table.add({"printed: MasterCAM", "25030", "431", "24010", "35670", "0.99"});
  table.add_rule();
  for (const auto& reading : kReadings) {
    const Job rows = fishhead_figures(reading, *seeded("turns"));
    const Job spiral = fishhead_figures(reading, *seeded("angle"));
    add_reading(table, fmt::format("{}, every 2 mm layer", reading.name), rows.all_layers, spiral.all_layers);
    add_reading(table, fmt::format("{}, one layer a feature", reading.name), rows.one_layer,
                spiral.one_layer);
  }
  table.notes.push_back(
      "nearest to print: a grid of D in every layer; feed, turns and angle are all about 1.2 times the "
      "printed "
      "ones there, while 50 % of D at 2 mm needs more than twice the printed feed whatever the order");
  table.notes.push_back("grids as published: they leave a rim; entries and moves between areas are not in");
  table.notes.push_back(
      "the certified clean job: clearcut plan examples/fishhead.p21 --strategy tour --stepdown 2");
  return table;
}

TextTable objectives_table() {
  TextTable table;
  table.title = "Tour table 6.4: the fishhead's features, grid of 5 mm, 10 mm end mill, legal ways only";
  table.columns = {{"feature", Align::kLeft},
                   {"points"},
                   {"objective", Align::kLeft},
                   {"length"},
                   {"over least %"},
                   {"turns"},
                   {"over least %"},
                   {"deviation"},
                   {"bound"},
                   {"gap %"}};
  add_printed(table, "length", 2937, 185);
  add_printed(table, "turns", 3615, 41);
  add_printed(table, "engagement 50 %", 3999, 260);
  add_printed(table, "all three", 3012, 42);
  for (const char* feature : {"PLANAR_FACE2", "POCKET3"}) {
    with_grid(feature, 5, [&](const TourTask& task) { add_objectives(table, feature, task); });
  }
  table.notes.push_back(
      "deviation: mean |engagement - 50 %|, raster model; the text does not name its feature or its grid");
  return table;
}

TextTable engagement_table() {
  TextTable table;
  table.title =
      "Tour figure 6-15: percent of the moves by mean engagement, POCKET3, 10 mm end mill, grid of 2.5 mm";
  table.columns = {{"target"}, {"model", Align::kLeft}, {"mean %"}};
  for (int bin = 0; bin < 10; ++bin) table.columns.push_back({fmt::format("{}-{}", 10 * bin, 10 * bin + 10)});
  with_grid("POCKET3", 2.5, [&](const TourTask& task) {
    for (int target = 20; target <= 100; target += 20) {
      const auto objective =
          engagement_objective(target / 100.0, [&] { return raster_engagement(engagement_task(task)); });
      const auto solution = solved(grid_problem(task), *objective, 1);
      add_histogram(table, target, "raster", raster_engagement(engagement_task(task))->along(solution.tour));
      add_histogram(table, target, "exact", exact_engagement(engagement_task(task))->along(solution.tour));
    }
  });
  table.notes.push_back("optimised by the raster model, then measured by both; a slot is 100 %");
  return table;
}

}  // namespace clearcut
