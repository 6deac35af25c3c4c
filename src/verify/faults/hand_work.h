// What a program leaves to whoever stands at the machine: the spindle's switch and speed, and the lengths of tools.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "model/control.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Of one program. What it has no word for anywhere is done by hand, and a condition; what it does in one place and not in another is a
/// mistake.
class HandWork {
 public:
  /// Nothing is left to hands, since nothing is known.
  HandWork() = default;
  /// `control` is that of `moves`, the first of which is its move 0; null: unknown.
  HandWork(std::span<const CheckedMove> moves, const ControlTable* control, const VerifyOptions& options);

  /// No word of the program turns the spindle: hands switch it on.
  bool switches_spindle() const { return switches_spindle_; }
  /// No word of the program states a speed.
  bool sets_speed() const { return sets_speed_; }
  /// Whether the cut needs a tool length that the program could have brought into force, and it is not done by hand.
  bool lacks_length(const CheckedMove& checked) const;
  /// `spindle-by-hand`, `speed-by-hand`, `tool-by-hand`, `tool-length-off`, where something is cut so.
  std::vector<Condition> conditions() const;

 private:
  void find_lengths();
  void find_changes();
  bool lengths_are_touched_off() const;
  bool somebody_comes_before(const CheckedMove& cut) const;
  bool needs_length() const;
  std::string tools() const;

  std::span<const CheckedMove> moves_;
  const ControlTable* control_ = nullptr;
  bool needs_tool_length_ = false;    ///< without a length the control cuts at wrong heights
  bool changes_tools_alone_ = false;  ///< nobody stands beside a tool change
  bool switches_spindle_ = false, sets_speed_ = false;
  const CheckedMove* first_cut_ = nullptr;          ///< that removes material
  const CheckedMove* first_with_length_ = nullptr;  ///< of all moves
  std::set<int> changed_;                           ///< tools that an M6 puts in
  std::vector<const CheckedMove*>
      first_cuts_;            ///< of each tool after such a change, where it needs a length and has none
  bool touched_off_ = false;  ///< somebody can measure each of them in the spindle
};

}  // namespace clearcut::verify
