// Reference instances under a time limit: how near the best known length, after how long, with how much memory.
//
//   tour_benchmark DATA [NAME [SEEDS [SECONDS [THREADS]]]]        DATA: folder with qa194.tsp and the others
//   tour_benchmark lattices                                       lattices against their proven bounds
//   tour_benchmark random POINTS SECONDS [THREADS]                random points, best so far as time passes
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/file.h"
#include "base/random.h"
#include "order/lattice.h"
#include "order/search/solve.h"
#include "order/tsplib.h"

namespace {

using namespace clearcut;

struct Instance {
  const char* name;
  double best_known;
  double seconds;
  int seeds;
};

/// The time limits are those that the figures are promised for.
constexpr Instance kInstances[] = {{"berlin52", 7542, 1, 20}, {"qa194", 9352, 1, 20},
                                   {"a280", 2579, 1, 10},     {"pcb442", 50778, 2, 10},
                                   {"xit1083", 3558, 5, 10},  {"pr2392", 378032, 10, 3},
                                   {"rl5915", 565530, 30, 1}, {"fi10639", 520527, 60, 1}};

/// Seconds of all threads of this process so far.
double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

long peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

void run(const Instance& instance, const order::Problem& problem, int threads) {
  for (int seed = 1; seed <= instance.seeds; ++seed) {
    order::SolveOptions options;
    options.stop.seconds = instance.seconds;
    options.seed = static_cast<std::uint64_t>(seed);
    options.threads = threads;
    double wall_to_best = 0, cpu_to_best = 0;
    const double cpu_before = cpu_seconds();
    options.progress = [&](const order::Progress& progress) {
      wall_to_best = progress.seconds;
      cpu_to_best = cpu_seconds() - cpu_before;
    };
    const auto solution = order::solve(problem, *order::length_objective(), options);
    fmt::print("{:9} {:6} {:4} {:9.0f} {:9.0f} {:8.4f} {:9.3f} {:9.2f} {:9.2f} {:9.2f} {:9.2f} {:6}  {}\n",
               instance.name, problem.size(), seed, solution.length, instance.best_known,
               100 * (solution.length / instance.best_known - 1), 100 * solution.gap, wall_to_best,
               cpu_to_best, solution.seconds, cpu_seconds() - cpu_before, peak_megabytes(), solution.method);
    std::fflush(stdout);
  }
}

void run_files(const std::filesystem::path& folder, const std::string& only, int seeds, double seconds,
               int threads) {
  fmt::print("{:9} {:>6} {:>4} {:>9} {:>9} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>6}  {}\n", "instance",
             "points", "seed", "length", "known", "over %", "bound %", "best s", "cpu s", "end s", "cpu s",
             "MB", "method");
  for (Instance instance : kInstances) {
    if (!only.empty() && only != instance.name) continue;
    if (seeds > 0) instance.seeds = seeds;
    if (seconds > 0) instance.seconds = seconds;
    const auto path = folder / fmt::format("{}.tsp", instance.name);
    run(instance, order::read_tsplib(read_file(path.string()), path.string()), threads);
  }
}

/// Longest time and how many of the seeds end at the bound; open paths.
void run_lattice(int columns, int rows, const order::ObjectivePtr& objective, int seeds) {
  order::Problem problem = order::lattice_problem(columns, rows);
  problem.shape = order::Shape::kOpenPath;
  double longest = 0, worst = 0, bound = 0;
  int at_bound = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    order::SolveOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    options.stop.seconds = 5;
    const auto solution = order::solve(problem, *objective, options);
    longest = std::max(longest, solution.seconds);
    worst = std::max(worst, solution.objective);
    bound = solution.bound;
    at_bound += solution.gap == 0 ? 1 : 0;
  }
  fmt::print("{:>4}x{:<4} {:7} {:10.0f} {:10.0f} {:4} of {:3} {:9.4f} {:6}\n", columns, rows,
             objective->name(), worst, bound, at_bound, seeds, longest, peak_megabytes());
}

void run_lattices() {
  fmt::print("{:>9} {:7} {:>10} {:>10} {:>11} {:>9} {:>6}\n", "lattice", "", "worst", "bound", "at bound",
             "longest s", "MB");
  for (const auto& [columns, rows, seeds] : {std::array{10, 10, 100}, std::array{100, 75, 10},
                                             std::array{100, 80, 10}, std::array{100, 100, 10}}) {
    for (const auto& objective :
         {order::length_objective(), order::turns_objective(), order::angle_objective()})
      run_lattice(columns, rows, objective, seeds);
  }
}

void run_random(int points, double seconds, int threads) {
  order::Problem problem;
  problem.name = "random";
  Random random(1);
  for (int i = 0; i < points; ++i) problem.points.push_back({1000 * random.unit(), 1000 * random.unit()});
  order::SolveOptions options;
  options.stop.seconds = seconds;
  options.threads = threads;
  // Random uniform: the optimum is near 0.7124 sqrt(n A).
  const double expected = 0.7124 * std::sqrt(static_cast<double>(points)) * 1000;
  options.progress = [&](const order::Progress& progress) {
    fmt::print("{:9.2f} s {:14.3f} {:+8.3f} % of the expected optimum\n", progress.seconds,
               progress.objective, 100 * (progress.objective / expected - 1));
    std::fflush(stdout);
  };
  const auto solution = order::solve(problem, *order::length_objective(), options);
  fmt::print("{} points: {:.3f}, bound {:.3f}, {:.2f} s, {} MB, {}\n", points, solution.length,
             solution.bound, solution.seconds, peak_megabytes(), solution.method);
}

}  // namespace

int main(int count, char** arguments) {
  const auto text = [&](int i, const char* absent) { return std::string(i < count ? arguments[i] : absent); };
  const auto number = [&](int i) { return std::atof(text(i, "0").c_str()); };
  if (text(1, "") == "lattices") {
    run_lattices();
  } else if (text(1, "") == "random") {
    run_random(static_cast<int>(number(2)), number(3), static_cast<int>(number(4)));
  } else {
    run_files(text(1, "."), text(2, ""), static_cast<int>(number(3)), number(4), static_cast<int>(number(5)));
  }
}
