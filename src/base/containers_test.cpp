#include "base/containers.h"

#include <gtest/gtest.h>

namespace clearcut::inline base {
namespace {

TEST(DisjointSets, AreJoinedThroughAnyOfTheirNumbers) {
  DisjointSets sets(6);
  EXPECT_NE(sets.find(0), sets.find(1));
  sets.join(0, 1);
  sets.join(2, 3);
  sets.join(1, 3);
  for (const int i : {1, 2, 3}) EXPECT_EQ(sets.find(i), sets.find(0));
  EXPECT_EQ(sets.find(0), 3);
  EXPECT_EQ(sets.find(4), 4);
  EXPECT_NE(sets.find(4), sets.find(5));
}

}  // namespace
}  // namespace clearcut::inline base
