// Which edges of a set of loops lie near a place.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "geometry/region.h"

namespace clearcut {

/// An edge by its loop and its place in it.
struct EdgeId {
  int loop = 0;
  int edge = 0;
  friend auto operator<=>(const EdgeId&, const EdgeId&) = default;
};

/// Immutable; keeps a reference to `loops`, which must outlive it. Built in O(n log n).
class EdgeIndex {
 public:
  explicit EdgeIndex(const std::vector<Loop>& loops);
  ~EdgeIndex();
  EdgeIndex(EdgeIndex&&) noexcept;

  const Edge& edge(EdgeId id) const {
    return (*loops_)[static_cast<std::size_t>(id.loop)][static_cast<std::size_t>(id.edge)];
  }
  /// The edges whose boxes overlap `box`, in no particular order; `visit` returns false to stop.
  void visit(const Box& box, const std::function<bool(EdgeId)>& visit) const;
  /// The loops that contain p (non-zero winding), ascending.
  std::vector<int> loops_around(Vec2 p) const;

 private:
  struct Tree;
  const std::vector<Loop>* loops_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace clearcut
