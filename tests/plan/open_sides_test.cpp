// Layers that can be entered from beside the stock are: no plunge, ramp or helix into material.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "stock/material.h"
#include "support/plans.h"
#include "support/random/random_parts.h"

namespace clearcut {
namespace {

const Tolerances kTol;

Regions box_regions(const Box& box) {
  return {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}),
      {})};
}

/// A pocket that an edge of the block runs through: open there, walls everywhere else. Empty when that leaves nothing.
Part random_notch(Random& random, double diameter) {
  const Regions outline = test_support::random_regions(random);
  if (outline.empty()) return {};
  Box block = box(outline).grown(8);
  const double cut = random.between(0.25, 0.75);
  block.max.x = std::floor(block.min.x + cut * block.width());
  block.min = {std::floor(block.min.x), std::floor(block.min.y)};
  block.max.y = std::ceil(block.max.y);
  const Regions walls = subtract(box_regions(block), outline, kTol);
  const Regions allowed = subtract(box_regions(block.grown(kOpenReach)), walls, kTol);
  Regions target = intersect(box_regions(block), outline, kTol);
  std::erase_if(target, [&](const Region& region) { return box(region.outer()).max.x < block.max.x; });
  if (target.empty()) return {};
  Part part = test_support::part_of(target, allowed, FeatureKind::kOpenPocket, diameter);
  part.stock = Stock{block, -10, 0};
  part.features.front().floor_z = -4;
  return part;
}

/// A block all round a wall: seeds of others give nothing.
Part random_block(Random& random, double diameter) {
  Part part = test_support::random_part(random, diameter);
  return part.stock ? part : Part{};
}

bool meets_material(const stock::Material& material, Vec2 center, double radius, double z) {
  constexpr int kRings = 6, kRays = 24;
  for (int r = 0; r <= kRings; ++r) {
    for (int k = 0; k < kRays; ++k) {
      const Vec2 p = center + direction_of(2 * kPi * k / kRays) * (0.97 * radius * r / kRings);
      if (!material.is_removed(p, z + 0.01)) return true;
    }
  }
  return false;
}

/// Where the cutter's centre may be, as far as it is joined to places beside the block.
Regions reached_from_outside(const Part& part) {
  const double radius = part.tools.front().radius();
  const Box beside = part.stock->plan.grown(radius);
  Regions reached;
  for (const Region& allowed : part.features.front().allowed) {
    for (const Region& legal : inset(allowed, radius, kTol)) {
      const Box extent = legal.box();
      if (!beside.contains(extent.min) || !beside.contains(extent.max)) reached.push_back(legal);
    }
  }
  return reached;
}

struct Entries {
  int from_outside = 0;
  int into_material = 0;
  int needless = 0;  ///< of these, where a way leads in from outside
};

/// Runs of feed moves downwards, by what is under the cutter before.
Entries entries_of(const PlanResult& result) {
  const double radius = result.part.tools.front().radius();
  stock::Material material(result.part.stock->plan, 0, {radius});
  const Regions reached = reached_from_outside(result.part);
  Entries entries;
  bool down = false;
  for (const auto& section : result.toolpath.sections) {
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind)) {
        down = false;
        continue;
      }
      if (move.z_to < move.z_from && !down) {
        down = true;
        double lowest = move.z_to;
        for (const Move* m = &move; m != section.moves.data() + section.moves.size() &&
                                    m->z_to <= m->z_from && (m->z_to < m->z_from || !m->is_vertical());
             ++m) {
          if (m->z_to == m->z_from) break;
          lowest = m->z_to;
        }
        if (meets_material(material, move.path.from, radius, lowest)) {
          ++entries.into_material;
          entries.needless += contains(reached, move.path.from);
        } else {
          ++entries.from_outside;
        }
      }
      if (move.z_to >= move.z_from) down = false;
      material.add(move, radius);
    }
  }
  return entries;
}

/// An open pocket of 40 x 20 mm in a block of its size, with this permitted area.
std::string pocket_in_block(const std::string& outer, const std::string& allowed) {
  return R"({"units": "mm", "stock": {"x": [0, 40], "y": [0, 20], "z": [-10, 0]}, "pockets": [{"name": "p",
    "kind": "open_pocket", "top": 0, "depth": 2, "outer": )" +
         outer + R"(, "allowed": [)" + allowed + "]}]}";
}

/// Beside the block nothing stands, whatever permitted area is stated: plan and verdict take it so.
TEST(BesideTheBlock, NothingStandsWhateverIsPermitted) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"[[0, 0], [40, 0], [40, 20], [0, 20]]",
       R"({"outer": [[0, -1000], [1040, -1000], [1040, 20], [0, 20]]})"},
      {"[[0, 0], [9, 0], [7, 3], [16, 4], [17, 0], [40, 0], [40, 20], [0, 20]]",
       R"({"outer": [[0, -1000], [1040, -1000], [1040, 1020], [0, 1020]],
           "islands": [[[9, 0], [7, 3], [16, 4], [17, 0], [19, -8], [11, -8]]]})"}};
  for (const auto& [outer, allowed] : cases) {
    for (const char* strategy : {"contour", "zigzag", "spiral", "adaptive"}) {
      const Part part = read::read_part_text(pocket_in_block(outer, allowed), "block.json", {});
      PlanOptions options = test_support::with_tool(6);
      options.strategy = strategy;
      EXPECT_TRUE(pipeline::plan_part(part, options).findings.all.clean) << allowed << strategy;
    }
  }
}

TEST(Slivers, BetweenAPartAndItsStockAreNoWallsWhereTheyEnd) {
  // The stock is wider than the solid by what a CAD kernel's box is, 0.5 nm; a notch ends the sliver between them.
  const double top = 20, above = 20.0000005;
  const std::vector<Vec2> notch{{5, top}, {30, top}, {30, 8}, {40, 8}, {40, above}, {5.0000003, above}};
  const std::vector<Vec2> solid{
      {0, 0},  {0, top}, {4, top}, {4.0000003, above}, {5.0000003, above}, {5, top}, {30, top},
      {30, 8}, {40, 8},  {40, 0}};
  const Loop air = box_regions({{-100, -100}, {140, 120}}).front().outer();
  Part part = test_support::part_of({Region::from_valid_loops(loop_from_points(notch), {})},
                                    {Region::from_valid_loops(air, {loop_from_points(solid)})},
                                    FeatureKind::kOpenPocket, 4);
  part.stock = Stock{{{0, 0}, {40, above}}, -5, 0};
  const auto result = pipeline::plan_part(part, {});
  for (const Fault& fault : result.findings.faults) ADD_FAILURE() << fault.text;
}

class OpenSides : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Strategies, OpenSides,
                         testing::Values("contour", "zigzag", "spiral", "adaptive", "tour"),
                         [](const auto& strategy) { return strategy.param; });

TEST_P(OpenSides, AreWhereTheCutterComesIn) {
  PlanOptions options;
  options.strategy = GetParam();
  options.threads = 1;
  int parts = 0, outside = 0, unclean = 0, needless = 0;
  double time = 0;
  const int wanted = test_support::random_count(12);
  for (std::uint64_t seed = 1; parts < wanted && seed < 20 * static_cast<std::uint64_t>(wanted); ++seed) {
    Random random(seed);
    const double diameter = random.between(3, 8);
    const Part part = seed % 2 ? random_notch(random, diameter) : random_block(random, diameter);
    if (part.features.empty()) continue;
    try {
      const auto result = pipeline::plan_part(part, options);
      const Entries entries = entries_of(result);
      ++parts;
      unclean += !result.findings.all.clean;
      outside += entries.into_material == 0;
      needless += entries.needless > 0;
      time += result.findings.all.time_s;
      if (std::getenv("CLEARCUT_SHOW") && !result.findings.faults.empty())
        std::printf("seed %d: %s\n", static_cast<int>(seed), result.findings.faults.front().text.c_str());
      if (entries.into_material > 0 && std::getenv("CLEARCUT_SHOW"))
        std::printf("seed %d: %d into material, %d needless, %d from outside\n", static_cast<int>(seed),
                    entries.into_material, entries.needless, entries.from_outside);
    } catch (const InputError&) {
    }
  }
  std::printf("%s: %d of %d open parts entered from outside alone, %d needlessly not, %d not clean, %.1f s\n",
              GetParam().c_str(), outside, parts, needless, unclean, time);
  EXPECT_GT(parts, wanted / 2);
  EXPECT_EQ(unclean, 0);
  // Adaptive clearing chooses its entries itself.
  if (options.strategy != "adaptive") {
    EXPECT_EQ(needless, 0);
  }
  EXPECT_GE(10 * outside, 6 * parts) << "of " << parts;
}

}  // namespace
}  // namespace clearcut
