#include "base/units.h"

#include <gtest/gtest.h>

namespace clearcut::inline base {
namespace {

template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};

static_assert(Addable<MmPerMin, MmPerMin>);
static_assert(!Addable<MmPerMin, Seconds>);
static_assert(!Addable<Radians, Seconds>);
static_assert(!Addable<MmPerMin, double>);

TEST(Units, NamedFactoriesAndAccessorsAgree) {
  EXPECT_DOUBLE_EQ(MmPerMin::of(600).mm_per_s(), 10);
  EXPECT_DOUBLE_EQ(Radians::of_degrees(180).radians(), kPi);
  EXPECT_DOUBLE_EQ(Radians::of(kPi / 2).degrees(), 90);
  EXPECT_DOUBLE_EQ((Seconds::of(2) + Seconds::of(3)).seconds(), 5);
}

}  // namespace
}  // namespace clearcut::inline base
