#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "order/lattice.h"
#include "order/search/solve.h"
#include "pipeline/tour/tour_solver.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "resolve/resolve.h"
#include "studies/fishhead.h"
#include "studies/reproduce/printed_figures.h"
#include "studies/reproduce/published_comparisons.h"
#include "studies/reproduce/reproduce_parts.h"

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

/// What the text prints of its own algorithm and of its rival's (Car); "" where it prints nothing.
struct PrintedLattice {
  std::string value;
  std::string seconds = "";
  std::string rival = "";
  std::string rival_seconds = "";
};

/// What is proven to be the optimum explains print that is no better.
Cell answer(const std::string& ours, const std::string& printed, bool is_share, bool proven) {
  if (printed.empty()) return ours;
  const double better = std::stod(ours) - std::stod(printed);
  const bool explained = proven && (is_share ? better >= 0 : better <= 0);
  return beside(ours, printed, explained ? Agreement::kExplained : Agreement::kDiffers,
                "ours is proven to be the optimum");
}

/// Another machine and another search explain less time than print, not more.
Cell seconds_beside(double ours, const std::string& printed) {
  const std::string text = fmt::format("{:.3f}", ours);
  if (printed.empty()) return text;
  return beside(text, printed, ours <= std::stod(printed) ? Agreement::kExplained : Agreement::kDiffers,
                "another machine and another search, which takes less time");
}

void add_lattice(Reproduction& result, const std::string& size, const std::string& measure,
                 const PrintedLattice& printed, const Worst& worst, int seeds) {
  const bool is_share = printed.value.ends_with("%");
  const std::string share = fmt::format("{:.2f} %", 100 * worst.bound / worst.value);
  const bool proven = worst.value <= worst.bound * (1 + 1e-9);
  result.add({size, measure, printed.rival, printed.rival_seconds, printed.value, printed.seconds,
              answer(is_share ? share : fmt::format("{:.0f}", worst.value), printed.value, is_share, proven),
              fmt::format("{:.0f}", worst.bound), std::to_string(seeds),
              seconds_beside(worst.seconds, printed.seconds)});
}

constexpr double kOrdersMill = 10;  // mm

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
  bool is_enlarged = false;  ///< open faces as closed pockets that are a diameter larger all round, 7.6
};

/// And which layers count: one a feature, those that still hold material, all from the top of a feature's stock.
struct Job {
  Sum one_layer, with_material, all_layers;
};

/// The outline of an open layer as a closed pocket "with slightly larger dimensions" (7.6): a rectangle that reaches `by` mm
/// beyond it on all sides, less its islands.
Regions enlarged(const Regions& open, double by) {
  const Box all = box(open);
  const Vec2 low = all.min - Vec2{by, by}, high = all.max + Vec2{by, by};
  const std::vector<Vec2> corners{low, {high.x, low.y}, high, {low.x, high.y}};
  Regions result{Region::from_valid_loops(loop_from_points(corners), {})};
  for (const Region& region : open)
    for (const Loop& island : region.islands())
      result = subtract(result, {Region::from_valid_loops(reversed(island), {})}, {});
  return result;
}

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
  PlanOptions options;
  options.stepdown = 2;
  const Part part = resolve::prepare(fishhead(false, {}), options);
  Job job;
  std::vector<Layer> cut_before;  // the last layer of each step
  for (const auto& step : part.workplan) {
    const double radius = tool_of(part, step).radius();
    auto layers = plan::layers_of(feature_of(part, step), step.operation, radius, {});
    if (layers.empty()) continue;
    const double pitch = radius > kOrdersMill ? reading.face_pitch : reading.pocket_pitch;
    // All layers have the same outline, so the same tour serves them all. Open sides: the target's own outline,
    // as published (a closed pocket made of it).
    Layer layer = layers.front();
    if (reading.is_enlarged && !plan::closed_all_round(layer))
      layer.target = enlarged(layer.target, 2 * radius);
    layer.allowed = layer.target;
    const Sum one = grid_figures(layer, pitch, objective);
    job.one_layer += one;
    job.with_material += one * layers_with_material(layers, cut_before);
    job.all_layers += one * static_cast<int>(layers.size());
    cut_before.push_back(layers.back());
  }
  return job;
}

/// `nearest`: the reading that is compared with print.
void add_reading(Reproduction& result, const std::string& name, const Sum& rows, const Sum& spiral,
                 bool nearest) {
  const auto cell = [&](double value, int printed) {
    if (!nearest) return Cell(fmt::format("{:.0f}", value));
    return beside(value, printed, 0,
                  {"the text states neither its grid nor its layers; no links between areas in ours", 0.25});
  };
  constexpr const PrintedJob& printed = kPrintedJobs.front();
  result.add({name, cell(rows.length, printed.feed), "", "", cell(rows.turns, printed.turns),
              cell(spiral.length, printed.spiral_feed), "", "", cell(spiral.angle, printed.angle),
              fmt::format("{:.2f}", rows.length / printed.feed)});
}

/// Totals are held against the sum of feed and rapid moves.
Cell total_of(int feed, int rapid, int printed) {
  Cell cell = of_print(feed + rapid, printed, 0,
                       {fmt::format("feed and rapid moves add up to {}", feed + rapid), 0.01});
  cell.text = fmt::format("{}{}", printed, feed + rapid == printed ? "" : " *");
  return cell;
}

void add_printed_jobs(Reproduction& result) {
  for (const PrintedJob& job : kPrintedJobs) {
    result.add({fmt::format("printed: {}", job.name), std::to_string(job.feed), std::to_string(job.rapid),
                total_of(job.feed, job.rapid, job.total), std::to_string(job.turns),
                std::to_string(job.spiral_feed), std::to_string(job.spiral_rapid),
                total_of(job.spiral_feed, job.spiral_rapid, job.spiral_total), std::to_string(job.angle),
                fmt::format("{:.2f}", static_cast<double>(job.feed) / kPrintedJobs.front().feed)});
  }
}

/// Layers of 2 mm of a feature by the end mill.
std::vector<Layer> layers_of_feature(const std::string& feature) {
  PlanOptions options;
  options.stepdown = 2;
  const Part part = resolve::prepare(fishhead(false, {}), options);
  std::vector<Layer> all;
  for (const auto& step : part.workplan) {
    if (feature_of(part, step).name != feature) continue;
    for (Layer& layer : plan::layers_of(feature_of(part, step), step.operation, kOrdersMill / 2, {}))
      all.push_back(std::move(layer));
  }
  return all;
}

/// Points of a feature's largest grid for the end mill; open layers enlarged by `by` mm.
std::size_t grid_points(const std::string& feature, double pitch, double by) {
  std::vector<Layer> layers = layers_of_feature(feature);
  if (layers.empty()) return 0;
  Layer& layer = layers.front();
  layer.tool_radius = kOrdersMill / 2;
  if (!plan::closed_all_round(layer)) layer.target = enlarged(layer.target, by);
  layer.allowed = layer.target;
  std::size_t largest = 0;
  with_largest_grid(layer, pitch, [&](const plan::tour::TourTask& task) {
    largest = std::max(largest, task.points.size());
  });
  return largest;
}

order::ObjectivePtr seeded(const char* kind) {
  // Among tours of equal turns or angle the shorter one, as the text's multi-objective fitness.
  const auto main = std::string(kind) == "turns" ? order::turns_objective() : order::angle_objective();
  const double weight = std::string(kind) == "turns" ? 20 : 0.2;
  return order::weighted_sum({{weight, main}, {1, order::length_objective()}});
}

}  // namespace

Reproduction lattice_table() {
  Reproduction result;
  TextTable& table = result.table;
  table.title = "Tour tables 6.3 and 6.6: lattices, open paths; ours is the worst over all seeds";
  table.columns = {{"lattice", Align::kLeft},
                   {"measure", Align::kLeft},
                   {"Car"},
                   {"s"},
                   {"printed"},
                   {"s"},
                   {"ours"},
                   {"bound"},
                   {"seeds"},
                   {"longest s"}};
  const auto ten = open_lattice(10, 10);
  add_lattice(result, "10x10", "turns", {"18.33"}, worst_of(ten, *order::turns_objective(), 100), 100);
  add_lattice(result, "10x10", "angle, deg", {"1636.8"}, worst_of(ten, *order::angle_objective(), 100), 100);
  const std::tuple<int, int, PrintedLattice> sizes[] = {{10, 10, {"99.91 %", "0.52", "91.31 %", "15.00"}},
                                                        {100, 100, {"97.34 %", "13.71", "90.78 %", "54.85"}},
                                                        {100, 75, {"97.52 %", "11.23", "89.39 %", "146.33"}},
                                                        {100, 80, {"97.43 %", "11.90", "90.71 %", "156.00"}}};
  for (const auto& [columns, rows, printed] : sizes) {
    const auto problem = open_lattice(columns, rows);
    const std::string size = fmt::format("{}x{}", columns, rows);
    const auto length = worst_of(problem, *order::length_objective(), 3);
    add_lattice(result, size, "length", printed, length, 3);
    add_lattice(result, size, "turns", {}, worst_of(problem, *order::turns_objective(), 3), 3);
    add_lattice(result, size, "angle, deg", {}, worst_of(problem, *order::angle_objective(), 3), 3);
  }
  table.notes.push_back(
      "printed percentages are the text's fitness: optimum / result; Car: its rival, table 6.6");
  return result;
}

Reproduction fishhead_table() {
  constexpr std::array<Reading, 3> kReadings{
      {{"50 % of D", 20, 5}, {"50 % of D, faces enlarged (7.6)", 20, 5, true}, {"D", 40, 10}}};
  Reproduction result;
  TextTable& table = result.table;
  table.title = "Tour table 6.5: the fishhead, 40 mm face mill and 10 mm end mill, layers of 2 mm";
  table.columns = {{"reading", Align::kLeft},
                   {"feed, bidirectional"},
                   {"rapid"},
                   {"total"},
                   {"turns"},
                   {"feed, spiral"},
                   {"rapid"},
                   {"total"},
                   {"turn angle, deg"},
                   {"feed / printed"}};
  add_printed_jobs(result);
  result.add_rule();
  for (const auto& reading : kReadings) {
    const Job rows = fishhead_figures(reading, *seeded("turns"));
    const Job spiral = fishhead_figures(reading, *seeded("angle"));
    const bool nearest = reading.pocket_pitch == kOrdersMill;
    add_reading(result, fmt::format("{}, layers that hold material", reading.name), rows.with_material,
                spiral.with_material, nearest);
    add_reading(result, fmt::format("{}, every 2 mm layer", reading.name), rows.all_layers, spiral.all_layers,
                false);
    add_reading(result, fmt::format("{}, one layer a feature", reading.name), rows.one_layer,
                spiral.one_layer, false);
  }
  table.notes.push_back(
      "nearest to print: a grid of D (what 4.2.4 takes without an engagement) in the layers that still hold "
      "material: FACE2 to -12 mm leaves FACE3 six layers of its eleven");
  table.notes.push_back(
      "*: the printed total of the text's own bidirectional row is 52 mm more than its two parts");
  table.notes.push_back(
      "grids as published: they leave a rim; entries and moves between areas are not in: rapid and total of "
      "our programs are in fishhead-published");
  table.notes.push_back(
      "faces enlarged: the grid with 1101 points on FACE2, where 5.3.2 says 1096; it cannot be that of the "
      "printed lengths in all layers");
  table.notes.push_back(
      "the certified clean job: clearcut plan examples/fishhead.p21 --strategy tour --stepdown 2");
  return result;
}

Reproduction grid_points_table() {
  Reproduction result;
  result.table.title = "Tour 5.3.2: points of the largest feature of the fishhead, 10 mm end mill";
  result.table.columns = {{"grid", Align::kLeft}, {"printed"}, {"FACE2, ours"}, {"FACE3"}, {"FACE4"}};
  const auto add = [&](const char* name, double pitch, double by, const char* printed) {
    const auto ours = [&](const char* face) { return std::to_string(grid_points(face, pitch, by)); };
    const std::string second = ours("PLANAR_FACE2");
    result.add({name, printed,
                *printed == 0
                    ? Cell(second)
                    : beside(std::stod(second), std::stod(printed), 0,
                             {"the outline of FACE2 is that of the printed program; how far faces are "
                              "enlarged is not printed",
                              0.02}),
                ours("PLANAR_FACE3"), ours("PLANAR_FACE4")});
  };
  constexpr int kPrintedPoints = 1096;
  add("50 % of D, faces enlarged by D (7.6)", kOrdersMill / 2, kOrdersMill,
      std::to_string(kPrintedPoints).c_str());
  add("50 % of D, faces enlarged by R", kOrdersMill / 2, kOrdersMill / 2, "");
  add("50 % of D, faces as closed pockets", kOrdersMill / 2, 0, "");
  add("D, faces enlarged by D", kOrdersMill, kOrdersMill, "");
  result.table.notes.push_back(
      "the printed number pins the grid of table 6.5: half a diameter, faces enlarged by a diameter, so that "
      "the cutter goes round outside the stock; a whole diameter has a quarter of the points");
  const std::size_t layers = layers_of_feature("PLANAR_FACE2").size();
  const double least = (kPrintedPoints - 1) * kOrdersMill / 2 * static_cast<double>(layers) / 1000;
  result.table.notes.push_back(
      fmt::format("the text's own figures exclude each other: {} points {:g} mm apart in the {} layers of "
                  "FACE2 take at least "
                  "{:.1f} m of feed in any order, and table 6.5 prints {:.1f} m for all features together",
                  kPrintedPoints, kOrdersMill / 2, layers, least, kPrintedJobs.front().feed / 1000.0));
  return result;
}

}  // namespace clearcut::studies
