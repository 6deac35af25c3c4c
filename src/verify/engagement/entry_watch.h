// Finds the moves of a program that enter material, and the share of their cut that belongs to the entry itself.
#pragma once

#include <span>
#include <vector>

#include "verify/part/finished_part.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// Stated data of a tool's entries.
struct StatedEntry {
  /// mm down for each mm of advance; least value stated by an operation; infinite: none is stated.
  double slope = HUGE_VAL;
  double size = 0;  ///< mm; radius of a helix, or length of one leg of a zigzag
};
StatedEntry stated_entry(const Part& part, const Tool* tool);

/// The moves of the descent that starts with the first of these moves: successive feed moves that go down, but not
/// vertically.
std::span<const CheckedMove> descent_of(std::span<const CheckedMove> moves);

/// Follows the moves of a program one after the other.
///
/// An entry is one connected descent: successive feed moves descending at half a degree or more, or at the smaller
/// angle stated by the operation; on the first turn 0.17 degrees suffice. The level moves over it that follow,
/// clearing the floor left by its last turn, also belong to it. The entry's own material is only that below the
/// height at which the entry began, and for level moves, material no higher than the descent of one turn. If the
/// cutter of an earlier entry into material passed over a part of this entry's area, material above that entry's
/// level does not belong to this entry, unless a wall or a neck as wide as the cutter is between them, or passes have
/// cut a greater length since: a second descent there is a pass cut in short pieces. All other moves are ordinary
/// passes.
class EntryWatch {
 public:
  /// Keeps a pointer to the finished part; null if no part is stated.
  explicit EntryWatch(const FinishedPart* finished) : finished_(finished) {}
  /// Takes up the first of these moves, the next of the program.
  void follow(std::span<const CheckedMove> moves, const StatedEntry& stated);
  /// Whether the move belongs to an entry.
  bool is_inside() const { return state_ != State::kOutside; }
  /// Whether the move is the first one of an entry.
  bool begins() const { return begins_; }
  /// mm; with the tip at z, the height above which material does not belong to the entry.
  double others_from(double z) const;
  /// The tip is at z on this path and the cutter touches nothing: the descent has not begun yet.
  void meets_nothing_at(const Edge& path, double z);
  /// Whether meets_material() must be called if a move meets material: for an entry that has not met any yet, and for
  /// passes after one.
  bool asks_for_material() const { return is_inside() ? !has_met_ : !past_.empty(); }
  /// Reports that the last followed move, a feed move, is in material.
  void meets_material(const Move& move);

 private:
  enum class State : unsigned char { kOutside, kDescent, kRound };

  /// A finished entry into material.
  struct Past {
    std::vector<Edge> path;
    Box box;  ///< box of the path
    double radius = 0, level = 0;
    double passes = 0;  ///< mm that passes must cut before another entry beside it
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
  bool at_joint_ = false;  ///< on a level move of micrometres within the descent
  std::vector<const Move*> descent_;
  double base_ = 0;       ///< mm; height at the start of the descent
  double slope_ = 0;      ///< slope of its steepest move
  double length_ = 0;     ///< mm in plan so far
  double slope_now_ = 0;  ///< slope of its last move
  double radius_ = 0;     ///< mm; radius of the cutter
  std::vector<Past> past_;
  double turn_ = 0;  ///< mm; length of one turn of the widest helix of this cutter
};

}  // namespace clearcut::verify
