// Finds the edges near a place, by a tree of boxes over edges in the given order.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/region.h"
#include "geometry/spatial/box_tree.h"

namespace clearcut::verify {

/// Edges with a tree of boxes. Edges of outlines and programs follow each other, so that boxes over successive edges
/// are small without sorting. Edges may be points (from == to).
///
/// Cost    build O(n); a search O(log n + found) for such edges.
class EdgeTree {
 public:
  EdgeTree() = default;
  explicit EdgeTree(std::vector<Edge> edges);
  /// The boundaries of all regions.
  explicit EdgeTree(const Regions& regions);

  const std::vector<Edge>& edges() const { return edges_; }
  bool empty() const { return edges_.empty(); }
  const Box& box() const { return tree_.box(); }

  /// Calls visit(index) for every edge whose box overlaps `box`.
  template <typename Visit>
  void overlapping(const Box& box, Visit visit) const {
    descend([&box](const Box& b) { return b.overlaps(box); }, visit);
  }

  /// Calls visit(index) for every edge with a box within `reach` of p.
  template <typename Visit>
  void within(Vec2 p, double reach, Visit visit) const {
    const double squared = reach * reach;
    descend([=](const Box& b) { return squared_distance(b, p) <= squared; }, visit);
  }

  struct Hit {
    int edge = -1;  ///< -1: none within the limit
    double distance = std::numeric_limits<double>::infinity();
  };
  /// The nearest edge, at a distance below `limit`, with accept(index) true.
  template <typename Accept>
  Hit nearest(Vec2 p, double limit, Accept accept) const {
    Hit best{-1, limit};
    descend([&](const Box& b) { return squared_distance(b, p) < best.distance * best.distance; },
            [&](int i) {
              if (!accept(i)) return;
              const double d = clearcut::distance(edges_[i], p);
              if (d < best.distance) best = {i, d};
            });
    if (best.edge < 0) best.distance = std::numeric_limits<double>::infinity();
    return best;
  }
  Hit nearest(Vec2 p, double limit = std::numeric_limits<double>::infinity()) const {
    return nearest(p, limit, [](int) { return true; });
  }

  /// mm from p to the nearest edge; infinite if there are none. Faster than nearest() if no limit is known and the
  /// edges near p are not among the first: boxes near p are opened first.
  double distance_to(Vec2 p) const {
    double best = std::numeric_limits<double>::infinity();
    const auto may_be_nearer = [&](const Box& b) { return squared_distance(b, p) < best * best; };
    tree_.descend_nearest_first(p, may_be_nearer, [&](std::uint32_t i) {
      if (may_be_nearer(boxes_[i])) best = std::min(best, clearcut::distance(edges_[i], p));
    });
    return best;
  }

  /// Winding number around p of all edges, which must form closed loops. Cost O(log n + loops with boxes around p +
  /// edges above and below p within the boxes around it).
  int winding(Vec2 p) const;

 private:
  static double squared_distance(const Box& b, Vec2 p) {
    const double dx = std::max({b.min.x - p.x, 0.0, p.x - b.max.x});
    const double dy = std::max({b.min.y - p.y, 0.0, p.y - b.max.y});
    return dx * dx + dy * dy;
  }

  template <typename Open, typename Visit>
  void descend(Open open, Visit visit) const {
    tree_.descend(open, [&](std::uint32_t i) {
      if (open(boxes_[i])) visit(static_cast<int>(i));
    });
  }

  /// Edges, each beginning at the end of the previous one.
  struct Chain {
    Vec2 from, to;
    std::uint32_t open_before = 0;               ///< number of open chains before it
    std::uint32_t first_edge = 0, end_edge = 0;  ///< its edges, to below end_edge
  };
  void find_chains();
  void sort_loops();
  int winding_of(Vec2 p, std::uint32_t from, std::uint32_t to) const;

  std::vector<Edge> edges_;
  std::vector<Box> boxes_;               ///< box of each edge
  std::vector<std::uint32_t> chain_of_;  ///< chain of each edge
  std::vector<Chain> chains_;
  BoxTree tree_;
  /// The chains in an order with neighbours near each other, if all are closed.
  std::vector<std::uint32_t> loops_;
  BoxTree loop_tree_;  ///< tree of the boxes of loops_
};

}  // namespace clearcut::verify
