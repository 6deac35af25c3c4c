#include "base/text/quantity.h"

#include <gtest/gtest.h>

namespace clearcut {
namespace {

TEST(Quantity, LengthsAreMillimetresUnlessTheySayOtherwise) {
  EXPECT_DOUBLE_EQ(length_in_mm("6").value(), 6);
  EXPECT_DOUBLE_EQ(length_in_mm("6mm").value(), 6);
  EXPECT_DOUBLE_EQ(length_in_mm("6 mm").value(), 6);
  EXPECT_DOUBLE_EQ(length_in_mm("0.25in").value(), 6.35);
  EXPECT_DOUBLE_EQ(length_in_mm("1/4in").value(), 6.35);
  EXPECT_DOUBLE_EQ(length_in_mm("-0.5cm").value(), -5);
}

TEST(Quantity, FeedsAreMillimetresPerMinuteUnlessTheySayOtherwise) {
  EXPECT_DOUBLE_EQ(feed_in_mm_per_min("800").value(), 800);
  EXPECT_DOUBLE_EQ(feed_in_mm_per_min("40in/min").value(), 1016);
  EXPECT_DOUBLE_EQ(feed_in_mm_per_min("40ipm").value(), 1016);
  EXPECT_DOUBLE_EQ(feed_in_mm_per_min("15mm/s").value(), 900);
  EXPECT_DOUBLE_EQ(feed_in_mm_per_min("1.2m/min").value(), 1200);
}

TEST(Quantity, OtherTextIsNone) {
  for (const char* text : {"", "mm", "6mmm", "six", "6,5", "6 7", "1/0", "nan", "inf", "1e999", "6in/min"})
    EXPECT_FALSE(length_in_mm(text)) << text;
  for (const char* text : {"", "fast", "40in", "40%", "800mm/h"})
    EXPECT_FALSE(feed_in_mm_per_min(text)) << text;
}

}  // namespace
}  // namespace clearcut
