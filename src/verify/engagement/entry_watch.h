// Which moves of a program enter material, and how much of what they take is the entry's own.
#pragma once

#include <vector>

#include "verify/checked_move.h"

namespace clearcut::verify {

/// What is stated of the entries of a tool.
struct StatedEntry {
  double slope =
      HUGE_VAL;  ///< mm down for each mm of advance, the least that an operation states; infinite: none does
  double size = 0;  ///< mm; radius of a helix, or length of one way of a zigzag
};
StatedEntry stated_entry(const Part& part, const Tool* tool);

/// Follows the moves of a program one after the other.
///
/// An entry is one connected descent: feed moves that follow each other and go down at half a degree or more, or as little as
/// the operation states; on its first turn 0.17 degrees are enough. Then the level moves over it, which clear the floor that its
/// last turn leaves. Its own is only what stood below the height at which it began, and of level moves what is no higher than one
/// turn goes down. All else is a pass like any other.
class EntryWatch {
 public:
  /// Takes up the next move of a cutter of that radius, mm.
  void follow(const CheckedMove& checked, const StatedEntry& stated);
  /// Whether the move is of an entry, and whether it is the first one.
  bool is_inside() const { return state_ != State::kOutside; }
  bool begins() const { return begins_; }
  /// mm; with the tip at z, the height from which on what stands is no part of the entry.
  double others_from(double z) const;
  /// The tip is at z and the cutter touches nothing: the descent has not begun yet.
  void meets_nothing_at(double z);

 private:
  enum class State : unsigned char { kOutside, kDescent, kRound };

  void end();
  void go_down(const CheckedMove& checked, const StatedEntry& stated);
  bool is_over_descent(const Move& move) const;

  State state_ = State::kOutside;
  bool begins_ = false;
  std::vector<const Move*> descent_;
  double base_ = 0;    ///< mm; height at which the descent began
  double slope_ = 0;   ///< of its steepest move
  double length_ = 0;  ///< mm in plan so far
  double turn_ = 0;    ///< mm; length of one turn of the widest helix of such a cutter
};

}  // namespace clearcut::verify
