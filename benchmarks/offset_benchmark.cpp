// Inward offsets at 3, 6, 9, ... mm until nothing is left, beside polyclipping and GEOS on the same inputs in
// the same process. Peers get arcs cut to 0.5 um and the same as the tolerance of their own round corners;
// the conversion of the input into their types stays outside the clock, building the diagram inside. Every
// row's total area is compared with ours: a row that differs by more than 1e-3 is an error, not a time.
//
// polyclipping needs minutes for all levels from 10 000 vertices on: there it does the first level alone, and
// so does a row of ours beside it.
#include <benchmark/benchmark.h>
#include <geos_c.h>

#include <cmath>
#include <map>
#include <polyclipping/clipper.hpp>
#include <string>

#include "base/units.h"
#include "geometry/voronoi/clearance.h"
#include "studies/fishhead.h"

namespace clearcut {
namespace {

constexpr double kStep = 3.0;
constexpr double kArcTolerance = 0.0005;
constexpr double kClipperUnit = 1e-4;
const Tolerances kTol;

struct Input {
  std::string name;
  Region region;
  int vertices = 0;
};

Loop wavy_loop(int n) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n;
    const double r =
        60 * (1 + 0.15 * std::sin(5 * a) + 0.05 * std::sin(13 * a + 1) + 0.02 * std::sin(31 * a + 2));
    points.push_back(direction_of(a) * r);
  }
  return loop_from_points(points);
}

Loop circle(Vec2 c, double r) {
  const BulgeVertex vertices[] = {{c - Vec2{r, 0}, 1}, {c + Vec2{r, 0}, 1}};
  return loop_from_bulges(vertices);
}

Input wavy(int n) {
  return {"wavy " + std::to_string(n), Region::from_valid_loops(wavy_loop(n), {}), n};
}

Input filleted_rectangle() {
  const double w = 150, h = 100, r = 12, q = std::tan(kPi / 8);
  const BulgeVertex v[] = {{{r, 0}, 0},     {{w - r, 0}, q}, {{w, r}, 0},     {{w, h - r}, q},
                           {{w - r, h}, 0}, {{r, h}, q},     {{0, h - r}, 0}, {{0, r}, q}};
  return {"filleted rectangle", Region::from_valid_loops(loop_from_bulges(v), {}), 8};
}

Input wavy_with_islands() {
  std::vector<Loop> islands;
  for (int i = 0; i < 20; ++i) {
    islands.push_back(circle(direction_of(2 * kPi * i / 20) * (i % 2 == 0 ? 22.0 : 38.0), 2.0 + 0.1 * i));
  }
  return {"wavy 1000 with 20 round islands", Region::from_valid_loops(wavy_loop(1000), islands), 1040};
}

/// The pockets of the fishhead part, levels 5, 5.5, 6 ... mm: its 10 mm cutter at small steps.
void register_fishhead() {
  for (const Feature& feature : studies::fishhead(false, kTol).features) {
    if (feature.kind != FeatureKind::kClosedPocket) continue;
    const Region region = feature.target.front();
    benchmark::RegisterBenchmark(("fishhead " + feature.name).c_str(), [region](benchmark::State& state) {
      std::vector<double> levels;
      for (double d = 5; d < Clearance(region, kTol).max(); d += 0.5) levels.push_back(d);
      double sum = 0;
      for (auto _ : state) {
        for (const Regions& level : Clearance(region, kTol).insets(levels)) sum += area(level);
      }
      benchmark::DoNotOptimize(sum);
      state.counters["levels"] = static_cast<double>(levels.size());
    })->Unit(benchmark::kMicrosecond);
  }
}

std::vector<double> levels_of(const Region& region, std::size_t most) {
  std::vector<double> levels;
  const double largest = Clearance(region, kTol).max();
  for (double d = kStep; d < largest && levels.size() < most; d += kStep) levels.push_back(d);
  return levels;
}

double our_area(const Region& region, const std::vector<double>& levels) {
  double sum = 0;
  for (const Regions& level : Clearance(region, kTol).insets(levels)) sum += area(level);
  return sum;
}

ClipperLib::Paths clipper_input(const Region& region) {
  ClipperLib::Paths paths;
  std::vector<Loop> loops = region.islands();
  loops.push_back(region.outer());
  for (const Loop& loop : loops) {
    ClipperLib::Path path;
    for (const Vec2 p : flattened(loop, kArcTolerance)) {
      path.push_back({std::llround(p.x / kClipperUnit), std::llround(p.y / kClipperUnit)});
    }
    paths.push_back(path);
  }
  return paths;
}

double polyclipping_area(const ClipperLib::Paths& input, const std::vector<double>& levels) {
  double sum = 0;
  for (const double d : levels) {
    ClipperLib::ClipperOffset offset(2, kArcTolerance / kClipperUnit);
    offset.AddPaths(input, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    ClipperLib::Paths out;
    offset.Execute(out, -d / kClipperUnit);
    for (const auto& path : out) sum += ClipperLib::Area(path) * kClipperUnit * kClipperUnit;
  }
  return sum;
}

GEOSGeometry* geos_ring(const Loop& loop) {
  std::vector<Vec2> points = flattened(loop, kArcTolerance);
  points.push_back(points.front());
  GEOSCoordSequence* sequence = GEOSCoordSeq_create(static_cast<unsigned>(points.size()), 2);
  for (unsigned i = 0; i < points.size(); ++i) GEOSCoordSeq_setXY(sequence, i, points[i].x, points[i].y);
  return GEOSGeom_createLinearRing(sequence);
}

GEOSGeometry* geos_input(const Region& region) {
  std::vector<GEOSGeometry*> holes;
  for (const Loop& island : region.islands()) holes.push_back(geos_ring(island));
  return GEOSGeom_createPolygon(geos_ring(region.outer()), holes.data(), static_cast<unsigned>(holes.size()));
}

double geos_area(const GEOSGeometry* input, const std::vector<double>& levels) {
  double sum = 0;
  for (const double d : levels) {
    const int quadrant = static_cast<int>(std::ceil(kPi / 2 / (2 * std::acos(1 - kArcTolerance / d))));
    GEOSGeometry* out = GEOSBuffer(input, -d, quadrant);
    double of_level = 0;
    GEOSArea(out, &of_level);
    sum += of_level;
    GEOSGeom_destroy(out);
  }
  return sum;
}

template <class Work>
void run(benchmark::State& state, const Region& region, const std::vector<double>& levels, Work work) {
  const double ours = our_area(region, levels);
  double total = 0;
  for (auto _ : state) {
    total = work();
    benchmark::DoNotOptimize(total);
  }
  state.counters["levels"] = static_cast<double>(levels.size());
  state.counters["area_difference"] = total / ours - 1;
  if (!(std::abs(total / ours - 1) < 1e-3)) state.SkipWithError("the areas differ");
}

void register_rows(const Input& input) {
  const bool large = input.vertices >= 10000;
  const auto add = [&](const std::string& who, std::size_t most, auto work_for) {
    const std::string name = input.name + "/" + who;
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      work_for(state, levels_of(input.region, most));
    })->Unit(benchmark::kMillisecond);
  };
  const Region region = input.region;
  const auto ours = [=](benchmark::State& state, const std::vector<double>& levels) {
    run(state, region, levels, [&] { return our_area(region, levels); });
  };
  const auto polyclipping = [=](benchmark::State& state, const std::vector<double>& levels) {
    const auto paths = clipper_input(region);
    run(state, region, levels, [&] { return polyclipping_area(paths, levels); });
  };
  const auto geos = [=](benchmark::State& state, const std::vector<double>& levels) {
    GEOSGeometry* geometry = geos_input(region);
    run(state, region, levels, [&] { return geos_area(geometry, levels); });
    GEOSGeom_destroy(geometry);
  };
  add("clearcut", 1000, ours);
  add("GEOS", 1000, geos);
  if (!large) add("polyclipping", 1000, polyclipping);
  if (large && input.vertices < 100000) {
    add("clearcut, first level", 1, ours);
    add("polyclipping, first level", 1, polyclipping);
  }
}

}  // namespace
}  // namespace clearcut

int main(int argc, char** argv) {
  using namespace clearcut;
  initGEOS(nullptr, nullptr);
  register_rows(filleted_rectangle());
  for (const int n : {12, 100, 1000, 10000, 100000}) register_rows(wavy(n));
  register_rows(wavy_with_islands());
  register_fishhead();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  finishGEOS();
}
