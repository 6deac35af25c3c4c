// Cuts into hollow fillets between floors and walls.
#include "verify/faults/foot_fillet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "verify/test_findings.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using namespace clearcut::testing;

/// A pocket 40 x 40 x 5 with a fillet of 2 mm at the foot of its walls, and one mill of 8 mm.
Part filleted_pocket(double corner) {
  Part part = pocket_part(rectangle(0, 0, 40, 40), 8, -5);
  part.features[0].floor_fillet = 2;
  part.tools[0].corner_radius = corner;
  return part;
}

double gouge_along_wall(double corner, double apart, double z) {
  Writer writer;
  writer.enter({20, 20}, 0, z).feed({20, apart}).feed({30, apart});
  return verify_program(filleted_pocket(corner), writer.done(), {}).all.gouge_mm;
}

TEST(FootFillet, IsCutBySharperCornersOnly) {
  EXPECT_NEAR(gouge_along_wall(0, 4, -5), 2 * std::sqrt(2.0) - 2, 1e-9);
  EXPECT_NEAR(gouge_along_wall(1, 4, -5), std::sqrt(2.0) - 1, 1e-9);
  EXPECT_NEAR(gouge_along_wall(2, 4, -5), 0, 1e-9);
  EXPECT_NEAR(gouge_along_wall(3, 4, -5), 0, 1e-9);
}

TEST(FootFillet, IsLeftWholeByRoughingAsideAndAbove) {
  EXPECT_NEAR(gouge_along_wall(0, 6, -5), 0, 1e-9) << "aside by the radius";
  EXPECT_NEAR(gouge_along_wall(0, 4, -3), 0, 1e-9) << "above by the radius";
  const double aside = 2 - std::sqrt(3.0);  // the fillet's place 1 mm over the floor
  EXPECT_NEAR(gouge_along_wall(0, 4 + aside, -4), 0, 1e-9);
  EXPECT_GT(gouge_along_wall(0, 4 + aside - 0.01, -4), 0.004);
}

TEST(FootFillet, CutAwayIsAFault) {
  const Part part = filleted_pocket(0);
  Writer writer;
  writer.enter({20, 20}, 0, -5).feed({20, 4}).feed({30, 4});
  EXPECT_TRUE(has(verify_program(part, writer.done(), {}), FaultKind::kGouge));
}

/// The fillet is the first pocket's alone: behind the thin wall beside it the floor meets the wall sharply.
TEST(FootFillet, IsNotCutFromTheOtherSideOfAThinWall) {
  Part part = filleted_pocket(0);
  Feature other = part.features[0];
  other.floor_fillet = 0;
  other.target = other.allowed = rectangle(0, -20.5, 40, -0.5);
  part.features.push_back(other);
  Writer writer;
  writer.enter({20, -10}, 0, -5).feed({20, -4.5}).feed({30, -4.5});
  EXPECT_NEAR(verify_program(part, writer.done(), {}).all.gouge_mm, 0, 1e-9);
}

Move move_from(Vec2 a, Vec2 b, double z_from, double z_to) {
  Move move;
  move.path = Edge::line(a, b);
  move.z_from = z_from;
  move.z_to = z_to;
  return move;
}

/// mm; greatest depth, across the surface of a fillet at the foot of a wall that leans by `draft`, of samples of the cutter's surface, for
/// its axis `apart` mm from the foot.
double sampled_depth(const CutterProfile& cutter, double radius, double draft, double apart, double above) {
  const double center = radius * std::tan(kPi / 4 - draft / 2);
  double deepest = 0;
  for (int i = 0; i <= 20000; ++i) {
    const double r = cutter.widest * i / 20000.0, x = apart - r, z = above + cutter.height_at(r);
    const double across = x - center, up = z - radius;
    const bool is_over_wall = x * std::cos(draft) + z * std::sin(draft) < 0;
    const bool is_beside_fillet = across >= 0 || up * std::cos(draft) >= across * std::sin(draft);
    if (!is_over_wall && !is_beside_fillet) deepest = std::max(deepest, std::hypot(across, up) - radius);
  }
  return deepest;
}

TEST(FootFillet, DepthIsThatOfSamplesOfTheCuttersSurface) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 300; ++i) {
    Part part = filleted_pocket(0);
    Tool& tool = part.tools[0];
    tool.diameter = between(2, 10);
    tool.corner_radius = i % 3 == 0 ? 0 : between(0.1, tool.diameter / 2);
    if (i % 3 == 2) {
      tool.kind = ToolKind::kBallEndMill;
      tool.corner_radius = tool.diameter / 2;
    }
    const double fillet = part.features[0].floor_fillet = between(0.3, 4);
    const double draft = i % 2 == 0 ? 0 : between(0.01, 0.8);
    part.features[0].wall_slope = Radians::of(draft);
    const double apart = tool.radius() + between(0, fillet), above = between(0, fillet);
    const FinishedPart finished(part);
    const double y = apart + 5 * std::tan(draft);
    const Move move = move_from({20, y}, {25, y}, -5 + above, -5 + above);
    const auto found = fillet_gouge_of(finished, move, outer_profile(tool));
    EXPECT_NEAR(found ? found->depth : 0, sampled_depth(outer_profile(tool), fillet, draft, apart, above),
                2e-3)
        << i << ": fillet " << fillet << " at a wall that leans by " << draft << ", cutter " << tool.diameter
        << " with " << tool.corner_radius << ", " << apart << " from the foot, " << above
        << " over the floor";
  }
}

TEST(FootFillet, OfASlopingMoveIsThatOfItsPlaces) {
  const FinishedPart finished(filleted_pocket(0));
  const CutterProfile cutter = CutterProfile::cylinder(4);
  const Move sinking = move_from({10, 8}, {30, 4}, -3, -5);
  double deepest = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double t = i / 4000.0;
    const Vec2 p = sinking.path.at(t);
    const double z = std::lerp(sinking.z_from, sinking.z_to, t);
    const auto there = fillet_gouge_of(finished, move_from(p, p, z, z), cutter);
    if (there) deepest = std::max(deepest, there->depth);
  }
  const auto found = fillet_gouge_of(finished, sinking, cutter);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, deepest, 2e-5);
}

}  // namespace
}  // namespace clearcut::verify
