// Contour-parallel passes, linked: what is left, what is gouged, what a rapid meets, on real and on awkward
// shapes.
#include "plan/contour/contour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/random.h"
#include "link/link.h"
#include "pipeline/run.h"
#include "plan/common/layers.h"
#include "read/outline/outline_reader.h"
#include "support/independent/raster_simulator.h"
#include "support/shapes.h"

namespace clearcut {
namespace {

const Tolerances kTol;

Layer pocket_layer(const Region& region, double diameter) {
  Layer layer;
  layer.z = -2;
  layer.target = layer.allowed = {region};
  layer.tool_radius = diameter / 2;
  return layer;
}

Region polygon(const std::vector<Vec2>& points, std::vector<Loop> islands = {}) {
  return Region::from_valid_loops(loop_from_points(points), std::move(islands));
}

Region rectangle(double width, double height, std::vector<Loop> islands = {}) {
  return polygon({{0, 0}, {width, 0}, {width, height}, {0, height}}, std::move(islands));
}

Loop square_loop(Vec2 center, double half) {
  return loop_from_points(std::vector<Vec2>{center + Vec2{-half, -half}, center + Vec2{half, -half},
                                            center + Vec2{half, half}, center + Vec2{-half, half}});
}

Section linked(const std::vector<LayerPasses>& layers, double radius, std::optional<Box> stock = {}) {
  link::LinkOptions options;
  options.tool_radius = radius;
  options.stock = stock;
  return link::link_layers(layers, options, kTol);
}

test_support::RasterFindings cut(const Layer& layer, const plan::contour::ContourOptions& options,
                                 Section* section = nullptr) {
  const auto passes = plan::contour::plan_contour(layer, options, kTol);
  const auto moves = linked({passes}, layer.tool_radius);
  if (section) *section = moves;
  test_support::RasterJob job{layer.target, layer.allowed, layer.tool_radius,     layer.wall_stock,
                              layer.z_top,  layer.z,       layer.tool_radius / 20};
  return test_support::simulate(job, moves.moves);
}

void expect_clean(const test_support::RasterFindings& found, const std::string& what) {
  EXPECT_EQ(found.uncut_cells, 0) << what << ": left at " << found.uncut_at.x << ", " << found.uncut_at.y;
  EXPECT_LE(found.gouge, kTol.gouge) << what << ": at " << found.gouge_at.x << ", " << found.gouge_at.y;
  EXPECT_EQ(found.rapid_cells, 0) << what;
}

plan::contour::ContourOptions stepping(const std::string& rule) {
  plan::contour::ContourOptions options;
  options.step = plan::contour::parse_step_rule(rule);
  return options;
}

double total_length(const LayerPasses& layer) {
  return std::accumulate(layer.passes.begin(), layer.passes.end(), 0.0,
                         [](double sum, const Pass& pass) { return sum + length(pass.path); });
}

/// CPO-kappa fig. 10: the paper counts the contours and one passage along a bisector between each two.
TEST(Contour, TriangleOfTheResultFile) {
  const double a = 79.9861;
  const Layer layer = pocket_layer(polygon({{0, 0}, {a, 0}, {a / 2, a * std::sqrt(3) / 2}}), 10);
  const auto passes = plan::contour::plan_contour(layer, stepping("7.01mm"), kTol);
  ASSERT_EQ(passes.passes.size(), 3u);
  const double levels[] = {5, 12.01, 19.02};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(passes.passes[i].offset, levels[i], 1e-9);
    EXPECT_EQ(passes.passes[i].path.size(), 3u);
    EXPECT_EQ(passes.passes[i].parent, static_cast<int>(i) - 1);
  }
  const double passage = plan::contour::passage_length(7.01, kPi / 3);
  EXPECT_NEAR(passage, 14.02, 1e-9);
  EXPECT_NEAR(total_length(passes) + 2 * passage, 373.4802, 0.001);
  bool first_edge_found = false;
  for (const auto& e : passes.passes[0].path) {
    first_edge_found |= distance(e.from, {8.6603, 5.0}) < 1e-4 && distance(e.to, {71.3259, 5.0}) < 1e-4;
  }
  EXPECT_TRUE(first_edge_found);
}

TEST(Contour, StepsFollowTheSmallestAngle) {
  const auto passes = plan::contour::plan_contour(pocket_layer(rectangle(100, 60), 8), stepping("lom"), kTol);
  ASSERT_GE(passes.passes.size(), 3u);
  EXPECT_NEAR(passes.passes[1].offset - passes.passes[0].offset, 8 * plan::contour::kappa(kPi / 2), 1e-9);
}

/// The simulator that the other tests rely on sees what a plain wide step leaves (CPO-kappa fig. 9).
TEST(Contour, APlainWideStepLeavesMaterialInCorners) {
  auto options = stepping("0.98");
  options.residuals = plan::contour::ResidualRule::kNone;
  const auto found = cut(pocket_layer(rectangle(100, 60), 8), options);
  EXPECT_GT(found.uncut_mm2, 1);
  EXPECT_GT(found.uncut_depth, 0.2);
}

struct Shape {
  std::string name;
  Region region;
};

/// Pockets with upright walls: contours of one layer clear them.
std::vector<std::pair<std::string, Part>> pockets() {
  std::vector<std::pair<std::string, Part>> all;
  for (const auto& shape : test_support::all_shapes()) {
    Part part = test_support::part_of(shape);
    const Feature& feature = part.features.at(0);
    if (feature.kind == FeatureKind::kClosedPocket && feature.wall_slope == Radians())
      all.emplace_back(shape.name, std::move(part));
  }
  EXPECT_GE(all.size(), 11u);
  return all;
}

std::vector<Shape> shapes() {
  std::vector<Shape> all;
  for (const auto& [name, part] : pockets())
    for (const auto& region : part.features.at(0).target) all.push_back({name, region});
  return all;
}

TEST(Contour, ClearsEveryShapeWithEveryCutter) {
  for (const auto& shape : shapes()) {
    for (const double diameter : {4.0, 8.0}) {
      for (const char* rule : {"widest", "lom", "0.95"}) {
        expect_clean(cut(pocket_layer(shape.region, diameter), stepping(rule)),
                     shape.name + " " + std::to_string(diameter) + " " + rule);
      }
    }
  }
}

/// From file to written program, checked by the verifier.
TEST(Contour, EveryShapeIsCertifiedClean) {
  for (const auto& [name, part] : pockets()) {
    for (const double diameter : {6.0, 10.0}) {
      PlanOptions options;
      options.strategy = "contour";
      options.tools = {resolve::parse_tool("endmill:" + std::to_string(diameter))};
      const auto result = pipeline::plan_part(part, options);
      EXPECT_TRUE(result.findings.all.clean) << name << " " << diameter;
      for (const auto& fault : result.findings.faults)
        ADD_FAILURE() << name << " " << diameter << ": " << fault.text;
    }
  }
}

TEST(Contour, ClearsTheBreakersOfOtherPrograms) {
  std::vector<Vec2> faceted;
  for (int i = 0; i < 24; ++i) faceted.push_back(direction_of(2 * kPi * i / 24) * 1.65);
  const Edge bowed = Edge::from_bulge({40, 30}, {0, 30}, -0.1);
  Loop bowed_loop{Edge::line({0, 0}, {40, 0}), Edge::line({40, 0}, {40, 30}), bowed,
                  Edge::line({0, 30}, {0, 0})};
  const struct {
    const char* name;
    Region region;
    double diameter;
  } cases[] = {
      {"16 mm square, 6.35 mm cutter", rectangle(16, 16), 6.35},
      {"8 mm square, 3 mm cutter", rectangle(8, 8), 3},
      {"faceted hole", polygon(faceted), 3.175},
      {"island near the wall", rectangle(60, 40, {square_loop({13, 20}, 8)}), 8},
      {"bowed side", Region::from_valid_loops(bowed_loop, {}), 6},
      {"thin wedge", polygon({{0, 0}, {80, 0}, {80, 14}}), 6},
      {"round pocket",
       Region::from_valid_loops({Edge::arc({20, 0}, {-20, 0}, {0, 0}, Turn::kCounterClockwise),
                                 Edge::arc({-20, 0}, {20, 0}, {0, 0}, Turn::kCounterClockwise)},
                                {}),
       6},
  };
  for (const auto& c : cases) {
    for (const char* rule : {"widest", "lom", "0.5", "1"}) {
      Section section;
      expect_clean(cut(pocket_layer(c.region, c.diameter), stepping(rule), &section),
                   std::string(c.name) + " " + rule);
      EXPECT_FALSE(section.moves.empty()) << c.name;
    }
  }
}

TEST(Contour, ACutterAsWideAsTheSlotRunsOnceAlongIt) {
  for (const double width : {2.0, 2.0 + 1e-6, 2.0 - 1e-6}) {
    const auto passes =
        plan::contour::plan_contour(pocket_layer(rectangle(30, width), 2), stepping("widest"), kTol);
    ASSERT_EQ(passes.passes.size(), 1u) << width;
    EXPECT_NEAR(length(passes.passes[0].path), 28, 0.01) << width;
  }
}

TEST(Contour, ACutterThatDoesNotFitHasNoPasses) {
  EXPECT_TRUE(plan::contour::plan_contour(pocket_layer(rectangle(30, 2), 2.1), stepping("widest"), kTol)
                  .passes.empty());
  EXPECT_TRUE(
      linked({plan::contour::plan_contour(pocket_layer(rectangle(30, 2), 2.1), stepping("widest"), kTol)},
             1.05)
          .moves.empty());
}

/// A star-shaped outline with `count` vertices and random radii.
Region random_star(Random& random, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i)
    points.push_back(direction_of(2 * kPi * i / count) * random.between(12, 40));
  return polygon(points);
}

TEST(Contour, ClearsRandomStars) {
  Random random(7);
  for (int i = 0; i < 12; ++i) {
    const Region region = random_star(random, 3 + static_cast<int>(random.below(14)));
    const double diameter = random.between(2, 12);
    for (const char* rule : {"widest", "lom", "0.7"}) {
      expect_clean(cut(pocket_layer(region, diameter), stepping(rule)),
                   "star " + std::to_string(i) + " D " + std::to_string(diameter) + " " + rule);
    }
  }
}

Region six_pointed_star() {
  std::vector<Vec2> points;
  for (int i = 0; i < 12; ++i)
    points.push_back(direction_of(kPi * i / 6 + kPi / 2) * (i % 2 == 0 ? 50 : 28.867513));
  return polygon(points);
}

/// CPO-kappa table I, CPO-rho table 3: what others add costs more way than it saves.
TEST(Contour, PublishedAdditionsClearTheStarAtAPrice) {
  const Layer layer = pocket_layer(six_pointed_star(), 8);
  const auto length_with = [&](plan::contour::ResidualRule rule) {
    auto options = stepping("0.9");
    options.residuals = rule;
    Section section;
    const auto found = cut(layer, options, &section);
    EXPECT_LE(found.gouge, kTol.gouge);
    EXPECT_EQ(found.uncut_cells == 0, rule != plan::contour::ResidualRule::kNone);
    return feed_length(section);
  };
  Section ours;
  expect_clean(cut(layer, {}, &ours), "ours");
  const double plain = length_with(plan::contour::ResidualRule::kNone),
               spurs = length_with(plan::contour::ResidualRule::kOurs);
  const double loops = length_with(plan::contour::ResidualRule::kLoops),
               bisectors = length_with(plan::contour::ResidualRule::kBisectors);
  EXPECT_LT(plain, spurs);
  EXPECT_LT(spurs, loops);
  EXPECT_LT(loops, bisectors);
  EXPECT_LT(feed_length(ours), spurs);
}

/// Lin et al. look for uncut regions first: where the ring at the wall leaves none, no bisector is added. 9 mm are left within the ring
/// of the cutter of 11 mm, 11 mm within that of 9 mm.
TEST(Contour, BisectorsAreAddedWhereSomethingIsLeft) {
  for (const auto& [radius, is_left] : {std::pair(11.0, false), std::pair(9.0, true)}) {
    const Layer layer = pocket_layer(rectangle(50, 40), 2 * radius);
    const auto passes_with = [&](plan::contour::ResidualRule rule) {
      auto options = stepping("0.9");
      options.residuals = rule;
      return plan::contour::plan_contour(layer, options, kTol).passes.size();
    };
    EXPECT_EQ(passes_with(plan::contour::ResidualRule::kBisectors) >
                  passes_with(plan::contour::ResidualRule::kNone),
              is_left)
        << radius;
  }
}

/// The wall ring is the part of the way on the rim of the legal area.
TEST(Contour, RunsWithTheWallOnTheSideAskedFor) {
  const Layer layer = pocket_layer(rectangle(50, 40), 6);
  for (const bool right : {true, false}) {
    plan::contour::ContourOptions options;
    options.wall_on_right = right;
    const auto passes = plan::contour::plan_contour(layer, options, kTol);
    ASSERT_EQ(passes.passes.size(), 1u);
    double turning = 0;
    for (const auto& e : passes.passes[0].path) {
      if (passes.legal[0].boundary_distance(e.at(0.5)) < 1e-6)
        turning += cross(e.from - Vec2{25, 20}, e.to - Vec2{25, 20});
    }
    EXPECT_EQ(turning > 0, right);
    EXPECT_NEAR(std::abs(turning), 2 * 44 * 34, 1);
  }
}

/// Distance of the way's middle from the wall, at its beginning and its end.
std::pair<double, double> depths_of(const Pass& way, const Region& region) {
  return {region.boundary_distance(way.path.front().from), region.boundary_distance(way.path.back().to)};
}

TEST(Contour, RunsOutsideInOnRequestWithTheWallOnTheSameSide) {
  const Region pocket = rectangle(50, 40);
  plan::contour::ContourOptions options;
  const auto inside_out = plan::contour::plan_contour(pocket_layer(pocket, 6), options, kTol);
  options.outside_in = true;
  const auto outside_in = plan::contour::plan_contour(pocket_layer(pocket, 6), options, kTol);
  ASSERT_EQ(inside_out.passes.size(), 1u);
  ASSERT_EQ(outside_in.passes.size(), 1u);
  EXPECT_NEAR(depths_of(inside_out.passes[0], pocket).second, 3, 1e-6);
  EXPECT_GT(depths_of(inside_out.passes[0], pocket).first, 8);
  EXPECT_NEAR(depths_of(outside_in.passes[0], pocket).first, 3, 1e-6);
  EXPECT_GT(depths_of(outside_in.passes[0], pocket).second, 8);
  for (const auto& plan : {inside_out, outside_in}) {
    double turning = 0;
    for (const auto& e : plan.passes[0].path) turning += cross(e.from - Vec2{25, 20}, e.to - Vec2{25, 20});
    EXPECT_GT(turning, 0);
  }
  Section section;
  expect_clean(cut(pocket_layer(pocket, 6), options, &section), "outside-in");
}

TEST(Contour, RingsRunOutsideInOnRequest) {
  auto options = stepping("0.5");
  options.outside_in = true;
  const auto section =
      linked({plan::contour::plan_contour(pocket_layer(rectangle(50, 40), 6), options, kTol)}, 3);
  const auto first_cut = std::find_if(section.moves.begin(), section.moves.end(),
                                      [](const Move& m) { return m.kind == MoveKind::kCut; });
  ASSERT_NE(first_cut, section.moves.end());
  EXPECT_NEAR(rectangle(50, 40).boundary_distance(first_cut->path.from), 3, 1e-6);
}

TEST(Contour, BeginsWhereAsked) {
  plan::contour::ContourOptions options;
  options.start = Vec2{12, 31};
  const Layer layer = pocket_layer(rectangle(50, 40), 6);
  Section section;
  expect_clean(cut(layer, options, &section), "given start");
  EXPECT_EQ(section.moves.front().path.from, *options.start);
}

TEST(Contour, LayersOfOneOutlineArePlannedOnce) {
  const Strategy planner =
      plan::once_per_outline([](const Layer& layer) { return plan::contour::plan_contour(layer, {}, kTol); });
  Layer layer = pocket_layer(rectangle(50, 40), 6);
  const auto first = planner(layer);
  layer.z_top = -2;
  layer.z = -4;
  const auto second = planner(layer);
  EXPECT_EQ(second.z, -4);
  ASSERT_EQ(second.passes.size(), first.passes.size());
  EXPECT_EQ(second.passes[0].path, first.passes[0].path);
  layer.allowed = layer.target = {rectangle(60, 40)};
  EXPECT_NE(planner(layer).passes[0].path, first.passes[0].path);
}

TEST(Link, LayersFollowEachOtherWithoutTouchingMaterialInRapids) {
  Feature feature;
  feature.target = feature.allowed = {rectangle(60, 40, {square_loop({30, 20}, 6)})};
  feature.floor_z = -9;
  Operation operation;
  operation.stepdown = 4;
  std::vector<LayerPasses> layers;
  for (const auto& layer : plan::layers_of(feature, operation, 3, kTol))
    layers.push_back(plan::contour::plan_contour(layer, {}, kTol));
  ASSERT_EQ(layers.size(), 3u);
  const auto section = linked(layers, 3);
  double lowest_rapid_end = 0;
  for (std::size_t i = 0; i < section.moves.size(); ++i) {
    const auto& m = section.moves[i];
    if (i > 0) {
      EXPECT_EQ(section.moves[i - 1].path.to, m.path.from) << i;
      EXPECT_EQ(section.moves[i - 1].z_to, m.z_from) << i;
    }
    if (is_rapid(m.kind)) lowest_rapid_end = std::min(lowest_rapid_end, m.z_to);
    EXPECT_EQ(is_rapid(m.kind), m.feed.mm_per_min() == 0) << i;
  }
  EXPECT_GT(lowest_rapid_end, -8 + 0.99);
  EXPECT_EQ(section.moves.back().z_to, 10);
  for (const auto& layer : layers) {
    test_support::RasterJob job{feature.target, feature.allowed, 3, 0, layer.z_top, layer.z, 0.15};
    expect_clean(test_support::simulate(job, section.moves), "layer at " + std::to_string(layer.z));
  }
}

/// An open layer: a boss in the middle of a block, the cutter may leave the block on all sides.
TEST(Link, AFaceIsEnteredFromTheAir) {
  const Loop boss = square_loop({50, 40}, 10);
  Layer layer;
  layer.z = -2;
  layer.tool_radius = 10;
  layer.target = {rectangle(100, 80, {boss})};
  layer.allowed = {Region::from_valid_loops(square_loop({50, 40}, 1000), {boss})};
  const auto passes = plan::contour::plan_contour(layer, {}, kTol);
  const auto section = linked({passes}, 10, Box{{0, 0}, {100, 80}});
  ASSERT_FALSE(section.moves.empty());
  const Vec2 entry = section.moves.front().path.from;
  EXPECT_GE((Box{{0, 0}, {100, 80}}).distance_to(entry), 10);
  test_support::RasterJob job{layer.target, layer.allowed, 10, 0, 0, -2, 0.5};
  expect_clean(test_support::simulate(job, section.moves), "face");
}

TEST(Link, ConventionalRunsTheOtherWay) {
  const auto passes = plan::contour::plan_contour(pocket_layer(rectangle(40, 30), 6), stepping("lom"), kTol);
  link::LinkOptions options;
  options.tool_radius = 3;
  const auto area_of_last_ring = [&](CutDirection direction) {
    options.direction = direction;
    Loop ring;
    for (const auto& m : link::link_layers({passes}, options, kTol).moves) {
      if (m.kind == MoveKind::kCut && std::abs(m.path.at(0.5).x - 20) > 16.9) ring.push_back(m.path);
    }
    double doubled = 0;
    for (const auto& e : ring) doubled += cross(e.from - Vec2{20, 15}, e.to - Vec2{20, 15});
    return doubled;
  };
  EXPECT_GT(area_of_last_ring(CutDirection::kClimb), 0);
  EXPECT_LT(area_of_last_ring(CutDirection::kConventional), 0);
}

}  // namespace
}  // namespace clearcut
