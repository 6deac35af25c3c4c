// Contours with sharp reflex corners: against the papers' lengths, and against offsets side by side on random polygons.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/units.h"
#include "geometry/contours/mitred_inset.h"
#include "plan/common/cover.h"
#include "plan/contour/contour.h"
#include "plan/contour/published_rings.h"
#include "plan/contour/side_offsets.h"

namespace clearcut::plan::contour {
namespace {

/// CPO-kappa figure 9: 12 sides of 60 mm, tips of 90 degrees and reflex corners of 210 in turn.
SideList star() {
  SideList list;
  for (int i = 0; i < 12; ++i) {
    const double degrees = i % 2 == 0 ? 210 : 90;
    list.sides.push_back({60, degrees * kPi / 180, 0});
  }
  return list;
}

Region region_of(const SideList& list) {
  return Region::from_valid_loops(closed_by_compass_rule(traced(list)), {});
}

double length_of_ring(const RingNode& ring) {
  double sum = 0;
  for (const Edge& edge : ring.contour.edges()) sum += edge.length();
  return sum;
}

TEST(MitredRings, OfFigureNineAreSixSimilarStars) {
  const double radius = 8;
  const auto step_of = [&](const RingNode& ring, const std::vector<AxisPiece>&) {
    return 2 * radius * kappa(smallest_angle(ring.contour));
  };
  const auto rings = mitred_ring_tree(region_of(star()), radius, step_of, {});
  ASSERT_EQ(rings.size(), 6U);
  EXPECT_NEAR(rings.back().level, 76.2843, 1e-4);
  double total = 0;
  for (const RingNode& ring : rings) {
    EXPECT_EQ(ring.contour.outer().size(), 12U);
    EXPECT_FALSE(has_arcs(ring.contour));
    total += length_of_ring(ring);
  }
  const auto step = [&](double angle) { return 2 * radius * kappa(angle); };
  const PublishedLength published = published_length(star(), radius, 0, step);
  ASSERT_EQ(published.lengths.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(length_of_ring(rings[i]), published.lengths[i], 1e-3);
  EXPECT_NEAR(total + published.passages, 2195.3553, 1e-3);
}

Loop random_polygon(int corners, std::mt19937& random, std::uniform_real_distribution<double>& share) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * (i + 0.8 * share(random)) / corners, from = 10 + 40 * share(random);
    points.push_back({from * std::cos(angle), from * std::sin(angle)});
  }
  return loop_from_points(points);
}

/// Every side of an inset is a side of the region, moved in; no place of it is nearer to the boundary than the distance.
TEST(MitredInset, OfRandomPolygonsHasMovedSidesAndKeepsItsDistance) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  int insets = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Loop loop = random_polygon(5 + trial % 9, random, share);
    const Region region = Region::from_valid_loops(loop, {});
    const double distance = 0.5 + 3 * share(random);
    for (const Region& inset : mitred_inset(region, distance, {})) {
      ++insets;
      for (const Edge& edge : inset.edges()) {
        EXPECT_GT(region.boundary_distance(edge.at(0.5)), distance - 1e-5);
        EXPECT_TRUE(region.contains(edge.at(0.5)));
        const bool is_moved_side = std::any_of(loop.begin(), loop.end(), [&](const Edge& side) {
          const Vec2 along = side.tangent_at(0), to = edge.at(0.5) - side.from;
          return std::abs(cross(along, to) - distance) < 1e-4 &&
                 (edge.length() < 1e-3 || std::abs(cross(along, edge.tangent_at(0))) < 1e-2);
        });
        EXPECT_TRUE(is_moved_side) << "trial " << trial;
      }
    }
  }
  EXPECT_GT(insets, 150);
}

Layer pocket_of(const Loop& outline, double radius) {
  Layer layer;
  layer.z = -1;
  layer.target = layer.allowed = {Region::from_valid_loops(outline, {})};
  layer.tool_radius = radius;
  return layer;
}

struct MethodRow {
  const char* step;
  ResidualRule residuals;
  bool clears;  ///< whether the method clears everything
};

constexpr MethodRow kMethods[] = {
    {"widest", ResidualRule::kOurs, true},        {"lom", ResidualRule::kNone, false},
    {"rho", ResidualRule::kNone, false},          {"second", ResidualRule::kPassages, false},
    {"lom-corrected", ResidualRule::kNone, true}, {"rho-corrected", ResidualRule::kNone, true},
    {"0.9", ResidualRule::kNone, false},          {"0.9", ResidualRule::kLoops, true},
    {"0.9", ResidualRule::kPwid, true},           {"0.9", ResidualRule::kSingleLoops, true},
    {"0.9", ResidualRule::kDoubleLoops, true},    {"0.9", ResidualRule::kBisectors, false}};

std::size_t corners_with_arcs(const LayerPasses& planned, Vec2 reflex) {
  std::size_t arcs = 0;
  for (const Pass& pass : planned.passes)
    arcs += static_cast<std::size_t>(std::count_if(pass.path.begin(), pass.path.end(), [&](const Edge& edge) {
      return edge.is_arc() && norm(edge.center - reflex) < 1e-6;
    }));
  return arcs;
}

ContourOptions sharp_rho_corrected() {
  ContourOptions options;
  options.step = parse_step_rule("rho-corrected");
  options.residuals = ResidualRule::kNone;
  options.effort = 0;
  options.sharp_reflex = true;
  return options;
}

/// Contours that were to keep reflex corners and do not say so, and why.
TEST(ReflexCorners, ThatAreRoundInPlaceOfKeptAreSaid) {
  const Layer unproven = pocket_of(closed_by_compass_rule(traced(star())), 8);
  const std::vector<Vec2> points{{0, 0}, {120, 0}, {120, 40}, {60, 40}, {60, 90}, {0, 90}};
  Loop angle = loop_from_points(points);
  angle[0] = Edge::arc({0, 0}, {120, 0}, {60, 80}, Turn::kCounterClockwise);
  const Layer with_arc = pocket_of(angle, 4);
  const std::vector<Vec2> farther{{-900, 0}, {120, 0}, {120, 40}, {60, 40}, {60, 90}, {-900, 90}};
  Layer open = pocket_of(loop_from_points(points), 4);
  open.allowed = {Region::from_valid_loops(loop_from_points(farther), {})};
  const std::pair<const Layer*, const char*> rows[] = {
      {&unproven, "not proven to leave nothing"}, {&with_arc, "has arcs"}, {&open, "has open sides"}};
  for (const auto& [layer, why] : rows) {
    const auto remarks = plan_contour(*layer, sharp_rho_corrected(), {}).remarks;
    ASSERT_EQ(remarks.size(), 1U) << why;
    EXPECT_EQ(remarks[0].title, "ROUND AT REFLEX CORNERS");
    EXPECT_NE(remarks[0].text.find(why), std::string::npos) << remarks[0].text;
  }
  const std::vector<Vec2> plate{{0, 0}, {120, 0}, {120, 40}, {0, 40}};
  const Layer convex = pocket_of(loop_from_points(plate), 4);
  EXPECT_TRUE(plan_contour(convex, sharp_rho_corrected(), {}).remarks.empty());
}

/// By every method contours are round about the reflex corner of an angle, or keep it; what clears everything does so.
TEST(ReflexCorners, AreRoundOrKeptByEveryMethod) {
  const Vec2 reflex{60, 40};
  const std::vector<Vec2> points{{0, 0}, {120, 0}, {120, 40}, reflex, {60, 90}, {0, 90}};
  const Layer layer = pocket_of(loop_from_points(points), 4);
  for (const MethodRow& method : kMethods) {
    ContourOptions options;
    options.step = parse_step_rule(method.step);
    options.residuals = method.residuals;
    options.effort = 0;
    for (const bool sharp : {false, true}) {
      options.sharp_reflex = sharp;
      const LayerPasses planned = plan_contour(layer, options, {});
      EXPECT_EQ(corners_with_arcs(planned, reflex) > 0, !sharp) << method.step;
      EXPECT_TRUE(!method.clears || leaves_nothing(planned, layer.tool_radius)) << method.step;
      EXPECT_TRUE(planned.remarks.empty()) << method.step;
    }
  }
}

/// On any polygon: what clears everything with round corners does so with sharp ones.
TEST(ReflexCorners, KeptByMethodsThatClearEverythingLeaveNothing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int trial = 0; trial < 12; ++trial) {
    const Layer layer = pocket_of(random_polygon(5 + trial % 7, random, share), 1.5 + 2 * share(random));
    for (const MethodRow& method : kMethods) {
      if (!method.clears) continue;
      ContourOptions options;
      options.step = parse_step_rule(method.step);
      options.residuals = method.residuals;
      options.sharp_reflex = true;
      EXPECT_TRUE(leaves_nothing(plan_contour(layer, options, {}), layer.tool_radius))
          << trial << " " << method.step;
    }
  }
}

}  // namespace
}  // namespace clearcut::plan::contour
