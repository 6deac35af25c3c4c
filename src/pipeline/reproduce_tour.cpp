#include "pipeline/reproduce_tour.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numeric>
#include <optional>

#include "base/file.h"
#include "order/genetic/genetic.h"
#include "order/lattice.h"
#include "order/tsplib.h"
#include "pipeline/tour.h"

namespace clearcut {
namespace {

struct Row {
  std::string problem;  ///< a lattice, or a file of the reference instances
  std::string objective = "length";
  double optimum = 0;
  std::string printed;  ///< value, "" where the text gives fitness alone
  double printed_fitness = 0;
  int runs = 1;
  long long generations = 0;  ///< 0: until 1000 generations without gain
};

const std::vector<Row>& rows() {
  static const std::vector<Row> all{{"qa194.tsp", "length", 9352, "9737", 96.0, 5, 0},
                                    {"xit1083.tsp", "length", 3558, "3740", 95.1, 1, 50000},
                                    {"10x10", "turns", 18, "18.33", 98.2, 20, 0},
                                    {"10x10", "angle", 1620, "1636.8", 99.0, 20, 0},
                                    {"10x10", "length", 99, "", 99.91, 20, 0},
                                    {"100x75", "length", 7499, "", 97.52, 1, 5000},
                                    {"100x80", "length", 7999, "", 97.43, 1, 5000},
                                    {"100x100", "length", 9999, "", 97.34, 1, 5000}};
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

/// The text's algorithm; reference instances draw mutations from all points (5.3.2).
order::GeneticOptions as_published(const Row& row, const order::Problem& problem) {
  order::GeneticOptions options;
  options.neighbours = problem.closed() ? 0 : problem.neighbour_count;
  if (row.generations > 0) {
    options.stop.rounds = row.generations;
    options.patience = std::numeric_limits<long long>::max();
  }
  return options;
}

void add_row(TextTable& table, const Row& row, const std::string& method,
             const std::function<order::GeneticOptions(const order::Problem&)>& options_for) {
  const auto problem = problem_of(row.problem);
  std::vector<std::string> cells{row.problem, row.objective, fmt::format("{:g}", row.optimum), row.printed,
                                 fmt::format("{:.2f}", row.printed_fitness)};
  if (!problem) {
    cells.push_back("no file");
    table.add(cells);
    return;
  }
  std::vector<order::GeneticResult> results(static_cast<std::size_t>(row.runs));
  tbb::parallel_for(0, row.runs, [&](int i) {
    order::GeneticOptions options = options_for(*problem);
    options.seed = static_cast<std::uint64_t>(i) + 1;
    results[static_cast<std::size_t>(i)] =
        order::run_genetic(*problem, *objective_named(row.objective, 1000), options);
  });
  double value = 0, fitness = 0, seconds = 0, generations = 0;
  for (const auto& result : results) {
    value += result.value / row.runs;
    fitness += 100 * row.optimum / result.value / row.runs;
    seconds += result.seconds / row.runs;
    generations += static_cast<double>(result.generations) / row.runs;
  }
  for (const std::string& cell :
       {fmt::format("{:.2f}", value), fmt::format("{:.2f}", fitness),
        fmt::format("{:+.2f}", fitness - row.printed_fitness), std::to_string(row.runs),
        fmt::format("{:.0f}", generations), fmt::format("{:.1f}", seconds), method})
    cells.push_back(cell);
  table.add(cells);
}

}  // namespace

TextTable genetic_figures() {
  TextTable table;
  table.title = "Tour tables 6.2, 6.3, 6.6: the published genetic algorithm";
  table.columns = {{"points", Align::kLeft},
                   {"objective", Align::kLeft},
                   {"optimum"},
                   {"printed"},
                   {"fitness, %"},
                   {"ours, mean"},
                   {"fitness, %"},
                   {"difference"},
                   {"runs"},
                   {"generations"},
                   {"s a run"},
                   {"operators", Align::kLeft}};
  for (const Row& row : rows())
    add_row(table, row, "as published",
            [&](const order::Problem& problem) { return as_published(row, problem); });
  table.add_rule();
  for (const std::size_t i : {0u, 2u, 3u, 4u}) {
    Row row = rows()[i];
    row.runs = std::min(row.runs, 8);
    add_row(table, row, "eax, parent", [&](const order::Problem& problem) {
      order::GeneticOptions options = as_published(row, problem);
      options.crossover = "eax";
      options.replacement = "parent";
      options.crossover_rate = 0.5;
      return options;
    });
  }
  table.notes.push_back(
      "fitness = optimum / value; 1000 generations without gain end a run, except on the larger sets, where "
      "the "
      "generations are given to stay quick");
  table.notes.push_back("reference instances: the folder tsp/ in $CLEARCUT_DATA");
  return table;
}

}  // namespace clearcut
