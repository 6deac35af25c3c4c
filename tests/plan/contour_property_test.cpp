// Plain `contour`, at its first attempt, on thousands of random regions with random cutters: what the verifier says
// of the written program. CLEARCUT_CONTOUR_CASES sets how many (2400 for the full experiment); CLEARCUT_FAMILY=name
// or name-number runs some alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "geometry/voronoi/clearance.h"
#include "pipeline/run.h"
#include "post/part/part_writers.h"
#include "support/random/random_regions.h"

namespace clearcut {
namespace {

using test_support::family_of;
using test_support::RandomRegion;

const Tolerances kTol;

int case_count() {
  const char* set = std::getenv("CLEARCUT_CONTOUR_CASES");
  return set != nullptr ? std::atoi(set) : 150;
}

Part pocket_of(const Region& region) {
  Part part;
  part.name = "random";
  Feature feature;
  feature.name = "POCKET";
  feature.target = feature.allowed = {region};
  feature.floor_z = -2;
  feature.kind = FeatureKind::kClosedPocket;
  part.features.push_back(std::move(feature));
  part.workplan.emplace_back();
  part.workplan.back().feature = 0;
  return part;
}

/// Cutters from a twelfth of the largest that fits up to that, often one of the size of an arc or a neck.
double cutter_for(const RandomRegion& random_region, Random& random) {
  const double largest = Clearance(random_region.region, kTol).max();
  if (!random_region.levels.empty() && random.below(3) == 0) {
    const double d = 2 * random_region.levels.front();
    if (d < 1.98 * largest && d > largest / 8) return d;
  }
  return 2 * largest * std::min(0.99, 1 / random.between(1, 12));
}

Tool endmill(double diameter) {
  Tool tool;
  tool.number = 1;
  tool.diameter = diameter;
  return tool;
}

/// What is wrong, or nothing.
std::string fault_of(const RandomRegion& random_region, double diameter) {
  PlanOptions options;
  options.strategy = "contour";
  options.stepdown = 2;
  options.tools = {endmill(diameter)};
  const auto result = pipeline::plan_part(pocket_of(random_region.region), options);
  if (result.findings.all.clean) return {};
  return result.findings.faults.empty() ? "not clean" : result.findings.faults.front().text;
}

/// For a look at what failed.
void leave_outline(const std::string& name, const Region& region) {
  const auto folder = std::filesystem::path(CLEARCUT_BINARY_DIR) / "debug";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / ("contour-" + name + ".json")) << post::write_outline_json(pocket_of(region));
}

TEST(ContourProperty, IsCleanAtTheFirstAttempt) {
  int faults = 0;
  const char* only = std::getenv("CLEARCUT_FAMILY");
  for (int i = 0; i < case_count() && faults < 50; ++i) {
    Random random(static_cast<std::uint64_t>(i) + 77);
    const auto& family = family_of(i);
    const std::string name = fmt::format("{}-{}", family.name, i);
    if (only != nullptr && name != only && family.name != std::string(only)) continue;
    const RandomRegion region = family.make(random);
    const double diameter = cutter_for(region, random);
    std::string fault;
    try {
      fault = fault_of(region, diameter);
    } catch (const std::exception& e) {
      fault = e.what();
    }
    if (fault.empty()) continue;
    leave_outline(name, region.region);
    ADD_FAILURE() << name << " D " << diameter << ": " << fault;
    ++faults;
  }
}

}  // namespace
}  // namespace clearcut
