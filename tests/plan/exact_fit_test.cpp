// Random pockets with the widest cutter that goes in at all, and slots and necks of the cutter's width within
// micrometres: planner and verifier must be of one mind about what fits.
#include <gtest/gtest.h>

#include <array>
#include <span>

#include "base/error.h"
#include "base/random.h"
#include "features/tool_choice.h"
#include "pipeline/run.h"
#include "resolve/resolve.h"

namespace clearcut {
namespace {

Part part_of(std::span<const BulgeVertex> outline) {
  Feature feature;
  feature.name = "POCKET";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_bulges(outline), {})};
  feature.floor_z = -2;
  Part part;
  part.name = part.source_file = "random";
  part.features = {feature};
  part.workplan.push_back({});
  return part;
}

Part random_pocket(int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  const int corners = 3 + static_cast<int>(random.below(8));
  std::vector<BulgeVertex> outline;
  for (int i = 0; i < corners; ++i) {
    const double t = 2 * kPi * i / corners + random.between(-0.2, 0.2);
    const Vec2 p = direction_of(t) * random.between(15, 30);
    outline.push_back({p, random.below(3) == 0 ? random.between(-0.2, 0.3) : 0});
  }
  return part_of(outline);
}

PlanOptions with_diameter(double diameter) {
  Tool tool;
  tool.diameter = diameter;
  PlanOptions options;
  options.tools = {tool};
  return options;
}

TEST(ExactFit, TheWidestCutterIsPlannedCleanAndAWiderOneRefused) {
  for (int seed = 0; seed < 30; ++seed) {
    const Part part = random_pocket(seed);
    const double widest = features::largest_fitting_diameter(part.features[0], {});
    for (const double over : {-0.0004, 0.0, 0.0006}) {
      const auto result = pipeline::plan_part(part, with_diameter(widest + over));
      EXPECT_TRUE(result.findings.all.clean) << seed << " over by " << over;
    }
    EXPECT_THROW(pipeline::plan_part(part, with_diameter(widest + 0.01)), InputError) << seed;
  }
}

/// An outline under a random angle.
class Turned {
 public:
  explicit Turned(Random& random) : angle_(random.below(3) == 0 ? 0 : random.between(0, 2 * kPi)) {}
  void add(double x, double y, double bulge = 0) { vertices_.push_back({rotated({x, y}, angle_), bulge}); }
  Part part() const { return part_of(vertices_); }

 private:
  double angle_;
  std::vector<BulgeVertex> vertices_;
};

/// Two chambers joined by a neck, which may widen or narrow a little.
Part neck(double width, double diameter, Random& random) {
  const double length = random.between(0.02, 1) * random.between(0.02, 25);
  const double a = random.between(1.1, 4) * diameter, b = random.between(1.1, 4) * diameter;
  const double low = random.between(0, 0.8) * (std::min(a, b) - width), high = low + width;
  const double taper = random.below(2) == 0 ? 0 : random.between(-0.001, 0.001);
  Turned outline(random);
  for (const Vec2 p : {Vec2{0, 0},
                       {a, 0},
                       {a, low},
                       {a + length, low + taper},
                       {a + length, 0},
                       {a + length + b, 0},
                       {a + length + b, b},
                       {a + length, b},
                       {a + length, high - taper},
                       {a, high},
                       {a, a},
                       {0, a}}) {
    outline.add(p.x, p.y);
  }
  return outline.part();
}

/// Dead ends, square and round, on one side of a chamber.
Part comb(double width, double diameter, Random& random) {
  const auto teeth = 1 + random.below(4);
  const double gap = random.between(0.3, 2) * diameter, height = random.between(1.2, 3) * diameter;
  Turned outline(random);
  outline.add(0, 0);
  outline.add(static_cast<double>(teeth) * (width + gap) + gap, 0);
  outline.add(static_cast<double>(teeth) * (width + gap) + gap, height);
  for (auto i = teeth; i-- > 0;) {
    const double left = gap + static_cast<double>(i) * (width + gap), end = height + random.between(0.05, 20);
    outline.add(left + width, height);
    outline.add(left + width, end, random.below(2) == 0 ? 0 : 1);
    outline.add(left, end);
    outline.add(left, height);
  }
  outline.add(0, height);
  return outline.part();
}

/// A slot alone, with square and round ends, down to a hole.
Part slot(double width, double, Random& random) {
  const double length = width + random.between(0.001, 1) * random.between(0.1, 30);
  Turned outline(random);
  outline.add(0, 0);
  outline.add(length, 0, random.below(2) == 0 ? 0 : 1);
  outline.add(length, width);
  outline.add(0, width, random.below(2) == 0 ? 0 : 1);
  return outline.part();
}

TEST(ExactFit, PlannerAndVerifierAgreeAboutSlotsOfTheCuttersWidthToMicrometres) {
  int planned = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Random random(seed);
    const double diameter = random.between(2, 10), over = random.between(-0.003, 0.003);
    constexpr std::array kMakers{neck, comb, slot};
    const Part part = kMakers[seed % kMakers.size()](diameter + over, diameter, random);
    PlanOptions options = with_diameter(diameter);
    options.strategy = "contour";
    try {
      const auto result = pipeline::plan_part(part, options);
      EXPECT_TRUE(result.findings.all.clean) << seed << " over by " << over;
      ++planned;
    } catch (const InputError&) {
      EXPECT_LT(over, -0.0017) << seed;
      EXPECT_EQ(seed % kMakers.size(), 2u) << "only a slot alone leaves nothing to cut: " << seed;
    }
  }
  EXPECT_GT(planned, 120);
}

}  // namespace
}  // namespace clearcut
