// Lines that are laid: what they cover more than once against a raster of visits, gaps, and lines over the edge.
#include "verify/coverage/laid_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.h"
#include "base/units.h"
#include "verify/test_program.h"

namespace clearcut::verify {
namespace {

using testing::rectangle;

Path line_through(const std::vector<Vec2>& points) {
  Path path;
  for (std::size_t i = 1; i < points.size(); ++i) path.push_back(Edge::line(points[i - 1], points[i]));
  return path;
}

/// Number of times that a disc of this radius comes to p along the line: the stretches of its middle within the radius of p.
int visits_of(const Path& line, double radius, Vec2 p) {
  int visits = 0;
  double left_at = -1, before = 0;  // mm along the line
  for (const Edge& edge : line) {
    const double mm = edge.length();
    const Vec2 along = unit(edge.to - edge.from);
    const double middle = dot(p - edge.from, along);
    const Vec2 foot = edge.from + along * middle;
    const double aside = distance(foot, p);
    if (aside < radius) {
      const double half = std::sqrt(radius * radius - aside * aside);
      const double begin = std::max(0.0, middle - half), end = std::min(mm, middle + half);
      if (begin < end) {
        if (left_at < before + begin - 1e-9) ++visits;
        left_at = before + end;
      }
    }
    before += mm;
  }
  return visits;
}

/// mm2 over which lines are laid again, every further time counted, and mm2 covered at all.
struct RasterOver {
  double over = 0, covered = 0;
};
RasterOver raster_over(const LaidQuestion& question, double step) {
  const Box all = box(question.region).grown(question.width);
  RasterOver found;
  for (double x = all.min.x + step / 2; x < all.max.x; x += step) {
    for (double y = all.min.y + step / 2; y < all.max.y; y += step) {
      int visits = 0;
      for (const Path& line : question.lines) visits += visits_of(line, question.width / 2, {x, y});
      found.over += step * step * std::max(0, visits - 1);
      found.covered += visits > 0 ? step * step : 0;
    }
  }
  return found;
}

/// Strips of a rectangle from left to right, as one line with its turns or each for itself.
LaidQuestion strips(double width, double apart, double length, int count, bool in_one) {
  LaidQuestion question;
  question.width = width;
  question.region = rectangle(0, 0, length, width + (count - 1) * apart);
  std::vector<Vec2> all;
  for (int i = 0; i < count; ++i) {
    const double y = width / 2 + i * apart;
    std::vector<Vec2> strip{{width / 2, y}, {length - width / 2, y}};
    if (i % 2 == 1) std::swap(strip[0], strip[1]);
    if (!in_one) question.lines.push_back(line_through(strip));
    all.insert(all.end(), strip.begin(), strip.end());
  }
  if (in_one) question.lines = {line_through(all)};
  return question;
}

TEST(LaidCover, WhatIsLaidTwiceIsWhatARasterOfVisitsCounts) {
  for (const bool in_one : {true, false}) {
    for (const double apart : {2.0, 1.8, 1.0}) {
      const LaidQuestion question = strips(2, apart, 20, 6, in_one);
      const RasterOver raster = raster_over(question, 0.04);
      const LaidCover found = laid_cover_of(question, {});
      // The round ends of strips leave the sides of the rectangle in between bare: those places are reached by no strip.
      const double bare = found.cover.target_mm2 - found.covered_mm2;
      EXPECT_NEAR(found.over_mm2 - raster.over, raster.covered - found.covered_mm2, 0.5)
          << apart << " " << in_one;
      EXPECT_LT(bare, 6) << apart << " " << in_one;
    }
  }
}

/// The first disc of each line, and 2 r for each mm, are all visits: for lines of any shape.
TEST(LaidCover, VisitsOfRandomLinesAddUpToTheirLength) {
  Random random(7);
  for (int round = 0; round < 5; ++round) {
    LaidQuestion question;
    question.width = random.between(0.5, 3);
    question.region = rectangle(-14, -14, 14, 14);
    for (int k = 0; k < 2; ++k) {
      std::vector<Vec2> points;
      for (int i = 0; i < 7; ++i) points.push_back({random.between(-10, 10), random.between(-10, 10)});
      if (k == 1) points.push_back(points.front());
      question.lines.push_back(line_through(points));
    }
    const RasterOver raster = raster_over(question, 0.05);
    const LaidCover found = laid_cover_of(question, {});
    const double visits = found.over_mm2 + found.covered_mm2;
    EXPECT_NEAR(visits, raster.over + raster.covered, 0.01 * visits) << round;
  }
}

TEST(LaidCover, AGapIsFoundAndItsWidth) {
  LaidQuestion question = strips(2, 2, 20, 5, true);
  const LaidCover whole = laid_cover_of(strips(2, 1.9, 20, 5, true), {});
  question = strips(2, 2.05, 20, 5, true);
  const LaidCover gaps = laid_cover_of(question, {});
  EXPECT_GT(gaps.cover.uncut_mm2, whole.cover.uncut_mm2 + 4 * 0.05 * 15);
  EXPECT_GE(gaps.cover.thickness_mm, 0.05);
}

TEST(LaidCover, LinesOverTheEdgeAreFoundExactly) {
  LaidQuestion question = strips(2, 1.8, 20, 4, true);
  EXPECT_LT(laid_cover_of(question, {}).outside_mm, 1e-9);
  question.lines[0].push_back(Edge::line(question.lines[0].back().to, {0.25, question.lines[0].back().to.y}));
  EXPECT_NEAR(laid_cover_of(question, {}).outside_mm, 0.75, 1e-9);
  question.lines = {line_through({{-5, 1}, {-4, 1}})};
  EXPECT_NEAR(laid_cover_of(question, {}).outside_mm, 6, 1e-9);
}

}  // namespace
}  // namespace clearcut::verify
