#include "plan/adaptive/adaptive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "base/random.h"
#include "base/work_budget.h"
#include "geometry/voronoi/clearance.h"
#include "plan/adaptive/clearing/clearing_path.h"
#include "plan/common/cover.h"
#include "stock/material.h"

namespace clearcut::plan::adaptive {
namespace {

constexpr double kTool = 3;

/// Engagement of the cutter at p, moving along `travel`, where only `cleared` is free: counted on its circle.
double counted_engagement(Vec2 p, Vec2 travel, const Disc& cleared) {
  constexpr int kParts = 20000;
  int inside = 0;
  for (int i = 0; i < kParts; ++i) {
    const Vec2 u = direction_of(2 * kPi * (i + 0.5) / kParts);
    if (dot(u, travel) > 0 && distance(p + u * kTool, cleared.center) > cleared.radius) ++inside;
  }
  return 2 * kPi * inside / kParts;
}

TEST(Adaptive, WidenedCircleHasExactlyTheContactAskedFor) {
  for (const double angle : {0.3, 0.9, 1.4, 2.0}) {
    for (const double cleared : {3.5, 6.0, 30.0}) {
      const double d = widened_circle(cleared, kTool, angle);
      EXPECT_NEAR(counted_engagement({d, 0}, {0, 1}, {{0, 0}, cleared}), angle, 2e-3)
          << angle << " " << cleared;
    }
  }
}

Layer square_layer(double side) {
  Layer layer;
  layer.z = -2;
  layer.tool_radius = kTool;
  layer.allowed = layer.target = {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {side, 0}, {side, side}, {0, side}}), {})};
  return layer;
}

/// A cut that comes to the wall of a round pocket may already stand where it would go on along the wall.
TEST(Adaptive, RoundPocketsOfAnySizeHaveNoMoveWithoutHeading) {
  for (int i = 0; i < 36; ++i) {
    Layer layer;
    layer.z = -1;
    layer.tool_radius = 4;
    // The last ones are hardly wider than the cutter.
    const Vec2 center{43.7724, 21.2088}, across{i < 24 ? 9.0596 + 0.2137 * i : 4.01 + 0.01 * (i - 24), 0};
    layer.allowed = layer.target = {Region::from_valid_loops(
        {Edge::arc(center - across, center + across, center, Turn::kCounterClockwise),
         Edge::arc(center + across, center - across, center, Turn::kCounterClockwise)},
        {})};
    AdaptiveOptions options;
    options.engagement = Radians::of_degrees(90);
    for (const Pass& pass : plan_adaptive(layer, options, {}).passes) {
      for (const Edge& edge : pass.path) {
        ASSERT_TRUE(std::isfinite(edge.to.x) && std::isfinite(edge.to.y)) << i;
        ASSERT_GT(edge.length(), 0) << i;
      }
    }
  }
}

/// Where the centre has a few micrometres of room a helix would have thousands of turns: another entry is left to the linker.
TEST(Adaptive, PassagesHardlyWiderThanTheCutterAreEnteredWithoutAHelix) {
  for (const double room : {0.001, 0.01, 0.1}) {
    const double half = kTool + room / 2;
    Layer layer;
    layer.z = -4;
    layer.tool_radius = kTool;
    layer.allowed = layer.target = {
        Region::from_valid_loops({Edge::line({0, -half}, {20, -half}),
                                  Edge::arc({20, -half}, {20, half}, {20, 0}, Turn::kCounterClockwise),
                                  Edge::line({20, half}, {0, half}),
                                  Edge::arc({0, half}, {0, -half}, {0, 0}, Turn::kCounterClockwise)},
                                 {})};
    const auto passes = plan_adaptive(layer, {}, {}).passes;
    ASSERT_FALSE(passes.empty()) << room;
    for (const Pass& pass : passes) EXPECT_FALSE(pass.entry_center) << room;
  }
}

TEST(Adaptive, PathIsJoinedAndEveryEdgeHasItsKind) {
  const auto passes = plan_adaptive(square_layer(50), {}, {}).passes;
  ASSERT_EQ(passes.size(), 1u);
  const auto& clearing = passes[0];
  EXPECT_EQ(clearing.path.size(), clearing.kinds.size());
  ASSERT_TRUE(clearing.entry_center);
  EXPECT_NEAR(distance(*clearing.entry_center, {25, 25}), 0, 1e-3);
  for (std::size_t i = 1; i < clearing.path.size(); ++i)
    EXPECT_EQ(clearing.path[i].from, clearing.path[i - 1].to);
}

/// CLEARCUT_PICTURES=docs/pictures plan_test --gtest_filter='*PictureOfEachStep' draws those of docs/adaptive.md.
TEST(Adaptive, TakesAPictureOfEachStep) {
  Layer layer = square_layer(50);
  const std::vector<Vec2> arrow{{0, 0}, {40, 12}, {60, 0}, {48, 40}, {0, 40}, {6, 20}};
  layer.allowed = layer.target = {Region::from_valid_loops(loop_from_points(arrow), {})};
  const char* set = std::getenv("CLEARCUT_PICTURES");
  const auto folder =
      set ? std::filesystem::path(set) : std::filesystem::path(CLEARCUT_BINARY_DIR) / "debug" / "adaptive";
  const auto without = plan_adaptive(layer, {}, {}).passes;
  SvgFrames frames(folder, "adaptive");
  AdaptiveOptions options;
  options.pictures = &frames;
  const auto passes = plan_adaptive(layer, options, {}).passes;
  frames.finish();
  ASSERT_EQ(passes.size(), without.size()) << "pictures change nothing";
  EXPECT_EQ(passes[0].path, without[0].path);
  ASSERT_GE(frames.written().size(), 3u);
  EXPECT_EQ(frames.written()[0].filename(), "adaptive-001-spiral.svg");
  EXPECT_EQ(frames.written()[1].filename(), "adaptive-002-cuts-from-wall-to-wall.svg");
  EXPECT_EQ(frames.written()[2].filename(), "adaptive-003-walls-and-corners.svg");
}

TEST(Adaptive, NothingWhereTheCutterDoesNotFit) {
  EXPECT_TRUE(plan_adaptive(square_layer(5.9), {}, {}).passes.empty());
}

/// A second look at the engagement, without any of the planner's geometry: material is a raster of small squares.
class Raster {
 public:
  explicit Raster(double side)
      : count_(static_cast<int>(side / kCell)), solid_(static_cast<std::size_t>(count_ * count_), 1) {}

  double engagement(Vec2 p, Vec2 travel) const {
    constexpr int kParts = 360;
    int inside = 0;
    for (int i = 0; i < kParts; ++i) {
      const Vec2 u = direction_of(2 * kPi * (i + 0.5) / kParts);
      if (dot(u, travel) > 0 && is_solid(p + u * kTool)) ++inside;
    }
    return 2 * kPi * inside / kParts;
  }
  void clear(Vec2 p) {
    for (int y = index(p.y - kTool); y <= index(p.y + kTool); ++y) {
      for (int x = index(p.x - kTool); x <= index(p.x + kTool); ++x) {
        if (distance(Vec2{x + 0.5, y + 0.5} * kCell, p) <= kTool)
          solid_[static_cast<std::size_t>(y * count_ + x)] = 0;
      }
    }
  }

 private:
  static constexpr double kCell = 0.05;
  int index(double v) const { return std::clamp(static_cast<int>(v / kCell), 0, count_ - 1); }
  bool is_solid(Vec2 p) const {
    return p.x > 0 && p.y > 0 && p.x < count_ * kCell && p.y < count_ * kCell &&
           solid_[static_cast<std::size_t>(index(p.y) * count_ + index(p.x))] != 0;
  }

  int count_;
  std::vector<char> solid_;
};

TEST(Adaptive, ContactKeepsTheLimitOnARaster) {
  AdaptiveOptions options;
  options.engagement = Radians::of_degrees(60);
  const auto pass = plan_adaptive(square_layer(30), options, {}).passes.at(0);
  Raster raster(30);
  double over = 0, whole = 0;
  for (std::size_t i = 0; i < pass.path.size(); ++i) {
    const Edge& edge = pass.path[i];
    const int steps = static_cast<int>(edge.length() / 0.2) + 1;
    for (int k = 0; k < steps; ++k) {
      const Vec2 p = edge.at((k + 0.5) / steps);
      // The first circle is the entry's. One square of the raster is worth some ten degrees.
      if (i >= 2 &&
          raster.engagement(p, edge.tangent_at((k + 0.5) / steps)) > options.engagement.radians() + 0.2)
        over += edge.length() / steps;
      whole += edge.length() / steps;
      raster.clear(p);
    }
  }
  EXPECT_GT(whole, 300);
  EXPECT_LT(over, 0.02 * whole);
}

Layer polygon_layer(const std::vector<Vec2>& corners) {
  Layer layer = square_layer(1);
  layer.allowed = layer.target = {Region::from_valid_loops(loop_from_points(corners), {})};
  return layer;
}

/// Length of the passes, after the entries, with more engagement than `limit`. Looked at closely, also in the corners.
double length_above(const LayerPasses& planned, double limit) {
  stock::Material material(std::nullopt, 0, {kTool});
  double above = 0;
  for (const Pass& pass : planned.passes) {
    for (std::size_t i = 0; i < pass.path.size(); ++i) {
      const Move move{pass.path[i], -1, -1, MoveKind::kCut, {}, 0};
      const int steps = static_cast<int>(move.path.length() / 0.1) + 3;
      for (int k = 1; k <= steps && i >= 2; ++k) {
        const double t = static_cast<double>(k) / steps;
        if (material.engagement(move, t, kTool - 1e-3).angle > limit) above += move.path.length() / steps;
      }
      material.add(move, kTool);
    }
  }
  return above;
}

TEST(Adaptive, ContactKeepsTheLimitInCornersToo) {
  const std::vector<std::vector<Vec2>> shapes{{{0, 0}, {40, 0}, {40, 40}, {0, 40}},
                                              {{0, 0}, {60, 0}, {30, 52}},
                                              {{0, 0}, {50, 0}, {50, 20}, {20, 20}, {20, 50}, {0, 50}}};
  for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
    for (const double degrees : {53.0, 78.0}) {
      AdaptiveOptions options;
      options.engagement = Radians::of_degrees(degrees);
      const auto planned = plan_adaptive(polygon_layer(shapes[shape]), options, {});
      EXPECT_LT(length_above(planned, Radians::of_degrees(degrees + 2).radians()), 0.3)
          << shape << " " << degrees;
    }
  }
}

TEST(Adaptive, ContactKeepsTheLimitInNarrowEndsToo) {
  // Ends with two corners nearer to each other than a tenth of the cutter's radius, and about as far.
  const std::vector<std::vector<Vec2>> shapes{
      {{0, 0}, {60, 0}, {60, 6.3}, {20, 30}, {0, 30}},
      {{0, 0}, {60, 0}, {60, 8.5}, {20, 30}, {0, 30}},
      {{0, 0}, {30, 0}, {55, 12}, {54, 19}, {30, 30}, {0, 30}},
      {{0, 0}, {30, 0}, {30, 30}, {18, 30}, {18, 50}, {11, 50}, {11, 30}, {0, 30}}};
  for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
    for (const double degrees : {45.0, 78.0}) {
      AdaptiveOptions options;
      options.engagement = Radians::of_degrees(degrees);
      const auto planned = plan_adaptive(polygon_layer(shapes[shape]), options, {});
      EXPECT_LT(length_above(planned, Radians::of_degrees(degrees + 2).radians()), 0.3)
          << shape << " " << degrees;
    }
  }
}

TEST(Adaptive, CutsStraightThroughCorridorsHardlyWiderThanTheCutter) {
  // Trochoidal steps there get no farther than the corridor is wider than the cutter: thousands of them, ever closer.
  for (const double wider : {0.005, 0.02, 0.05}) {
    const double low = 15 - kTool - wider / 2, high = 15 + kTool + wider / 2;
    const Layer layer = polygon_layer({{0, 0},
                                       {30, 0},
                                       {30, low},
                                       {90, low},
                                       {90, 0},
                                       {120, 0},
                                       {120, 30},
                                       {90, 30},
                                       {90, high},
                                       {30, high},
                                       {30, 30},
                                       {0, 30}});
    const WorkBudget budget(60'000);
    std::size_t moves = 0;
    for (const Pass& pass : plan_adaptive(layer, {}, {}).passes) moves += pass.path.size();
    EXPECT_LT(moves, 1200u) << wider;
  }
}

TEST(Adaptive, ContactKeepsTheLimitInRoundPockets) {
  for (const double radius : {4.2, 5.0, 8.0, 25.0}) {
    for (const double degrees : {45.0, 78.0}) {
      Layer layer = square_layer(1);
      const Vec2 east{radius, 0}, west{-radius, 0};
      layer.allowed =
          layer.target = {Region::from_valid_loops({Edge::arc(east, west, {0, 0}, Turn::kCounterClockwise),
                                                    Edge::arc(west, east, {0, 0}, Turn::kCounterClockwise)},
                                                   {})};
      AdaptiveOptions options;
      options.engagement = Radians::of_degrees(degrees);
      EXPECT_LT(length_above(plan_adaptive(layer, options, {}), Radians::of_degrees(degrees + 2).radians()),
                0.1)
          << radius << " " << degrees;
    }
  }
}

TEST(Adaptive, BesideTheStockItComesInFromOutside) {
  Layer layer = square_layer(40);
  layer.stock = Box{{0, 0}, {40, 40}};
  layer.allowed = {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{-100, 0}, {40, 0}, {40, 40}, {-100, 40}}), {})};
  const auto planned = plan_adaptive(layer, {}, {});
  ASSERT_FALSE(planned.passes.empty());
  EXPECT_FALSE(planned.passes.front().entry_center);
  EXPECT_LT(planned.passes.front().path.front().from.x, -kTool + 0.01);
}

TEST(Adaptive, BeginsInAHoleOrWhereItIsAskedTo) {
  Layer layer = square_layer(50);
  AdaptiveOptions options;
  options.start = Vec2{12, 30};
  const auto asked = plan_adaptive(layer, options, {});
  ASSERT_TRUE(asked.passes.at(0).entry_center);
  EXPECT_EQ(*asked.passes[0].entry_center, *options.start);
  layer.holes = {{{14, 33}, 2 * kTool + 1}};
  const auto drilled = plan_adaptive(layer, {}, {});
  EXPECT_TRUE(drilled.passes.at(0).starts_clear);
  EXPECT_FALSE(drilled.passes[0].entry_center);
  EXPECT_NEAR(distance(drilled.passes[0].path.front().from, {14, 33}), 0.5, 1e-9);
  // The hole is narrower than the cutter: it can only begin about it.
  layer.holes[0].diameter = kTool;
  EXPECT_EQ(plan_adaptive(layer, {}, {}).passes.at(0).entry_center, (Vec2{14, 33}));
}

TEST(Adaptive, EntersNoWiderThanItIsAskedTo) {
  AdaptiveOptions options;
  options.widest_helix = 2;
  EXPECT_NEAR(plan_adaptive(square_layer(50), options, {}).passes.at(0).path.at(0).radius(), 1, 1e-9);
  options.widest_helix = 100;
  EXPECT_LT(plan_adaptive(square_layer(50), options, {}).passes.at(0).path.at(0).radius(), kTool);
}

TEST(Adaptive, ContactKeepsTheLimitOnStripsBesideTheStock) {
  // A block round a wall, with less than the cutter's diameter to go; walls are `allowed`'s islands.
  for (const double strip : {1.0, 3.0, 5.5}) {
    Layer layer = square_layer(40);
    layer.stock = Box{{0, 0}, {40, 40}};
    const Loop wall = reversed(loop_from_points(std::vector<Vec2>{
        {strip, strip}, {40 - strip, strip}, {40 - strip, 40 - strip}, {strip, 40 - strip}}));
    layer.target = {Region::from_valid_loops(layer.target[0].outer(), {wall})};
    layer.allowed = {Region::from_valid_loops(
        loop_from_points(std::vector<Vec2>{{-50, -50}, {90, -50}, {90, 90}, {-50, 90}}), {wall})};
    const auto planned = plan_adaptive(layer, {}, {});
    stock::Material material(layer.stock, 0, {kTool});
    double above = 0, cutting = 0;
    for (const Pass& pass : planned.passes) {
      EXPECT_FALSE(pass.entry_center);
      for (const Edge& edge : pass.path) {
        const Move move{edge, -1, -1, MoveKind::kCut, {}, 0};
        const int steps = static_cast<int>(edge.length() / 0.1) + 3;
        for (int k = 1; k <= steps; ++k) {
          const double angle = material.engagement(move, static_cast<double>(k) / steps, kTool - 1e-3).angle;
          if (angle > 0) cutting += edge.length() / steps;
          if (angle > Radians::of_degrees(62).radians()) above += edge.length() / steps;
        }
        material.add(move, kTool);
      }
    }
    EXPECT_GT(cutting, 100) << strip;
    EXPECT_LT(above, 0.3) << strip;
  }
}

TEST(Adaptive, ClearsWhatIsOnlyTouchedFromBesideTheStock) {
  // There is hardly room for the cutter beside the block, and no place where it touches more than a sliver.
  for (const double deep : {0.1, 0.02, 0.005}) {
    Layer layer = square_layer(10);
    layer.stock = Box{{0, 0}, {10, 10}};
    layer.allowed = {
        Region::from_valid_loops(loop_from_points(std::vector<Vec2>{
                                     {10 - deep, 0}, {16.04 - deep, 0}, {16.04 - deep, 7}, {10 - deep, 7}}),
                                 {})};
    std::vector<Edge> edges;
    for (const Pass& pass : plan_adaptive(layer, {}, {}).passes)
      edges.insert(edges.end(), pass.path.begin(), pass.path.end());
    const Cover cover(edges, kTool + 0.007);
    for (double y = 3; y <= 4; y += 0.01) EXPECT_TRUE(cover.holds({10 - deep, y})) << deep << " " << y;
  }
}

TEST(Adaptive, TouchesTheBorderThroughAGapThatIsHardlyOpen) {
  // A pocket that narrows to 0.028 mm where the stock ends: from outside the cutter gets 33 nm deep there.
  Layer layer = square_layer(1);
  layer.stock = Box{{0, 0}, {18, 20}};
  layer.target = {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {10, 0}, {18, 9.986}, {18, 10.014}, {10, 20}, {0, 20}}),
      {})};
  layer.allowed = {Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{0, 0},
                                                                               {10, 0},
                                                                               {18, 9.986},
                                                                               {18, -40},
                                                                               {90, -40},
                                                                               {90, 60},
                                                                               {18, 60},
                                                                               {18, 10.014},
                                                                               {10, 20},
                                                                               {0, 20}}),
                                            {})};
  std::vector<Edge> edges;
  for (const Pass& pass : plan_adaptive(layer, {}, {}).passes)
    edges.insert(edges.end(), pass.path.begin(), pass.path.end());
  EXPECT_TRUE(Cover(edges, kTool + 0.007).holds({18, 10}));
}

int moves_in(const Layer& layer, double degrees) {
  AdaptiveOptions options;
  options.engagement = Radians::of_degrees(degrees);
  int moves = 0;
  for (const Pass& pass : plan_adaptive(layer, options, {}).passes)
    moves += static_cast<int>(pass.path.size());
  return moves;
}

TEST(Adaptive, TakesFewMoves) {
  // As engineers would count them: half turns of a spiral, some three for each cut, fewer than ten for each corner.
  EXPECT_LE(moves_in(square_layer(50), 78), 115);
  // A slot 4/3 as wide as the cutter: cuts from wall to wall, some four moves each millimetre.
  Layer slot = square_layer(1);
  slot.allowed = slot.target = {Region::from_valid_loops(
      loop_from_points(
          std::vector<Vec2>{{0, 0}, {20, 0}, {20, 11}, {60, 11}, {60, 19}, {20, 19}, {20, 30}, {0, 30}}),
      {})};
  EXPECT_LE(moves_in(slot, 78), 305);
}

TEST(Adaptive, ClearsRandomPolygons) {
  Random random(11);
  for (int i = 0; i < 8; ++i) {
    std::vector<Vec2> corners;
    const int count = 4 + i % 4;
    for (int k = 0; k < count; ++k)
      corners.push_back(direction_of(2 * kPi * (k + random.between(-0.25, 0.25)) / count) *
                        random.between(14, 24));
    Layer layer = square_layer(1);
    layer.allowed = layer.target = {Region::from_valid_loops(loop_from_points(corners), {})};
    std::vector<Edge> edges;
    for (const Pass& pass : plan_adaptive(layer, {}, {}).passes)
      edges.insert(edges.end(), pass.path.begin(), pass.path.end());
    const Regions legal = inset(layer.allowed[0], kTool, {});
    const auto holes = Cover(edges, kTool + 0.005).holes([&](Vec2 p) { return contains(legal, p); });
    EXPECT_TRUE(holes.empty()) << i;
  }
}

}  // namespace
}  // namespace clearcut::plan::adaptive
