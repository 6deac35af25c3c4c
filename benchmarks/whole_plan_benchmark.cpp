// Whole plans, certificate included, of parts that were slow once: pockets with many islands, whose links and checks grew
// with the square of their number, and rooms joined by corridors that are hardly wider than the cutter.
#include <benchmark/benchmark.h>

#include "pipeline/run.h"

namespace clearcut {
namespace {

Part pocket_of(const Region& region) {
  Part part;
  part.name = "pocket";
  Feature feature;
  feature.name = "POCKET";
  feature.target = feature.allowed = {region};
  feature.floor_z = -1;
  part.features.push_back(feature);
  part.workplan.push_back({});
  return part;
}

void plan(benchmark::State& state, const Part& part, const char* tool, const char* strategy) {
  PlanOptions options;
  options.tools = {resolve::parse_tool(tool)};
  options.strategy = strategy;
  std::size_t moves = 0;
  for (auto _ : state) {
    const PlanResult result = pipeline::plan_part(part, options);
    if (!result.findings.faults.empty()) state.SkipWithError("not clean");
    moves = 0;
    for (const Section& section : result.toolpath.sections) moves += section.moves.size();
  }
  state.counters["moves"] = static_cast<double>(moves);
}

/// `range` times as many square islands of 5 mm, 12 mm apart.
void contour_round_islands(benchmark::State& state) {
  const int along = static_cast<int>(state.range(0));
  const double side = 12 * along;
  std::vector<Loop> islands;
  for (int i = 0; i < along * along; ++i) {
    const double x = 3.5 + 12 * (i % along), y = 3.5 + 12 * (i / along);
    islands.push_back(loop_from_points(std::vector<Vec2>{{x, y}, {x, y + 5}, {x + 5, y + 5}, {x + 5, y}}));
  }
  const Loop outer = loop_from_points(std::vector<Vec2>{{0, 0}, {side, 0}, {side, side}, {0, side}});
  plan(state, pocket_of(Region::from_valid_loops(outer, islands)), "endmill:3", "contour");
}
BENCHMARK(contour_round_islands)->Arg(5)->Arg(10)->Arg(20)->Arg(30)->Unit(benchmark::kMillisecond);

/// A corridor `range` um wider than the cutter.
void adaptive_through_a_corridor(benchmark::State& state) {
  const double half = 5 + static_cast<double>(state.range(0)) / 2000;
  const std::vector<Vec2> points{{0, 0},    {60, 0},   {60, 30 - half},  {160, 30 - half}, {160, 0}, {220, 0},
                                 {220, 60}, {160, 60}, {160, 30 + half}, {60, 30 + half},  {60, 60}, {0, 60}};
  plan(state, pocket_of(Region::from_valid_loops(loop_from_points(points), {})), "endmill:10", "adaptive");
}
BENCHMARK(adaptive_through_a_corridor)->Arg(5)->Arg(50)->Arg(300)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace clearcut

BENCHMARK_MAIN();
