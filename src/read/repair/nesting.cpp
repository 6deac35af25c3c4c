#include "read/repair/nesting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "read/repair/edge_index.h"

namespace clearcut::read {
Vec2 inner_point(const Loop& loop) {
  const auto longest = std::max_element(loop.begin(), loop.end(),
                                        [](const Edge& a, const Edge& b) { return a.length() < b.length(); });
  const double side = signed_area(loop) > 0 ? 1 : -1;
  const Vec2 middle = longest->at(0.5);
  const Vec2 inward = left_of(longest->tangent_at(0.5)) * (side * longest->length());
  for (double step = 0.25; step > 1e-9; step /= 8) {
    const Vec2 p = middle + inward * step;
    if (contains(loop, p)) return p;
  }
  return middle;
}

std::vector<std::vector<int>> loops_about(const std::vector<Loop>& loops) {
  std::vector<double> areas;
  for (const Loop& loop : loops) areas.push_back(std::abs(signed_area(loop)));
  const auto area_of = [&](int i) { return areas[static_cast<std::size_t>(i)]; };
  const EdgeIndex index(loops);
  std::vector<std::vector<int>> about(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    // A loop within this one may also contain the point; it is smaller.
    for (const int other : index.loops_around(inner_point(loops[i]))) {
      if (area_of(other) > areas[i]) about[i].push_back(other);
    }
    std::stable_sort(about[i].begin(), about[i].end(), [&](int a, int b) { return area_of(a) > area_of(b); });
  }
  return about;
}

Regions nested(const std::vector<Loop>& loops) {
  const auto about = loops_about(loops);
  std::vector<std::vector<Loop>> islands(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (about[i].size() % 2 == 1) islands[static_cast<std::size_t>(about[i].back())].push_back(loops[i]);
  }
  Regions regions;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (about[i].size() % 2 == 0)
      regions.push_back(Region::from_valid_loops(loops[i], std::move(islands[i])));
  }
  return regions;
}

}  // namespace clearcut::read
