#include "report/picture/chart.h"

#include <gtest/gtest.h>

#include <limits>

namespace clearcut::report {
namespace {

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Chart, QuantilesInterpolate) {
  EXPECT_DOUBLE_EQ(quantile({3, 1, 2, 4, 5}, 0.5), 3);
  EXPECT_DOUBLE_EQ(quantile({3, 1, 2, 4, 5}, 0.25), 2);
  EXPECT_DOUBLE_EQ(quantile({1, 2}, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(quantile({7}, 0.9), 7);
}

TEST(Chart, TicksAreRoundAndInside) {
  EXPECT_EQ(round_ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_TRUE(round_ticks(1, 1, 5).empty());
  for (const double tick : round_ticks(96.31, 99.2, 6)) {
    EXPECT_GE(tick, 96.31);
    EXPECT_LE(tick, 99.2);
  }
  EXPECT_FALSE(round_ticks(96.31, 99.2, 6).empty());
}

TEST(Chart, DrawsABoxPerGroupACurvePerNameAndBars) {
  ChartPanel boxes{.title = "a < b", .boxes = {{"one", {1, 2, 3}, 0.1}, {"two", {5}, 0}}};
  ChartPanel curves{.curves = {{"c", {1, 10, 100}, {1, 2, 3}, {0, 1, 2}, {2, 3, 4}}}, .log_x = true};
  ChartPanel histogram{.samples = {1, 2, 2, 3, std::numeric_limits<double>::quiet_NaN()}};
  const std::string svg = chart_svg({boxes, curves, histogram});
  EXPECT_EQ(count_of(svg, "<rect"), 1 + 2 + 5);  // page, boxes, bars
  EXPECT_EQ(count_of(svg, "<circle"), 2);
  EXPECT_EQ(count_of(svg, "<polyline"), 1);
  EXPECT_EQ(count_of(svg, "<polygon"), 1);
  EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

/// Names of curves are not cut off at the right.
TEST(Chart, IsAsWideAsItsLongestNameNeeds) {
  const auto page = [](const std::string& name) { return chart_svg({{.curves = {{name, {1, 2}, {1, 2}}}}}); };
  EXPECT_NE(page("length").find("viewBox=\"0 0 800 360\""), std::string::npos);
  EXPECT_NE(page("engagement, 1 / deviation").find("viewBox=\"0 0 837 360\""), std::string::npos);
}

}  // namespace
}  // namespace clearcut::report
