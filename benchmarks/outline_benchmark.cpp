// Planning and certifying one pocket of n vertices: the growth from 1 000 to 100 000.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "pipeline/run.h"

namespace {

using namespace clearcut;

/// A wavy round outline of about 300 mm; n vertices.
Part wavy_part(int n) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * kPi * i / n;
    const double r = 150 * (1 + 0.25 * std::sin(5 * t) + 0.03 * std::sin(37 * t) + 0.004 * std::sin(301 * t));
    points.push_back(direction_of(t) * r);
  }
  Feature feature;
  feature.name = "wavy";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(points), {})};
  feature.floor_z = -2;
  Part part;
  part.name = "wavy";
  part.features = {feature};
  Workingstep step;
  step.operation.stepdown = 2;
  part.workplan = {step};
  return part;
}

void plan_and_certify(benchmark::State& state) {
  const Part part = wavy_part(static_cast<int>(state.range(0)));
  PlanOptions options;
  options.tools = {resolve::parse_tool("endmill:6")};
  bool clean = true;
  for (auto _ : state) {
    const auto result = pipeline::plan_part(part, options);
    clean = clean && result.findings.all.clean;
    benchmark::DoNotOptimize(result.program.data());
  }
  state.counters["clean"] = clean ? 1 : 0;
  state.SetComplexityN(state.range(0));
}

}  // namespace

BENCHMARK(plan_and_certify)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond)->Complexity();

BENCHMARK_MAIN();
