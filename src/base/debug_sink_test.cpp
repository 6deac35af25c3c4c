#include "base/debug_sink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <pugixml.hpp>

#include "base/file.h"

namespace clearcut::inline base {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Frames : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(CLEARCUT_BINARY_DIR) / "debug" / test->name();
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  static std::string well_formed(const fs::path& file) {
    const std::string text = read_file(file.string());
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(text.c_str())) << text;
    return text;
  }
  fs::path folder_;
};

TEST_F(Frames, AreNumberedAndNamed) {
  SvgFrames frames(folder_, "offset");
  frames.frame("raw / offsets");
  frames.line(0, 0, 10, 5, "blue");
  frames.frame("clipped");
  frames.polyline({{0, 0}, {10, 0}, {10, 10}}, true, "black");
  frames.finish();
  ASSERT_EQ(frames.written().size(), 2u);
  EXPECT_EQ(frames.written()[0].filename(), "offset-001-raw-offsets.svg");
  EXPECT_EQ(frames.written()[1].filename(), "offset-002-clipped.svg");
  EXPECT_THAT(well_formed(frames.written()[0]), HasSubstr("M0 0L10 5"));
  EXPECT_THAT(well_formed(frames.written()[1]), HasSubstr("M0 0L10 0L10 10Z"));
}

TEST_F(Frames, LeaveNothingBehindWhenNothingWasDrawn) {
  {
    SvgFrames frames(folder_, "empty");
    frames.frame("nothing");
    frames.frame("nothing again");
  }
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Frames, TheLastIsWrittenAtTheEnd) {
  {
    SvgFrames frames(folder_, "end");
    frames.dot(1, 2, "<here> & there", "\"red\"");
  }
  const std::string text = well_formed(folder_ / "end-001.svg");
  EXPECT_THAT(text, HasSubstr("&lt;here&gt; &amp; there"));
}

TEST_F(Frames, ArcsStayArcsOnTheirSide) {
  SvgFrames frames(folder_, "arc");
  frames.arc(1, 0, 0, 1, 0, 0, true, "blue");    // a quarter
  frames.arc(1, 0, 0, 1, 0, 0, false, "green");  // the other three
  frames.finish();
  const std::string text = well_formed(frames.written()[0]);
  EXPECT_THAT(text, HasSubstr("M1 0A1 1 0 0 1 0 1"));
  EXPECT_THAT(text, HasSubstr("M1 0A1 1 0 1 0 0 1"));
}

TEST_F(Frames, NumbersThatAreNotFiniteAreLeftOutAndCounted) {
  SvgFrames frames(folder_, "nan");
  frames.polyline({{0, 0}, {std::nan(""), 1}, {1, INFINITY}, {2, 2}}, false, "blue");
  frames.finish();
  const std::string text = well_formed(frames.written()[0]);
  EXPECT_THAT(text, HasSubstr("M0 0L2 2"));
  EXPECT_THAT(text, HasSubstr("(2 points that are not finite left out)"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST_F(Frames, HoldArcsAndNotTheirCentres) {
  SvgFrames frames(folder_, "flat");
  frames.arc(0, 0, 10, 0, 5, 1000, true, "blue");  // sagitta 0.0125, centre far away
  frames.frame("round");
  frames.arc(1, 0, 0, 1, 0, 0, false, "green");  // three quarters of a circle of radius 1
  frames.finish();
  ASSERT_EQ(frames.written().size(), 2u);
  EXPECT_THAT(well_formed(frames.written()[0]), HasSubstr("width=\"1060\" height=\"81\""));
  EXPECT_THAT(well_formed(frames.written()[1]), HasSubstr("width=\"1060\" height=\"1080\""));
}

}  // namespace
}  // namespace clearcut::inline base
