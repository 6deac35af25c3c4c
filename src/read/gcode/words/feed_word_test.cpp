#include <gtest/gtest.h>

#include "base/error.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

std::string fed(std::string_view line, double value) {
  return with_feed_word(line, value, "p.ngc:1");
}

TEST(FeedWord, IsFoundOutsideCommentsAndMessages) {
  EXPECT_EQ(feed_word_in("N10 G1 X1 F250 (F99)")->value, 250);
  EXPECT_EQ(feed_word_in("g1x1f12.5;F7")->value, 12.5);
  EXPECT_EQ(feed_word_in("G1 F 1 000 X2")->value, 1000);
  EXPECT_FALSE(feed_word_in("G1 X1 (F99) Y2"));
  EXPECT_FALSE(feed_word_in("M117 Fast F100"));
  EXPECT_FALSE(feed_word_in("M0 Finished F100"));
}

TEST(FeedWord, AnotherFeedChangesNothingElse) {
  EXPECT_EQ(fed("N10 G1 X1.500 F250. (a) Y2", 123.45), "N10 G1 X1.500 F123.4 (a) Y2");
  EXPECT_EQ(fed("G1X1F250Y2", 1999.9), "G1X1F1999Y2");
  EXPECT_EQ(fed("G1 X1 F250.", 300), "G1 X1 F300.");
}

TEST(FeedWord, ALineWithoutOneGetsItBehindItsLastWord) {
  EXPECT_EQ(fed("X1 Y2", 500), "X1 Y2 F500");
  EXPECT_EQ(fed("X1 Y2  (wall) ; end", 500), "X1 Y2 F500  (wall) ; end");
  EXPECT_EQ(fed("X1 (a) Y2", 0.123456), "X1 (a) Y2 F0.12345");
}

TEST(FeedWord, AChecksumIsNotMadeWrong) {
  EXPECT_THROW(fed("N1 G1 X1 F100*71", 50), InputError);
}

}  // namespace
}  // namespace clearcut::read::gcode
