// The strategy tour, whatever the order of visits: legal, and nothing left.
#include "plan/tour/tour.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/error.h"
#include "base/random.h"
#include "geometry/contours/boolean.h"
#include "geometry/route/legal_area.h"
#include "geometry/voronoi/clearance.h"
#include "plan/common/cover.h"

namespace clearcut::plan::tour {
namespace {

Region rectangle(double x0, double y0, double x1, double y1) {
  const std::vector<Vec2> corners{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

/// Row by row as given.
std::vector<int> in_order(const TourTask& task) {
  std::vector<int> order(task.points.size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// The worst optimiser there is: crosses every island many times.
TourSolver shuffled(std::uint64_t seed) {
  return [seed](const TourTask& task) {
    auto order = in_order(task);
    Random random(seed);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
  };
}

Layer layer_of(Regions regions, double radius) {
  Layer layer;
  layer.z = -1;
  layer.target = layer.allowed = std::move(regions);
  layer.tool_radius = radius;
  return layer;
}

Regions random_pocket(Random& random) {
  Regions area{rectangle(0, 0, random.between(30, 70), random.between(30, 70))};
  for (int i = 0; i < 3; ++i) {
    const Vec2 p{random.between(-5, 60), random.between(-5, 60)};
    const Region bar = rectangle(p.x, p.y, p.x + random.between(2, 25), p.y + random.between(2, 25));
    area = subtract(area, {bar}, {});
  }
  return area;
}

void expect_legal_and_clear(const Layer& layer, const LayerPasses& passes) {
  std::vector<Edge> edges;
  for (const auto& pass : passes.passes) {
    for (const auto& edge : pass.path) {
      if (edge.from != edge.to) edges.push_back(edge);
      const bool legal = std::any_of(passes.legal.begin(), passes.legal.end(), [&](const Region& region) {
        return edge.is_arc() || LegalArea({region}).holds_line(edge.from, edge.to);
      });
      EXPECT_TRUE(pass.closed || legal);
    }
  }
  const Cover cover(edges, layer.tool_radius);
  const LegalArea legal(passes.legal);
  EXPECT_TRUE(cover.holes([&](Vec2 p) { return legal.contains(p) && contains(layer.target, p); }).empty());
}

/// Rows meet both ends of the longer side and lie in the middle of the shorter one.
TEST(PlanTour, AFittedLatticeLiesInTheMiddle) {
  Box box;
  box.add(Vec2{2, 3});
  box.add(Vec2{42, 24});
  const Lattice lattice = fitted_lattice(box, 9);
  EXPECT_EQ(lattice.columns, 6);
  EXPECT_EQ(lattice.rows, 3);
  EXPECT_NEAR(lattice.pitch, 8, 1e-12);
  EXPECT_NEAR(lattice.corner.x, 2, 1e-12);
  EXPECT_NEAR(lattice.corner.y, 5.5, 1e-12);
}

TEST(PlanTour, AnyOrderInRandomPocketsIsLegalAndLeavesNothing) {
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const Layer layer = layer_of(random_pocket(random), random.between(1.5, 4));
    expect_legal_and_clear(layer, plan_tour(layer, {}, i % 2 == 0 ? TourSolver(in_order) : shuffled(i), {}));
  }
}

TEST(PlanTour, WideGridsAreMended) {
  Random random(4);
  for (int i = 0; i < 10; ++i) {
    const Layer layer = layer_of(random_pocket(random), random.between(2, 4));
    TourGridOptions options;
    options.pitch = random.between(0.75, 1.2);
    expect_legal_and_clear(layer, plan_tour(layer, options, in_order, {}));
  }
}

TEST(PlanTour, ThePublishedGridLeavesARim) {
  const Layer layer = layer_of({rectangle(0, 0, 57, 43)}, 5);
  TourGridOptions options;
  options.published = true;
  options.pitch = 1;
  const auto passes = plan_tour(layer, options, in_order, {});
  ASSERT_EQ(passes.passes.size(), 1u);
  // 5 x 4 points: the legal area is 47 x 33 mm, boundary points count.
  EXPECT_EQ(passes.passes[0].path.front().from, (Vec2{5, 5}));
  const Cover cover(passes.passes[0].path, layer.tool_radius);
  EXPECT_FALSE(cover.holds({54, 20}));
  ASSERT_EQ(passes.remarks.size(), 1u);
  EXPECT_EQ(passes.remarks[0].title, "RIM OF THE PUBLISHED GRID");
  // A rim along one wall alone.
  EXPECT_EQ(plan_tour(layer_of({rectangle(0, 0, 20, 23)}, 5), options, in_order, {}).remarks.size(), 1u);
  // Two columns of a pocket twice as wide as the cutter leave nothing.
  EXPECT_TRUE(plan_tour(layer_of({rectangle(0, 0, 20, 10)}, 5), options, in_order, {}).remarks.empty());
}

/// An open side reaches a metre out of the part; the grid does not, 7.6.
TEST(PlanTour, ThePublishedGridEndsARadiusBeyondOpenSides) {
  Layer layer = layer_of({rectangle(0, 0, 60, 40)}, 5);
  layer.allowed = {rectangle(0, -1000, 1060, 1040)};
  TourGridOptions options;
  options.published = true;
  options.pitch = 0.5;
  std::size_t points = 0;
  const auto passes = plan_tour(layer, options,
                                [&](const TourTask& task) {
                                  points = task.points.size();
                                  return in_order(task);
                                },
                                {});
  // From the wall's 5 mm to 65 mm, from -5 to 45 mm.
  EXPECT_EQ(points, 13u * 11u);
  ASSERT_EQ(passes.passes.size(), 1u);
  EXPECT_EQ(passes.passes[0].path.front().from, (Vec2{5, -5}));
  // So that rapids of the layer below rise above what is left here.
  EXPECT_GT(passes.residual, 0);
}

TEST(PlanTour, NothingWhereTheCutterDoesNotFit) {
  EXPECT_TRUE(plan_tour(layer_of({rectangle(0, 0, 20, 5)}, 4), {}, in_order, {}).passes.empty());
}

TEST(PlanTour, PitchIsAShareOrMillimetres) {
  EXPECT_DOUBLE_EQ(parse_tour_grid("0.5").pitch, 0.5);
  EXPECT_TRUE(parse_tour_grid("3mm").pitch_in_mm);
  EXPECT_THROW(parse_tour_grid("lom"), InputError);
}

}  // namespace
}  // namespace clearcut::plan::tour
