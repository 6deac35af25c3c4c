// A closed tour as an array, changed by reversible k-exchanges.
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace clearcut::order {

inline constexpr int kMostExchanged = 8;

/// k edges leave the tour and k enter: t[0]-t[1], t[2]-t[3], ... are the edges removed, t[1]-t[2], t[3]-t[4],
/// ..., t[2k-1]-t[0] those added.
struct Exchange {
  std::array<int, 2 * kMostExchanged> t{};
  int count = 0;  ///< k
};

class ArrayTour {
 public:
  explicit ArrayTour(std::vector<int> nodes);

  int size() const { return static_cast<int>(order_.size()); }
  int at(int position) const { return order_[position]; }
  int position(int node) const { return position_[node]; }
  int next(int node) const {
    const int p = position_[node] + 1;
    return order_[p == size() ? 0 : p];
  }
  int previous(int node) const {
    const int p = position_[node];
    return order_[p == 0 ? size() - 1 : p - 1];
  }
  const std::vector<int>& nodes() const { return order_; }

  /// Whether the exchange gives one closed tour and rewrites at most `most` places. O(k log k).
  bool is_tour(const Exchange& exchange, int most = std::numeric_limits<int>::max()) const;
  /// Makes the exchange (is_tour must hold) by rewriting all but the longest of the k pieces.
  void apply(const Exchange& exchange);

  /// Rewrites the positions from `first` on (round the end of the array) with a permutation of the nodes there.
  void rewrite(int first, std::span<const int> nodes);

  /// Takes back the newest change since the last commit.
  void undo_last();
  /// Takes back everything since the last commit.
  void undo();
  void commit();
  /// While set, changes are not recorded: long descents on large tours need no undo.
  void forget_changes(bool forget) { forget_ = forget; }

 private:
  struct Piece {
    int first = 0;  ///< position
    int length = 0;
    bool reversed = false;
  };
  struct Rewrite {
    int first = 0;
    int length = 0;
  };
  /// Fills the pieces in the order of the new tour; the number of pieces reached from the first.
  int walk(const Exchange& exchange, std::array<Piece, kMostExchanged>& pieces) const;
  void write(int first, std::span<const int> nodes);

  std::vector<int> order_;
  std::vector<int> position_;
  std::vector<Rewrite> rewrites_;
  std::vector<int> old_nodes_;  // replaced nodes of all rewrites, one after the other
  std::vector<int> buffer_;
  bool forget_ = false;
};

}  // namespace clearcut::order
