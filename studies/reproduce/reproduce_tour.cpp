#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numeric>
#include <optional>

#include "base/file.h"
#include "base/parallel.h"
#include "order/genetic/genetic.h"
#include "order/lattice.h"
#include "order/search/solve.h"
#include "order/tsplib.h"
#include "pipeline/tour/tour.h"
#include "studies/reproduce/reproduce_parts.h"

namespace clearcut::studies {
namespace {

/// Generations without gain that end those runs of which the text says millions of individuals (5.3.2, 6.2.1).
constexpr long long kLongPatience = 40000;
/// "1000 generations without any improvement", 4.3.3.
const long long kPublishedPatience = order::GeneticOptions().patience;

struct Row {
  std::string problem;  ///< a lattice, or a file of the reference instances
  std::string objective = "length";
  double optimum = 0;
  std::string printed;  ///< value, "" where the text gives fitness alone
  double printed_fitness = 0;
  int runs = 1;
  long long generations = 0;
  long long patience = kLongPatience;
};

const std::vector<Row>& rows() {
  // At most 10 million individuals for the instances (6.2.1); lattices need far fewer.
  static const std::vector<Row> all{{"qa194.tsp", "length", 9352, "9737", 96.0, 12, 400000},
                                    {"xit1083.tsp", "length", 3558, "3740", 95.1, 3, 400000},
                                    {"10x10", "turns", 18, "18.33", 98.2, 100, 400000, kPublishedPatience},
                                    {"10x10", "angle", 1620, "1636.8", 99.0, 100, 400000, kPublishedPatience},
                                    {"10x10", "length", 99, "", 99.91, 100, 400000, kPublishedPatience},
                                    {"30x30", "length", 899, "", 97.2, 5, 40000},
                                    {"100x75", "length", 7499, "", 97.52, 1, 40000},
                                    {"100x80", "length", 7999, "", 97.43, 1, 40000},
                                    {"100x100", "length", 9999, "", 97.34, 1, 40000}};
  return all;
}

/// Absent when the file is not there.
std::optional<order::Problem> problem_of(const std::string& name) {
  if (const auto lattice = order::parse_lattice(name)) {
    order::Problem problem = order::lattice_problem(lattice->columns, lattice->rows);
    problem.shape = order::Shape::kOpenPath;
    return problem;
  }
  const char* data = std::getenv("CLEARCUT_DATA");
  if (data == nullptr) return std::nullopt;
  const auto path = std::filesystem::path(data) / "tsp" / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return order::read_tsplib(read_file(path.string()), name);
}

order::GeneticOptions as_published(const Row& row) {
  order::GeneticOptions options;
  options.stop.rounds = row.generations;
  options.patience = row.patience;
  // Nearest-neighbour paths begin at the optimum of a lattice: the first paths are drawn among all near points.
  if (order::parse_lattice(row.problem)) options.breadth = options.neighbours;
  return options;
}

order::GeneticOptions with_assembly(const Row& row) {
  order::GeneticOptions options = as_published(row);
  options.crossover = "eax";
  options.crossover_rate = 0.5;
  return options;
}

struct Mean {
  double value = 0, error = 0;  ///< eq. 4.11 with z = 3
};

Mean mean_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double deviation = values.size() > 1 ? std::sqrt(squares / (n - 1)) : 0;
  return {mean, 3 * deviation / std::sqrt(n)};
}

/// What a run of the algorithm comes to: value, individuals, seconds.
RunFigures run_once(const order::Problem& problem, const Row& row, order::GeneticOptions options) {
  const auto result = order::run_genetic(problem, *pipeline::objective_named(row.objective, 1000), options);
  return {result.value, static_cast<double>(result.children), result.seconds};
}

std::string tour_in_words(const RunFigures& figures) {
  return fmt::format("{:g} after {:.0f} individuals, {:.1f} s", figures[0], figures[1], figures[2]);
}

std::vector<RunFigures> all_runs(const order::Problem& problem, const Row& row, const std::string& method,
                                 order::GeneticOptions (*options_for)(const Row&), TableRuns& runs) {
  std::vector<RunFigures> results(static_cast<std::size_t>(row.runs));
  parallel_for(0, row.runs, [&](int i) {
    order::GeneticOptions options = options_for(row);
    options.seed = static_cast<std::uint64_t>(i) + 1;
    const std::string name =
        fmt::format("{} {}, {}, seed {}", row.problem, row.objective, method, options.seed);
    results[static_cast<std::size_t>(i)] = runs.run(
        name, [&] { return run_once(problem, row, options); }, tour_in_words);
  });
  return results;
}

void add_row(Reproduction& table, const Row& row, const std::string& method,
             order::GeneticOptions (*options_for)(const Row&), TableRuns& runs) {
  const auto problem = problem_of(row.problem);
  runs.tell(fmt::format("{} {}, printed: {:g} %", row.problem, row.objective, row.printed_fitness));
  std::vector<Cell> cells{row.problem, row.objective, fmt::format("{:g}", row.optimum), row.printed,
                          fmt::format("{:.2f}", row.printed_fitness)};
  if (!problem) {
    cells.push_back("no file");
    table.add(cells);
    return;
  }
  std::vector<double> values, fitness;
  double seconds = 0, individuals = 0;
  for (const RunFigures& figures : all_runs(*problem, row, method, options_for, runs)) {
    individuals += figures[1] / row.runs;
    values.push_back(figures[0]);
    fitness.push_back(100 * row.optimum / figures[0]);
    seconds += figures[2] / row.runs;
  }
  const Mean mean = mean_of(fitness);
  const int decimals = row.printed_fitness * 10 == std::round(row.printed_fitness * 10) ? 1 : 2;
  cells.emplace_back(fmt::format("{:.2f}", mean_of(values).value));
  cells.push_back(beside(mean.value, row.printed_fitness, decimals,
                         {"a random algorithm with rates that the text does not state", 0.05}));
  for (const std::string& cell :
       {row.runs > 1 ? fmt::format("{:.2f}", mean.error) : "",
        fmt::format("{:+.2f}", mean.value - row.printed_fitness), std::to_string(row.runs),
        fmt::format("{:.0f}", individuals / 1000), fmt::format("{:.1f}", seconds), method})
    cells.emplace_back(cell);
  table.add(cells);
}

}  // namespace

namespace {

/// Of those whose points are there.
std::size_t run_count(const std::vector<Row>& rows) {
  std::size_t count = 0;
  for (const Row& row : rows) count += problem_of(row.problem) ? static_cast<std::size_t>(row.runs) : 0;
  return count;
}

/// Those rows of the published figures that are lattices, or those that are not.
Reproduction genetic_figures(const char* title, bool are_lattices, const TableWatch& watch) {
  Reproduction result;
  TextTable& table = result.table;
  table.title = title;
  table.columns = {{"points", Align::kLeft},
                   {"objective", Align::kLeft},
                   {"optimum"},
                   {"printed"},
                   {"fitness, %"},
                   {"ours, mean"},
                   {"fitness, %"},
                   {"+-"},
                   {"difference"},
                   {"runs"},
                   {"thousand individuals"},
                   {"s a run"},
                   {"operators", Align::kLeft}};
  const auto is_wanted = [&](const Row& row) {
    return order::parse_lattice(row.problem).has_value() == are_lattices;
  };
  std::vector<Row> published, assembled;
  for (const Row& row : rows())
    if (is_wanted(row)) published.push_back(row);
  for (const std::size_t i : {0u, 2u, 3u, 4u}) {
    Row row = rows()[i];
    row.runs = std::min(row.runs, 8);
    row.generations = 20000;
    row.patience = row.generations;
    if (is_wanted(row)) assembled.push_back(row);
  }
  TableRuns runs(watch, run_count(published) + run_count(assembled));
  for (const Row& row : published) add_row(result, row, "as published", as_published, runs);
  table.add_rule();
  for (const Row& row : assembled) add_row(result, row, "eax", with_assembly, runs);
  table.notes.push_back("fitness = optimum / value; +- is 3 sigma / sqrt(runs), eq. 4.11");
  return result;
}

}  // namespace

Reproduction genetic_instances(const TableWatch& watch) {
  Reproduction result = genetic_figures("Tour table 6.2: the published genetic algorithm", false, watch);
  result.table.notes.push_back(
      "ends after 40000 generations of 25 without gain or the individuals printed (6.2.1)");
  result.table.notes.push_back("reference instances: the folder tsp/ in $CLEARCUT_DATA");
  return result;
}

Reproduction genetic_lattices(const TableWatch& watch) {
  Reproduction result =
      genetic_figures("Tour tables 6.3 and 6.6: the published genetic algorithm on lattices", true, watch);
  result.table.notes.push_back(
      "10x10 ends after 1000 generations of 25 without gain (4.3.3), the others after 40000 or a million "
      "individuals");
  result.table.notes.push_back(
      "first paths are drawn among all near points: plain ones of the nearest neighbour are all but the "
      "optimum of a lattice, so that nothing would be shown");
  return result;
}

Reproduction large_instance(const TableWatch& watch) {
  constexpr double kSeconds = 200, kOptimum = 520527, kPrinted = 540427;
  Reproduction result;
  result.table.title = "Tour table 6.2: FI10639 in the printed 200 s";
  result.table.columns = {
      {"algorithm", Align::kLeft}, {"printed"}, {"length"}, {"optimum / length, %"}, {"s"}};
  result.table.notes.push_back("ends by the clock, so its figures change with the machine and its load");
  const auto problem = problem_of("fi10639.tsp");
  if (!problem) {
    result.add({"fi10639.tsp is not in tsp/ of $CLEARCUT_DATA", "540427", "", "", ""});
    return result;
  }
  const auto length = order::length_objective();
  order::GeneticOptions genetic;
  genetic.stop.seconds = kSeconds;
  genetic.patience = std::numeric_limits<long long>::max();
  TableRuns runs(watch, 2);
  runs.tell("printed: 540427 in 200 s");
  const auto add = [&](const char* name, const std::function<RunFigures()>& make) {
    const RunFigures made = runs.run(name, make, [](const RunFigures& figures) {
      return fmt::format("{:.0f} in {:.0f} s", figures[0], figures[1]);
    });
    result.add({name, "540427",
                beside(made[0], kPrinted, 0, {"another machine, rates that are not printed", 0.05}),
                fmt::format("{:.2f}", 100 * kOptimum / made[0]), fmt::format("{:.0f}", made[1])});
  };
  add("as published", [&] {
    const auto published = order::run_genetic(*problem, *length, genetic);
    return RunFigures{published.value, published.seconds};
  });
  add("ours", [&] {
    order::SolveOptions options;
    options.stop.seconds = kSeconds;
    const auto ours = order::solve(*problem, *length, options);
    return RunFigures{ours.length, ours.seconds};
  });
  return result;
}

}  // namespace clearcut::studies
