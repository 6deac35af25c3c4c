// The path of a cutter's centre during changes: corners in a ring, the moves between them in a grid, counts of
// cleared points, and a record of every change until it is kept or undone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/cover/witnesses.h"

namespace clearcut::plan::cover {

/// Index of a corner of the path.
using Corner = int;

/// Straight moves from corner to corner, closed or open. An open path is a ring, too: its ends are joined by
/// kNowhere, whose two moves clear nothing and cost nothing.
class CoverPath {
 public:
  /// In open paths: the corner between the last one and the first.
  static constexpr Corner kNowhere = 0;

  CoverPath(const std::vector<Vec2>& points, bool closed, Witnesses& witnesses);

  Vec2 at(Corner c) const { return nodes_[index(c)].at; }
  Corner next(Corner c) const { return nodes_[index(c)].next; }
  Corner previous(Corner c) const { return nodes_[index(c)].previous; }
  bool is_alive(Corner c) const { return nodes_[index(c)].alive; }
  bool is_nowhere(Corner c) const { return !closed_ && c == kNowhere; }
  bool closed() const { return closed_; }
  int corners() const { return corners_; }
  /// Indices are below this; not every one is of a corner.
  int index_limit() const { return static_cast<int>(nodes_.size()); }
  double length() const { return length_; }
  double move_length(Corner a, Corner b) const {
    return is_nowhere(a) || is_nowhere(b) ? 0 : distance(at(a), at(b));
  }
  std::vector<Vec2> points() const;

  /// Each of these functions appends newly uncleared points to `bare`.
  void erase(Corner c, std::vector<Vec2>& bare);
  Corner insert_after(Corner c, Vec2 p, std::vector<Vec2>& bare);
  /// Reverses the corners from b to c, with c after b along the path.
  void reverse(Corner b, Corner c, std::vector<Vec2>& bare);

  /// Removes the moves at the corners from `first` to `last` from the counts; then place() sets corners, and lay()
  /// inserts them.
  void lift(Corner first, Corner last, std::vector<Vec2>& bare);
  void place(Corner c, Vec2 p);
  void lay(Corner first, Corner last);

  /// The current state, to which changes can be undone.
  std::size_t mark() const { return changes_.size(); }
  void undo(std::size_t mark);
  /// Keeps all changes.
  void forget();
  /// The corners changed since the mark; some may no longer exist.
  std::vector<Corner> changed_since(std::size_t mark) const;

  /// Calls f(a, b) for moves a -> b within about `reach` of p; for some of them more than once.
  template <typename F>
  void for_moves_near(Vec2 p, double reach, const F& f) const {
    const auto clamp = [](double value, std::ptrdiff_t size) {
      return static_cast<std::ptrdiff_t>(std::min(std::max(value, 0.0), static_cast<double>(size - 1)));
    };
    const auto left = clamp((p.x - reach - corner_.x) / cell_, columns_),
               right = clamp((p.x + reach - corner_.x) / cell_, columns_),
               bottom = clamp((p.y - reach - corner_.y) / cell_, rows_),
               top = clamp((p.y + reach - corner_.y) / cell_, rows_);
    for (std::ptrdiff_t row = bottom; row <= top; ++row) {
      for (std::ptrdiff_t column = left; column <= right; ++column) {
        for (const auto& [a, b] : cells_[static_cast<std::size_t>(row * columns_ + column)]) {
          if (next(a) == b)
            f(a, b);
          else
            f(b, a);
        }
      }
    }
  }
  /// Number of moves within `reach` of p.
  int moves_within(Vec2 p, double reach) const;
  double extent() const { return cell_ * static_cast<double>(std::max(columns_, rows_)); }

 private:
  struct Node {
    Vec2 at;
    Corner previous = -1, next = -1;
    bool alive = false;
  };
  struct Change {
    enum class Kind : std::uint8_t { kErased, kInserted, kPlaced, kReversed } kind;
    Corner corner, other;
    Vec2 was;
  };
  struct Move {
    Corner a, b;
  };
  static std::size_t index(Corner c) { return static_cast<std::size_t>(c); }
  Corner new_node(Vec2 p);
  void put(Corner a, Corner b);
  void take(Corner a, Corner b, std::vector<Vec2>* bare);
  template <typename F>
  void for_cells(Corner a, Corner b, const F& f);
  void erase_now(Corner c, std::vector<Vec2>* bare);
  void insert_now(Corner c, Corner after, std::vector<Vec2>* bare);
  void reverse_now(Corner b, Corner c, std::vector<Vec2>* bare);

  Witnesses& witnesses_;
  bool closed_;
  std::vector<Node> nodes_;
  std::vector<Corner> free_;
  std::vector<Corner> waiting_;  ///< erased, and free once the changes are kept
  int corners_ = 0;
  double length_ = 0;
  std::vector<Change> changes_;
  Vec2 corner_;
  double cell_;
  std::ptrdiff_t columns_ = 1, rows_ = 1;
  std::vector<std::vector<Move>> cells_;
};

}  // namespace clearcut::plan::cover
