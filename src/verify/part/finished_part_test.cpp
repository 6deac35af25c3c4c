#include "verify/part/finished_part.h"

#include <gtest/gtest.h>

#include "geometry/region.h"
#include "model/part.h"
#include "verify/test_program.h"

namespace clearcut::verify {
namespace {

/// Pockets with the same target in one allowed area, as operations on one outline have it: pieces of a cut-out.
Part pieces_of_one_outline(int pieces, double allowed_floor) {
  Part part = testing::pocket_part(testing::rectangle(0, 0, 40, 30), 4, -2);
  for (int i = 1; i < pieces; ++i) {
    Feature piece = part.features[0];
    piece.name += std::to_string(i);
    piece.floor_z = allowed_floor;
    part.features.push_back(piece);
  }
  return part;
}

TEST(FinishedPart, WallsThatFeaturesShareCountOnce) {
  const FinishedPart alone(pieces_of_one_outline(1, -2)), many(pieces_of_one_outline(40, -2));
  EXPECT_EQ(alone.walls().size(), 4u);
  EXPECT_EQ(many.walls().size(), 4u);
  for (std::size_t i = 0; i < alone.walls().size(); ++i) {
    EXPECT_EQ(many.walls()[i].edge, alone.walls()[i].edge);
    EXPECT_EQ(many.walls()[i].z_low, alone.walls()[i].z_low);
    EXPECT_EQ(many.walls()[i].z_high, alone.walls()[i].z_high);
  }
}

TEST(FinishedPart, AWallSharedWithADeeperFeatureGoesDownToItsFloor) {
  const FinishedPart part(pieces_of_one_outline(3, -5));
  ASSERT_EQ(part.walls().size(), 4u);
  for (const Wall& wall : part.walls()) EXPECT_EQ(wall.z_low, -5);
  EXPECT_EQ(part.height({20, 15}), -5);
}

/// A step along the right side of a block. The corner of its allowed area on the block's upper side is `off` mm beside that side, as the rounding
/// of unions leaves it.
Part step_with_a_rounded_corner(double off) {
  Part part = testing::pocket_part(testing::rectangle(75, 0, 100, 50), 4, -2);
  part.stock = Stock{{{0, 0}, {100, 50}}, -10, 0};
  const Vec2 outer[] = {{-50, -50}, {150, -50}, {150, 100}, {-50, 100}};
  const Vec2 rest[] = {{0, 0}, {0, 50}, {75, 50 + off}, {75, 0}};
  part.features[0].allowed = {Region::from_valid_loops(loop_from_points(outer), {loop_from_points(rest)})};
  return part;
}

TEST(FinishedPart, NoWallStandsAlongTheStocksSideBeyondACornerThatIsRounded) {
  for (const double off : {0.0, 1.3e-8, -1.3e-8, 5e-7, -5e-7}) {
    const FinishedPart part(step_with_a_rounded_corner(off));
    for (const Wall& wall : part.walls()) {
      const bool is_beside_step = nearest(wall.edge, {90, 50}).distance < 1;
      EXPECT_FALSE(is_beside_step && wall.stands_at(-1)) << off;
    }
  }
}

}  // namespace
}  // namespace clearcut::verify
