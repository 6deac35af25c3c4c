#include "geometry/spatial/apart.h"

#include <algorithm>
#include <vector>

namespace clearcut::inline geometry {
namespace {

/// Edges of a side whose boxes overlap `common`, by their left ends.
struct EdgesNear {
  struct Boxed {
    Box box;
    const Edge* edge;
  };
  std::vector<Boxed> edges;
  double widest = 0;

  EdgesNear(const Regions& regions, const Box& common) {
    for (const Region& region : regions) {
      if (!region.box().overlaps(common)) continue;
      add(region.outer(), common);
      for (const Loop& island : region.islands()) add(island, common);
    }
    std::sort(edges.begin(), edges.end(),
              [](const Boxed& a, const Boxed& b) { return a.box.min.x < b.box.min.x; });
  }

 private:
  void add(const Loop& loop, const Box& common) {
    for (const Edge& edge : loop) {
      const Box box = edge.box();
      if (!box.overlaps(common)) continue;
      edges.push_back({box, &edge});
      widest = std::max(widest, box.width());
    }
  }
};

bool come_near(const EdgesNear& a, const EdgesNear& b, double gap) {
  auto first = b.edges.begin();
  for (const EdgesNear::Boxed& one : a.edges) {
    const Box reach = one.box.grown(gap);
    // Edges beginning farther left are not wide enough to reach this edge, nor edges beginning later.
    while (first != b.edges.end() && first->box.min.x < reach.min.x - b.widest) ++first;
    for (auto other = first; other != b.edges.end() && other->box.min.x <= reach.max.x; ++other) {
      if (reach.overlaps(other->box) && distance(*one.edge, *other->edge) <= gap) return true;
    }
  }
  return false;
}

/// Whether the start point of one of the regions is in the other area: sufficient if the boundaries do not meet.
bool begins_in(const Regions& regions, const Regions& other, const Box& common) {
  return std::any_of(regions.begin(), regions.end(), [&](const Region& region) {
    const Vec2 p = region.outer().front().from;
    return common.contains(p) && contains(other, p);
  });
}

}  // namespace

bool are_apart(const Regions& a, const Regions& b, double gap) {
  const Box one = box(a).grown(gap), other = box(b).grown(gap);
  if (!one.overlaps(other)) return true;
  const Box common{{std::max(one.min.x, other.min.x), std::max(one.min.y, other.min.y)},
                   {std::min(one.max.x, other.max.x), std::min(one.max.y, other.max.y)}};
  return !come_near(EdgesNear(a, common), EdgesNear(b, common), gap) && !begins_in(a, b, common) &&
         !begins_in(b, a, common);
}

}  // namespace clearcut::inline geometry
