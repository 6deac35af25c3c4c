// Finds the edges of a set of loops near a place.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "geometry/region.h"

namespace clearcut::read {

/// An edge by its loop and its index in the loop.
struct EdgeId {
  int loop = 0;
  int edge = 0;
  friend auto operator<=>(const EdgeId&, const EdgeId&) = default;
};

/// Immutable; keeps a reference to `loops`, which must outlive the index. Built in O(n log n).
class EdgeIndex {
 public:
  /// Edges longer than `longest_box` mm are filed under several boxes: narrow ones along inclined lines.
  explicit EdgeIndex(const std::vector<Loop>& loops,
                     double longest_box = std::numeric_limits<double>::infinity());
  ~EdgeIndex();
  EdgeIndex(EdgeIndex&&) noexcept;

  const Edge& edge(EdgeId id) const {
    return (*loops_)[static_cast<std::size_t>(id.loop)][static_cast<std::size_t>(id.edge)];
  }
  /// The boxes for which an edge is filed.
  std::vector<Box> boxes(EdgeId id) const;
  /// The edges with a box overlapping `box`, in no particular order, once for every such box; `visit`
  /// returns false to stop.
  void visit(const Box& box, const std::function<bool(EdgeId)>& visit) const;
  /// The loops containing p (non-zero winding), ascending.
  std::vector<int> loops_around(Vec2 p) const;

 private:
  struct Tree;
  const std::vector<Loop>* loops_;
  double longest_box_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace clearcut::read
