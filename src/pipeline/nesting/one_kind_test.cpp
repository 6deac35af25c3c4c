#include "pipeline/nesting/one_kind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace clearcut::pipeline {
namespace {

/// Rectangles lie on the sheet, a gap apart, and no fewer than a plain grid has.
TEST(Nest, PlacesAreOnTheSheetAndApart) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    NestQuestion q;
    q.width = random.between(20, 600);
    q.height = random.between(20, 400);
    q.edge = random.between(0, 8);
    q.gap = random.between(0, 10);
    q.part_width = random.between(8, 120);
    q.part_height = random.between(8, 120);
    const auto places = nest(q);
    const auto size = [&](const NestPlace& p) {
      return p.turned ? Vec2{q.part_height, q.part_width} : Vec2{q.part_width, q.part_height};
    };
    EXPECT_LE(static_cast<int>(places.size()), most_by_area(q));
    const auto along = [&](double length, double side) {
      return std::max(0.0, std::floor((length - 2 * q.edge + q.gap) / (side + q.gap)));
    };
    EXPECT_GE(static_cast<double>(places.size()),
              along(q.width, q.part_width) * along(q.height, q.part_height));
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Vec2 low = places[i].at, high = low + size(places[i]);
      EXPECT_TRUE(low.x >= q.edge - 1e-6 && low.y >= q.edge - 1e-6 && high.x <= q.width - q.edge + 1e-6 &&
                  high.y <= q.height - q.edge + 1e-6);
      for (std::size_t k = 0; k < i; ++k) {
        const Vec2 other = places[k].at, end = other + size(places[k]);
        EXPECT_TRUE(low.x >= end.x + q.gap - 1e-6 || other.x >= high.x + q.gap - 1e-6 ||
                    low.y >= end.y + q.gap - 1e-6 || other.y >= high.y + q.gap - 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace clearcut::pipeline
