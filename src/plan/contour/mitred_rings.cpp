#include "plan/contour/mitred_rings.h"

#include <algorithm>

#include "geometry/contours/mitred_inset.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::plan::contour {
namespace {

/// The place with the greatest clearance in the contour, as a piece of axis: levels are counted from the wall.
AxisPiece to_centre(const RingNode& ring, const Tolerances& tol) {
  AxisPoint deepest{ring.contour.outer().front().from, 0};
  const Clearance clearance(ring.contour, tol);
  for (const AxisPoint& point : clearance.axis().points)
    if (point.clearance > deepest.clearance) deepest = point;
  deepest.clearance += ring.level;
  return {0, 0, deepest, deepest};
}

}  // namespace

std::vector<RingNode> mitred_ring_tree(const Region& domain, double first_level, const StepOf& step_of,
                                       const Tolerances& tol) {
  std::vector<RingNode> nodes;
  const auto add = [&](const Region& around, double distance, int parent, double level) {
    const int depth = parent < 0 ? 0 : nodes[static_cast<std::size_t>(parent)].depth + 1;
    for (const Region& contour : mitred_inset(around, distance, tol)) {
      if (parent >= 0)
        nodes[static_cast<std::size_t>(parent)].children.push_back(static_cast<int>(nodes.size()));
      nodes.push_back({contour, level, level, parent, depth, {}, {}});
    }
  };
  add(domain, first_level, -1, first_level);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double step = step_of(nodes[i], {to_centre(nodes[i], tol)});
    nodes[i].next_level = nodes[i].level + step;
    const Region around = nodes[i].contour;  // a copy: the list grows
    add(around, step, static_cast<int>(i), nodes[i].next_level);
  }
  return nodes;
}

}  // namespace clearcut::plan::contour
