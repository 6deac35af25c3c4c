#include "support/random/lattice_parts.h"

#include <cmath>
#include <map>
#include <utility>

#include "support/random/random_parts.h"

namespace clearcut::test_support {
namespace {

constexpr int kSide = 8;  // squares along each side of the lattice

using Corner = std::pair<int, int>;

/// Some squares of a lattice, joined along their sides; no two touch at a corner alone.
class Squares {
 public:
  explicit Squares(Random& random) {
    put(kSide / 2, kSide / 2, true);
    const auto wanted = 3 + random.below(38);
    for (std::uint64_t tries = 0; count_ < wanted && tries < 4000; ++tries) {
      const int x = static_cast<int>(random.below(kSide)), y = static_cast<int>(random.below(kSide));
      if (holds(x, y) || !joins(x, y)) continue;
      put(x, y, true);
      if (touches_at_corner(x, y)) put(x, y, false);
    }
  }

  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < kSide && y < kSide && held_[x][y]; }

  /// The boundary's steps from corner to corner, squares on their left. Each corner has one step at most.
  std::map<Corner, Corner> steps() const {
    std::map<Corner, Corner> steps;
    for (int x = 0; x < kSide; ++x) {
      for (int y = 0; y < kSide; ++y) {
        if (!holds(x, y)) continue;
        if (!holds(x, y - 1)) steps[{x, y}] = {x + 1, y};
        if (!holds(x + 1, y)) steps[{x + 1, y}] = {x + 1, y + 1};
        if (!holds(x, y + 1)) steps[{x + 1, y + 1}] = {x, y + 1};
        if (!holds(x - 1, y)) steps[{x, y + 1}] = {x, y};
      }
    }
    return steps;
  }

 private:
  void put(int x, int y, bool held) {
    held_[x][y] = held;
    held ? ++count_ : --count_;
  }
  bool joins(int x, int y) const {
    return holds(x - 1, y) || holds(x + 1, y) || holds(x, y - 1) || holds(x, y + 1);
  }
  /// Whether squares, or free squares, about a corner of this one touch there alone.
  bool touches_at_corner(int x, int y) const {
    for (const int dx : {-1, 1}) {
      for (const int dy : {-1, 1}) {
        const bool beside = holds(x + dx, y), above = holds(x, y + dy);
        if (!beside && !above && holds(x + dx, y + dy)) return true;
      }
    }
    return false;
  }

  bool held_[kSide][kSide] = {};
  std::uint64_t count_ = 0;
};

/// `lines`: where the lattice's lines lie, mm.
Regions outline_of(const Squares& squares, const std::vector<double>& lines_x,
                   const std::vector<double>& lines_y) {
  auto steps = squares.steps();
  std::vector<Loop> islands;
  Loop outer;
  while (!steps.empty()) {
    std::vector<Vec2> points;
    std::pair<int, int> last{0, 0};
    for (auto step = steps.begin(); step != steps.end();) {
      const auto [from, to] = *step;
      const std::pair<int, int> heading{to.first - from.first, to.second - from.second};
      if (heading != last) {
        points.push_back(
            {lines_x[static_cast<std::size_t>(from.first)], lines_y[static_cast<std::size_t>(from.second)]});
      }
      last = heading;
      steps.erase(step);
      step = steps.find(to);
    }
    Loop loop = loop_from_points(points);
    (signed_area(loop) > 0 ? outer : islands.emplace_back()) = std::move(loop);
  }
  return {Region::from_valid_loops(std::move(outer), std::move(islands))};
}

}  // namespace

Part exact_fit_pocket(Random& random, double diameter) {
  std::vector<double> lines;
  for (int i = 0; i <= kSide; ++i) lines.push_back(i * diameter);
  const Regions outline = outline_of(Squares(random), lines, lines);
  return part_of(outline, outline, FeatureKind::kClosedPocket, diameter);
}

Part block_with_arms(Random& random, double diameter) {
  std::vector<double> lines[2];
  for (auto& along : lines) {
    along.push_back(0);
    for (int i = 0; i < kSide; ++i)
      along.push_back(along.back() + std::round(random.between(0.3, 2) * diameter * 100) / 100);
  }
  const Regions target = outline_of(Squares(random), lines[0], lines[1]);
  const Box air = box(target).grown(10 * diameter);
  const std::vector<Vec2> corners{air.min, {air.max.x, air.min.y}, air.max, {air.min.x, air.max.y}};
  return part_of(target, {Region::from_valid_loops(loop_from_points(corners), {})}, FeatureKind::kOpenPocket,
                 diameter);
}

Part room_with_tip(Random& random, double diameter) {
  const auto length = [&](double least, double most) {
    return std::round(random.between(least, most) * diameter);
  };
  const double wall = length(0.8, 1.4), flare = length(0.6, 3), side = length(0.4, 3);
  const double slant = length(0.4, 2.5), fall = length(0, 2);
  const double bottom = -wall - flare - side, right = diameter + slant;
  const Vec2 corners[] = {{0, 0},
                          {0, -wall},
                          {-flare, -wall - flare},
                          {-flare, bottom},
                          {right, std::min(bottom - fall, -slant - diameter)},
                          {right, -slant},
                          {diameter, 0},
                          {diameter, 0.8 * diameter},
                          {0, 0.8 * diameter}};
  const Regions outline{Region::from_valid_loops(loop_from_points(corners), {})};
  return part_of(outline, outline, FeatureKind::kClosedPocket, diameter);
}

}  // namespace clearcut::test_support
