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

}  // namespace
}  // namespace clearcut::verify
