#include "pipeline/nesting/one_kind.h"

#include <algorithm>
#include <cmath>

namespace clearcut::pipeline {
namespace {

/// Share of a rectangle by which sums of lengths may miss a whole number of them.
constexpr double kWhole = 1e-9;

/// How many rectangles of `side` fit into `length` with a gap between them. mm.
int fitting(double length, double side, double gap) {
  if (length < side * (1 - kWhole)) return 0;
  return static_cast<int>(std::floor((length + gap) / (side + gap) + kWhole));
}

/// A grid of rectangles, from its lower left corner, mm.
struct NestBlock {
  Vec2 at;
  int across = 0, up = 0;
  bool turned = false;
  int count() const { return across * up; }
};

NestBlock block_in(const NestQuestion& q, Vec2 at, double width, double height, bool turned) {
  const double w = turned ? q.part_height : q.part_width, h = turned ? q.part_width : q.part_height;
  return {at, fitting(width, w, q.gap), fitting(height, h, q.gap), turned};
}

void append(const NestBlock& block, const NestQuestion& q, std::vector<NestPlace>& places) {
  const double w = block.turned ? q.part_height : q.part_width,
               h = block.turned ? q.part_width : q.part_height;
  for (int row = 0; row < block.up; ++row)
    for (int k = 0; k < block.across; ++k) {
      const int column = row % 2 == 0 ? k : block.across - 1 - k;
      places.push_back({block.at + Vec2{column * (w + q.gap), row * (h + q.gap)}, block.turned});
    }
}

}  // namespace

std::vector<NestPlace> nest(const NestQuestion& q) {
  const Vec2 corner{q.edge, q.edge};
  const double width = q.width - 2 * q.edge, height = q.height - 2 * q.edge;
  NestBlock first, second;
  const auto consider = [&](const NestBlock& a, const NestBlock& b) {
    if (a.count() + b.count() > first.count() + second.count()) {
      first = a;
      second = b;
    }
  };
  for (const bool turned : {false, true}) {
    const NestBlock whole = block_in(q, corner, width, height, turned);
    consider(whole, {});
    const double w = turned ? q.part_height : q.part_width, h = turned ? q.part_width : q.part_height;
    for (int columns = 1; columns < whole.across; ++columns) {
      NestBlock left = whole;
      left.across = columns;
      const double used = columns * (w + q.gap);
      consider(left, block_in(q, corner + Vec2{used, 0}, width - used, height, !turned));
    }
    for (int rows = 1; rows < whole.up; ++rows) {
      NestBlock low = whole;
      low.up = rows;
      const double used = rows * (h + q.gap);
      consider(low, block_in(q, corner + Vec2{0, used}, width, height - used, !turned));
    }
    // All of one orientation, and what is left over beside or above them.
    const double across = whole.across * (w + q.gap), up = whole.up * (h + q.gap);
    consider(whole, block_in(q, corner + Vec2{across, 0}, width - across, height, !turned));
    consider(whole, block_in(q, corner + Vec2{0, up}, width, height - up, !turned));
  }
  std::vector<NestPlace> places;
  append(first, q, places);
  append(second, q, places);
  return places;
}

int most_by_area(const NestQuestion& q) {
  const double width = q.width - 2 * q.edge, height = q.height - 2 * q.edge;
  if (fitting(std::max(width, height), std::max(q.part_width, q.part_height), q.gap) == 0 ||
      fitting(std::min(width, height), std::min(q.part_width, q.part_height), q.gap) == 0)
    return 0;
  // Each takes its own area and that of the gaps to its right and above.
  return static_cast<int>(std::floor(
      (width + q.gap) * (height + q.gap) / ((q.part_width + q.gap) * (q.part_height + q.gap)) + kWhole));
}

}  // namespace clearcut::pipeline
