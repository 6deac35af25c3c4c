#include "studies/reproduce_orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "geometry/boolean.h"
#include "order/lattice.h"
#include "order/solve.h"
#include "pipeline/tour/tour_solver.h"
#include "plan/common/layers.h"
#include "resolve/prepare.h"
#include "studies/fishhead.h"
#include "studies/published_grids.h"

namespace clearcut::studies {
namespace {

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

void add_lattice(report::TextTable& table, const std::string& size, const std::string& measure,
                 const std::string& printed, const Worst& worst, int seeds) {
  table.add({size, measure, printed, fmt::format("{:.0f}", worst.value), fmt::format("{:.0f}", worst.bound),
             std::to_string(seeds), fmt::format("{:.3f}", worst.seconds)});
}

constexpr double kEndMill = 10;  // mm

struct Sum {
  double length = 0, angle = 0;
  int turns = 0;
  Sum& operator+=(const Sum& o) {
    length += o.length, angle += o.angle, turns += o.turns;
    return *this;
  }
  Sum operator*(int n) const { return {length * n, angle * n, turns * n}; }
};

/// Length, turns and angle of the published grid of a layer in the order that the objective asks for.
Sum grid_figures(const Layer& layer, double pitch, const order::Objective& objective) {
  Sum sum;
  ask_published(layer, pitch, [&](const plan::tour::TourTask& task) {
    const auto solution = solved(pipeline::grid_problem(task), objective, 1, 1);
    sum += {solution.length, solution.angle_deg, solution.turns};
    return solution.tour;
  });
  return sum;
}

/// How the printed job may be read: grids of half a diameter or a diameter.
struct Reading {
  const char* name;
  double face_pitch, pocket_pitch;  ///< mm
};

/// And which layers count: one a feature, those that still hold material, all from the top of a feature's stock.
struct Job {
  Sum one_layer, with_material, all_layers;
};

/// Layers of a step that earlier steps have not all but cleared.
int layers_with_material(const std::vector<Layer>& layers, const std::vector<Layer>& cut_before) {
  constexpr double kAllBut = 0.1;
  int count = 0;
  for (const Layer& layer : layers) {
    Regions rest = layer.target;
    for (const Layer& earlier : cut_before) {
      if (earlier.z <= layer.z + 1e-9) rest = subtract(rest, earlier.target, {});
    }
    count += area(rest) > kAllBut * area(layer.target) ? 1 : 0;
  }
  return count;
}

Job fishhead_figures(const Reading& reading, const order::Objective& objective) {
  resolve::PlanOptions options;
  options.stepdown = 2;
  const Part part = resolve::prepare(fishhead(false, {}), options);
  Job job;
  std::vector<Layer> cut_before;  // the last layer of each step
  for (const auto& step : part.workplan) {
    const double radius = tool_of(part, step).radius();
    auto layers = plan::layers_of(feature_of(part, step), step.operation, radius, {});
    if (layers.empty()) continue;
    const double pitch = radius > kEndMill ? reading.face_pitch : reading.pocket_pitch;
    // All layers have the same outline, so the same tour serves them all. Open sides: the target's own outline,
    // as published (a closed pocket made of it).
    Layer layer = layers.front();
    layer.allowed = layer.target;
    const Sum one = grid_figures(layer, pitch, objective);
    job.one_layer += one;
    job.with_material += one * layers_with_material(layers, cut_before);
    job.all_layers += one * static_cast<int>(layers.size());
    cut_before.push_back(layers.back());
  }
  return job;
}

void add_reading(report::TextTable& table, const std::string& name, const Sum& rows, const Sum& spiral) {
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

}  // namespace

report::TextTable lattice_table() {
  report::TextTable table;
  table.title = "Tour tables 6.3 and 6.6: lattices, open paths; ours is the worst over all seeds";
  table.columns = {{"lattice", report::Align::kLeft},
                   {"measure", report::Align::kLeft},
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

report::TextTable fishhead_table() {
  constexpr std::array<Reading, 2> kReadings{{{"50 % of D", 20, 5}, {"D", 40, 10}}};
  report::TextTable table;
  table.title = "Tour table 6.5: the fishhead, 40 mm face mill and 10 mm end mill, layers of 2 mm";
  table.columns = {{"reading", report::Align::kLeft},
                   {"feed, bidirectional"},
                   {"turns"},
                   {"feed, spiral"},
                   {"turn angle, deg"},
                   {"feed / printed"}};
  table.add({"printed: GA", "25282", "423", "24103", "34686", "1.00"});
  table.add({"printed: NX", "24950", "415", "23830", "34090", "0.99"});
  table.add({"printed: FeatureCAM", "24395", "412", "23740", "34358", "0.96"});
  table.add({"printed: MasterCAM", "25030", "431", "24010", "35670", "0.99"});
  table.add_rule();
  for (const auto& reading : kReadings) {
    const Job rows = fishhead_figures(reading, *seeded("turns"));
    const Job spiral = fishhead_figures(reading, *seeded("angle"));
    add_reading(table, fmt::format("{}, layers that hold material", reading.name), rows.with_material,
                spiral.with_material);
    add_reading(table, fmt::format("{}, every 2 mm layer", reading.name), rows.all_layers, spiral.all_layers);
    add_reading(table, fmt::format("{}, one layer a feature", reading.name), rows.one_layer,
                spiral.one_layer);
  }
  table.notes.push_back(
      "nearest to print: a grid of D (what 4.2.4 takes without an engagement) in the layers that still hold "
      "material: FACE2 to -12 mm leaves FACE3 six layers of its eleven");
  table.notes.push_back("grids as published: they leave a rim; entries and moves between areas are not in");
  table.notes.push_back(
      "the certified clean job: clearcut plan examples/fishhead.p21 --strategy tour --stepdown 2");
  return table;
}

}  // namespace clearcut::studies
