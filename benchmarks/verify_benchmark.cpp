// Judging programs: outlines from 100 to 100 000 vertices, one level each, and the contact of a cutter alone.
// Planning and reading back stay outside the clock. A program that is not clean is an error, not a time.
#include <benchmark/benchmark.h>

#include <cmath>

#include "base/random.h"
#include "pipeline/run.h"
#include "stock/material.h"
#include "verify/verify.h"

namespace clearcut {
namespace {

Part wavy_part(int vertices) {
  std::vector<Vec2> points;
  for (int i = 0; i < vertices; ++i) {
    const double a = 2 * kPi * i / vertices;
    points.push_back(direction_of(a) * (100 * (1 + 0.15 * std::sin(5 * a) + 0.05 * std::sin(13 * a + 1))));
  }
  Part part;
  part.name = "wavy";
  Feature feature;
  feature.name = "WAVY";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(points), {})};
  feature.floor_z = -2;
  part.features.push_back(feature);
  part.workplan.push_back({});
  return part;
}

void judge_outline(benchmark::State& state) {
  PlanOptions options;
  options.tools = {resolve::parse_tool("endmill:10")};
  options.strategy = "contour";
  const PlanResult result = pipeline::plan_part(wavy_part(static_cast<int>(state.range(0))), options);
  std::size_t moves = 0;
  for (const Section& section : result.toolpath.sections) moves += section.moves.size();
  for (auto _ : state) {
    const Findings findings = verify::verify_program(result.part, result.toolpath, {});
    if (!findings.all.clean) state.SkipWithError("not clean");
  }
  state.counters["moves"] = static_cast<double>(moves);
  state.counters["feed_mm"] = result.findings.all.feed_mm;
}
BENCHMARK(judge_outline)->RangeMultiplier(10)->Range(100, 100000)->Unit(benchmark::kMillisecond);

/// A cutter that follows a pass at half a diameter among earlier passes of `range` mm moves.
void contact_between_passes(benchmark::State& state) {
  const double radius = 5, step = static_cast<double>(state.range(0)) / 10;
  stock::Material material(std::nullopt, 0, {radius});
  for (double y = 0; y < 50; y += radius) {
    for (double x = 0; x < 200; x += step) {
      material.add({Edge::line({x, y}, {x + step, y}), -1, -1, MoveKind::kCut, MmPerMin::of(1000), 0},
                   radius);
    }
  }
  Random random(1);
  for (auto _ : state) {
    const Vec2 center{random.between(10, 190), 50};
    benchmark::DoNotOptimize(material.engagement(center, {1, 0}, radius, -1).angle);
  }
}
BENCHMARK(contact_between_passes)->Arg(2)->Arg(20)->Arg(500);

}  // namespace
}  // namespace clearcut

BENCHMARK_MAIN();
