#include "report/picture/animation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <pugixml.hpp>
#include <sstream>

#include "report/sample_job.h"

namespace clearcut::report {
namespace {

/// A second for every move.
std::vector<double> seconds_of(const Toolpath& toolpath, double each = 1) {
  std::vector<double> all;
  for (const Section& section : toolpath.sections) all.resize(all.size() + section.moves.size(), each);
  return all;
}

std::string animation(const Toolpath& toolpath, double each = 1) {
  return animated_svg(sample::part(), toolpath, sample::findings(), seconds_of(toolpath, each));
}

std::vector<double> numbers(const std::string& list) {
  std::vector<double> all;
  std::istringstream in(list);
  for (std::string one; std::getline(in, one, ';');) all.push_back(std::stod(one));
  return all;
}

/// As SVG wants them: as many times as values, from 0, never falling, to 1 where the change is even.
TEST(Animation, HasTimesThatBrowsersTake) {
  pugi::xml_document page;
  ASSERT_TRUE(page.load_string(animation(sample::toolpath()).c_str()));
  int animated = 0;
  for (const auto& found : page.select_nodes("//animate|//animateMotion")) {
    const auto times = numbers(found.node().attribute("keyTimes").value());
    const std::string values =
        found.node().attribute(found.node().attribute("values") ? "values" : "keyPoints").value();
    EXPECT_EQ(static_cast<std::ptrdiff_t>(times.size()), std::count(values.begin(), values.end(), ';') + 1);
    ASSERT_FALSE(times.empty());
    EXPECT_EQ(times.front(), 0);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    if (std::string(found.node().attribute("calcMode").value()) == "linear") {
      EXPECT_EQ(times.back(), 1);
    }
    ++animated;
  }
  EXPECT_GT(animated, 10);
}

TEST(Animation, ShowsEachLayerWhenItIsCutAndDeepOnesOnTop) {
  pugi::xml_document page;
  ASSERT_TRUE(page.load_string(animation(sample::toolpath()).c_str()));
  std::vector<double> begins;
  for (const auto& found : page.select_nodes("//path[@pathLength]"))
    begins.push_back(numbers(found.node().child("animate").attribute("keyTimes").value())[1]);
  // Both layers of the pocket, at -2 and -4, and the slot at -8 with its two ramps: 40 moves in all.
  ASSERT_EQ(begins.size(), 3u);
  EXPECT_TRUE(std::is_sorted(begins.begin(), begins.end()));
  EXPECT_NEAR(begins[2], 33.0 / 40, 0.05);
}

/// Texts this long are not printed.
bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(Animation, PlaysTwoMinutesAtMostAndSaysHowMuchFaster) {
  const std::string own = animation(sample::toolpath()), fast = animation(sample::toolpath(), 10);
  EXPECT_TRUE(says(own, "dur=\"40s\""));
  EXPECT_FALSE(says(own, "times as fast"));
  EXPECT_TRUE(says(fast, "dur=\"120s\""));
  EXPECT_TRUE(says(fast, "3.3 times as fast"));
  EXPECT_TRUE(says(fast, "faulty, 6:40 of machining"));
}

TEST(Animation, TakesNothingAndWhatIsNoNumber) {
  EXPECT_TRUE(says(animation({}), "</svg>"));
  Toolpath broken = sample::toolpath();
  broken.sections[0].moves[3].path.to.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(says(animation(broken), "nan"));
}

}  // namespace
}  // namespace clearcut::report
