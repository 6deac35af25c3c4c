// Which moves of a program enter material, and how much of what they take is the entry's own.
#pragma once

#include <span>
#include <vector>

#include "verify/part/finished_part.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// What is stated of the entries of a tool.
struct StatedEntry {
  double slope =
      HUGE_VAL;  ///< mm down for each mm of advance, the least that an operation states; infinite: none does
  double size = 0;  ///< mm; radius of a helix, or length of one way of a zigzag
};
StatedEntry stated_entry(const Part& part, const Tool* tool);

/// The moves with which a descent begins that starts with the first of these: feed moves that follow each other and go down, but not
/// straight down.
std::span<const CheckedMove> descent_of(std::span<const CheckedMove> moves);

/// Follows the moves of a program one after the other.
///
/// An entry is one connected descent: feed moves that follow each other and go down at half a degree or more, or as little as
/// the operation states; on its first turn 0.17 degrees are enough. Then the level moves over it, which clear the floor that its
/// last turn leaves. Its own is only what stood below the height at which it began, and of level moves what is no higher than one
/// turn goes down. What stood above the level to which an entry into material went before, where its cutter passed over a part of
/// this one's area, is none of its own, unless a wall or a neck as wide as the cutter lies between them, or passes have cut
/// on a greater length since: a second way down there is a pass that is cut in short pieces. All else is a pass like any
/// other.
class EntryWatch {
 public:
  /// Keeps a pointer to the part as it has to come out; null where nobody states it.
  explicit EntryWatch(const FinishedPart* finished) : finished_(finished) {}
  /// Takes up the first of these moves, the next of the program.
  void follow(std::span<const CheckedMove> moves, const StatedEntry& stated);
  /// Whether the move is of an entry, and whether it is the first one.
  bool is_inside() const { return state_ != State::kOutside; }
  bool begins() const { return begins_; }
  /// mm; with the tip at z, the height from which on what stands is no part of the entry.
  double others_from(double z) const;
  /// The tip is at z on this path and the cutter touches nothing: the descent has not begun yet.
  void meets_nothing_at(const Edge& path, double z);
  /// Whether it has to be told when a move meets material: of an entry that has not yet, and of passes after one.
  bool asks_for_material() const { return is_inside() ? !has_met_ : !past_.empty(); }
  /// The move that was followed last, a feed move, is in material.
  void meets_material(const Move& move);

 private:
  enum class State : unsigned char { kOutside, kDescent, kRound };

  /// An entry into material that has ended.
  struct Past {
    std::vector<Edge> path;
    Box box;  ///< of the path
    double radius = 0, level = 0;
    double passes = 0;  ///< mm that passes have to cut before another one beside it
  };

  void end();
  void begin(std::span<const CheckedMove> moves, const StatedEntry& stated);
  void go_down(std::span<const CheckedMove> moves, const StatedEntry& stated);
  bool is_beside(const Past& past, std::span<const CheckedMove> descent) const;
  bool is_cut_off(const Edge& a, const Edge& b, double z, double radius) const;
  bool is_neck(Vec2 p, double z, double radius) const;
  bool is_over_descent(const Move& move) const;

  const FinishedPart* finished_;
  State state_ = State::kOutside;
  bool begins_ = false, has_met_ = false;
  std::vector<const Move*> descent_;
  double base_ = 0;       ///< mm; height at which the descent began
  double slope_ = 0;      ///< of its steepest move
  double length_ = 0;     ///< mm in plan so far
  double slope_now_ = 0;  ///< of its last move
  double radius_ = 0;     ///< mm; of the cutter
  std::vector<Past> past_;
  double turn_ = 0;  ///< mm; length of one turn of the widest helix of such a cutter
};

}  // namespace clearcut::verify
