#include "support/cad/cad_part.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"

namespace clearcut::test_support {
namespace {

constexpr double kQuarter = 0.41421356237309503;  // bulge of a quarter of a turn
constexpr double kCell = 32;                      // mm; each holds a pocket, a hole or nothing
constexpr double kMargin = 8;                     // mm; from cells to the plate's edge

/// As a designer types them: to tenths.
double round_length(Random& random, double low, double high) {
  return std::round(random.between(low, high) * 10) / 10;
}

Loop rectangle(Vec2 low, double width, double height, double corner) {
  const Vec2 high = low + Vec2{width, height};
  if (corner <= 0)
    return loop_from_points(std::array<Vec2, 4>{low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}});
  return loop_from_bulges(std::array<BulgeVertex, 8>{{{{low.x + corner, low.y}},
                                                      {{high.x - corner, low.y}, kQuarter},
                                                      {{high.x, low.y + corner}},
                                                      {{high.x, high.y - corner}, kQuarter},
                                                      {{high.x - corner, high.y}},
                                                      {{low.x + corner, high.y}, kQuarter},
                                                      {{low.x, high.y - corner}},
                                                      {{low.x, low.y + corner}, kQuarter}}});
}

Loop slot(Vec2 center, double length, double width, double angle) {
  const Vec2 along = direction_of(angle) * (length / 2), across = left_of(direction_of(angle)) * (width / 2);
  return loop_from_bulges(std::array<BulgeVertex, 4>{{{center - along - across},
                                                      {center + along - across, 1},
                                                      {center + along + across},
                                                      {center - along + across, 1}}});
}

Loop polygon(Vec2 center, double radius, int corners) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) points.push_back(center + direction_of(2 * kPi * i / corners) * radius);
  return loop_from_points(points);
}

CadShape circle(Vec2 center, double diameter) {
  const Vec2 side{diameter / 2, 0};
  CadShape shape{CadShapeKind::kHole, {}, diameter, center};
  shape.outline = loop_from_bulges(std::array<BulgeVertex, 2>{{{center + side, 1}, {center - side, 1}}});
  return shape;
}

CadShape pocket(Vec2 center, Random& random) {
  CadShape shape{CadShapeKind::kPocket, {}, {}, {}};
  switch (random.below(3)) {
    case 0: {
      const double width = round_length(random, 12, 26), height = round_length(random, 12, 26);
      const double corner = random.below(2) == 0 ? 0 : 3;
      shape.outline = rectangle(center - Vec2{width, height} / 2.0, width, height, corner);
      break;
    }
    case 1:
      shape.outline =
          slot(center, round_length(random, 8, 16), round_length(random, 5, 9), random.between(0, kPi));
      break;
    default:
      shape.outline = polygon(center, round_length(random, 7, 13), 5 + static_cast<int>(random.below(4)));
  }
  return shape;
}

Loop plate(Vec2 low, double width, double height, Random& random) {
  if (random.below(3) > 0) return rectangle(low, width, height, static_cast<double>(random.below(3)) * 2.5);
  // A corner cut off in an arc that bows inwards.
  const Vec2 high = low + Vec2{width, height};
  return loop_from_bulges(std::array<BulgeVertex, 5>{{{low},
                                                      {{high.x, low.y}},
                                                      {{high.x, high.y - 6}, -kQuarter},
                                                      {{high.x - 6, high.y}},
                                                      {{low.x, high.y}}}});
}

}  // namespace

Box CadPart::box() const {
  return clearcut::box(shapes.front().outline);
}

CadPart random_cad_part(Random& random) {
  const auto columns = 2 + static_cast<int>(random.below(6)), rows = 2 + static_cast<int>(random.below(3));
  const Vec2 low{round_length(random, -30, 60), round_length(random, -30, 60)};
  CadPart part;
  part.shapes.push_back({CadShapeKind::kPlate,
                         plate(low, columns * kCell + 2 * kMargin, rows * kCell + 2 * kMargin, random),
                         {},
                         {}});
  for (int i = 0; i < columns * rows; ++i) {
    const Vec2 center =
        low + Vec2{kMargin + (i % columns + 0.5) * kCell, kMargin + (i / columns + 0.5) * kCell};
    const auto choice = i < 2 ? static_cast<std::uint64_t>(i) : random.below(4);
    if (choice == 0) part.shapes.push_back(pocket(center, random));
    if (choice == 1) part.shapes.push_back(circle(center, round_length(random, 3, 14)));
  }
  return part;
}

}  // namespace clearcut::test_support
