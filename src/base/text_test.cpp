#include "base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clearcut::inline base {
namespace {

using ::testing::ElementsAre;

TEST(Format, TrimsZerosAndNeverWritesAMinusZero) {
  EXPECT_EQ(trimmed(1.5, 4), "1.5");
  EXPECT_EQ(trimmed(-2, 3), "-2");
  EXPECT_EQ(trimmed(100, 0), "100");
  EXPECT_EQ(trimmed(-0.00004, 4), "0");
}

TEST(Format, SplitKeepsEmptyParts) {
  EXPECT_THAT(split("a:bc:d", ':'), ElementsAre("a", "bc", "d"));
  EXPECT_THAT(split(",a,,", ','), ElementsAre("", "a", "", ""));
  EXPECT_THAT(split("", ','), ElementsAre(""));
}

}  // namespace
}  // namespace clearcut::inline base

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

namespace clearcut::inline base {
namespace {

TEST(XmlText, KeepsGoodUtf8AndReplacesTheRest) {
  EXPECT_EQ(xml_escaped("<a b=\"c\" & 'd'>"), "&lt;a b=&quot;c&quot; &amp; &#39;d&#39;&gt;");
  EXPECT_EQ(xml_escaped("gr\xc3\xbc\xc3\x9f \xe2\x82\xac \xf0\x9f\x94\xa7"),
            "gr\xc3\xbc\xc3\x9f \xe2\x82\xac \xf0\x9f\x94\xa7");
  EXPECT_EQ(xml_escaped(std::string_view("\x01\x00", 2)), "??");
  EXPECT_EQ(xml_escaped("\xff\xc3"), "??");
  EXPECT_EQ(xml_escaped("\xed\xa0\x80"), "???") << "a surrogate is no character";
  EXPECT_EQ(xml_escaped("\xc0\xaf"), "??") << "overlong";
}

}  // namespace
}  // namespace clearcut::inline base
