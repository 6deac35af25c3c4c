// The differences of two tours, taken apart into AB-cycles: closed walks of edges from A and B in turn
// [nagata2013].
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/random.h"

namespace clearcut::order {

/// The two neighbours of each node of a closed tour, in no particular order.
using Links = std::vector<std::array<int, 2>>;

Links links_of(std::span<const int> nodes);
std::vector<int> nodes_of(const Links& links);

/// AB-cycles of one pair of tours. Nodes of a cycle v0 v1 v2 ...: v0-v1 is an edge only of A, v1-v2 only of B, ...
class AbCycles {
 public:
  explicit AbCycles(int nodes);

  /// Decomposes the difference at random. O(n + size of the difference).
  void split(const Links& a, const Links& b, Random& random);

  int count() const { return static_cast<int>(begins_.size()) - 1; }
  std::span<const int> cycle(int i) const {
    return std::span(flat_).subspan(static_cast<std::size_t>(begins_[i]),
                                    static_cast<std::size_t>(begins_[i + 1] - begins_[i]));
  }

 private:
  struct Rest {
    std::array<std::array<int, 2>, 2> end{};  // [A or B][index]: edges not yet taken
    std::array<signed char, 2> count{};
  };
  void collect(const Links& a, const Links& b);
  int take_edge(int v, int kind, Random& random);
  void take_out(int v, int w, int kind);
  void extract(int first);

  std::vector<Rest> rest_;
  std::vector<int> active_;                  // nodes with possibly unused edges
  std::vector<std::array<int, 2>> on_path_;  // place of a node on the path by parity, -1
  std::vector<int> path_;
  std::vector<int> flat_;
  std::vector<int> begins_;
};

}  // namespace clearcut::order
