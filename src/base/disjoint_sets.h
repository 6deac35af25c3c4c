// Numbers joined into sets.
#pragma once

#include <numeric>
#include <vector>

namespace clearcut::inline base {

/// Numbers 0..n-1, each in its own set until sets are joined.
class DisjointSets {
 public:
  explicit DisjointSets(int n) : parent_(static_cast<std::size_t>(n)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// The representative number of the set of `i`.
  int find(int i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  /// Joins both sets; the representative of `b` becomes the representative of both.
  void join(int a, int b) { parent(find(a)) = find(b); }

 private:
  int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }

  std::vector<int> parent_;
};

}  // namespace clearcut::inline base
