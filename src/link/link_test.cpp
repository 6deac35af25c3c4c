#include "link/link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/kinematics.h"
#include "link/work.h"

namespace clearcut::link {
namespace {

Region square(Vec2 center, double half) {
  return Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{center.x - half, center.y - half},
                                                                     {center.x + half, center.y - half},
                                                                     {center.x + half, center.y + half},
                                                                     {center.x - half, center.y + half}}),
                                  {});
}

Pass ring(Vec2 center, double half) {
  Pass pass;
  const Region around = square(center, half);
  pass.path = around.outer();
  pass.closed = true;
  return pass;
}

/// Square pockets of 10 mm side at `centers`, one ring each, cut with 6 mm in `count` layers of 2 mm.
std::vector<LayerPasses> layers_of_pockets(const std::vector<Vec2>& centers, int count) {
  std::vector<LayerPasses> layers;
  for (int i = 0; i < count; ++i) {
    LayerPasses layer;
    layer.z_top = -2.0 * i;
    layer.z = layer.z_top - 2;
    for (std::size_t k = 0; k < centers.size(); ++k) {
      layer.legal.push_back(square(centers[k], 2));
      layer.target.push_back(square(centers[k], 5));
      layer.passes.push_back(ring(centers[k], 2));
      layer.passes.back().component = static_cast<int>(k);
    }
    layers.push_back(std::move(layer));
  }
  return layers;
}

LinkOptions options_with_radius(double radius) {
  LinkOptions options;
  options.tool_radius = radius;
  options.cross_z = 2;
  return options;
}

/// Centres of the pockets in the order in which cutting moves come to them, without repetition.
std::vector<double> visited(const Section& section) {
  std::vector<double> xs;
  for (const Move& move : section.moves) {
    const double x = std::round(move.path.to.x / 20) * 20;
    if (move.kind == MoveKind::kCut && (xs.empty() || xs.back() != x)) xs.push_back(x);
  }
  return xs;
}

TEST(Link, AreasApartAreEachCutToTheBottom) {
  const auto layers = layers_of_pockets({{0, 0}, {20, 0}, {40, 0}}, 4);
  const Section section = link_layers(layers, options_with_radius(3), {});
  EXPECT_EQ(visited(section).size(), 3u);
}

TEST(Link, AreasWhoseSweepsMeetAreCutLayerByLayer) {
  // 16 mm apart with 8 mm of radius: the cutter in one pocket reaches over the other.
  std::vector<LayerPasses> layers = layers_of_pockets({{0, 0}, {20, 0}}, 3);
  const Work work(layers, 9.5);
  for (std::size_t i = 2; i < work.items().size(); ++i) EXPECT_EQ(work.before(i).size(), i / 2 * 2);
  EXPECT_FALSE(Progress(work, Progress::Layers::kMixed).available(2));
}

TEST(Link, RapidsBetweenAreasCrossOverAllThatStands) {
  const auto layers = layers_of_pockets({{0, 0}, {20, 0}, {40, 0}}, 2);
  const LinkOptions options = options_with_radius(3);
  const Section section = link_layers(layers, options, {});
  int crossings = 0;
  for (const Move& move : section.moves) {
    if (!is_rapid(move.kind) || distance(move.path.from, move.path.to) < 10) continue;
    ++crossings;
    EXPECT_EQ(move.z_from, options.cross_z);
    EXPECT_EQ(move.z_to, options.cross_z);
  }
  EXPECT_EQ(crossings, 2);
  EXPECT_EQ(section.moves.back().z_to, options.safe_z);
}

TEST(Link, NextLayerBelowTheCutterIsEnteredWithoutGoingUp) {
  const auto layers = layers_of_pockets({{0, 0}}, 3);
  for (const EntryKind entry : {EntryKind::kPlunge, EntryKind::kRamp}) {
    LinkOptions options = options_with_radius(3);
    options.entry = entry;
    const Section section = link_layers(layers, options, {});
    double highest_inside = -10;
    for (std::size_t i = 2; i + 1 < section.moves.size(); ++i)
      highest_inside = std::max(highest_inside, section.moves[i].z_to);
    EXPECT_LE(highest_inside, 0) << static_cast<int>(entry);
    EXPECT_EQ(section.moves[section.moves.size() - 2].z_to, -6);
  }
}

TEST(Link, WhereTheCutterOnlyComesDownItComesUpForEveryLayer) {
  std::vector<LayerPasses> layers = layers_of_pockets({{0, 0}}, 3);
  for (LayerPasses& layer : layers) {
    layer.legal = {square({0, 0}, 0.001)};
    layer.passes.front().path = {Edge::line({0, 0}, {0, 0})};
    layer.passes.front().closed = false;
  }
  double at_once = 0, most = 0;  // mm down without a rapid between
  for (const Move& move : link_layers(layers, options_with_radius(3), {}).moves) {
    at_once = is_rapid(move.kind) ? 0 : at_once + move.z_from - move.z_to;
    most = std::max(most, at_once);
  }
  EXPECT_NEAR(most, 3, 1e-9);
}

TEST(Link, EntriesBesideTheCutterBeginWhereItIsTaken) {
  // A helix into the next layer begins beside the start of the pass, at another angle from another height.
  std::vector<LayerPasses> layers = layers_of_pockets({{0, 0}}, 3);
  for (LayerPasses& layer : layers) layer.legal = {square({0, 0}, 2.5)};
  LinkOptions options = options_with_radius(3);
  options.entry = EntryKind::kHelix;
  options.entry_angle = Radians::of_degrees(7);
  const Section section = link_layers(layers, options, {});
  for (std::size_t i = 1; i < section.moves.size(); ++i) {
    EXPECT_LE(distance(section.moves[i - 1].path.to, section.moves[i].path.from), 1e-6) << i;
    EXPECT_NEAR(section.moves[i - 1].z_to, section.moves[i].z_from, 1e-9) << i;
  }
}

TEST(Link, WayThroughAreasInARowIsTheShortOne) {
  // Nearest first from the one cut first goes to and fro; the row has one best way.
  const auto layers = layers_of_pockets({{60, 0}, {40, 0}, {80, 0}, {0, 0}, {120, 0}, {20, 0}, {100, 0}}, 1);
  const auto xs = visited(link_layers(layers, options_with_radius(3), {}));
  ASSERT_EQ(xs.size(), 7u);
  EXPECT_TRUE(std::is_sorted(xs.begin(), xs.end()) || std::is_sorted(xs.rbegin(), xs.rend()));
}

}  // namespace
}  // namespace clearcut::link
