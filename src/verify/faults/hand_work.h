// Actions that a program leaves to the operator: the spindle's switch and speed, and the lengths of tools.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "model/control.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Manual actions for one program. An action for which the program has no word at all is done by hand, and is a
/// condition; an action done in one place and missing in another is a mistake.
class HandWork {
 public:
  /// No manual actions, since nothing is known.
  HandWork() = default;
  /// `control` is the control table of `moves`, whose first move has the number 0; null: unknown.
  HandWork(std::span<const CheckedMove> moves, const ControlTable* control, const VerifyOptions& options);

  /// No word of the program turns the spindle: the operator switches it on.
  bool switches_spindle() const { return switches_spindle_; }
  /// No word of the program states a speed.
  bool sets_speed() const { return sets_speed_; }
  /// Whether the cut needs a tool length that the program should have activated, unless this is done by hand.
  bool lacks_length(const CheckedMove& checked) const;
  /// `spindle-by-hand`, `speed-by-hand`, `tool-by-hand`, `tool-length-off`, if some cut is made this way.
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
  bool changes_tools_alone_ = false;  ///< tools are changed without an operator
  bool switches_spindle_ = false, sets_speed_ = false;
  const CheckedMove* first_cut_ = nullptr;          ///< first move that removes material
  const CheckedMove* first_with_length_ = nullptr;  ///< first move with a tool length
  std::set<int> changed_;                           ///< tools loaded by an M6
  /// Per tool: first cut after such a change, if it needs a length and has none.
  std::vector<const CheckedMove*> first_cuts_;
  bool touched_off_ = false;  ///< the operator can measure each of them in the spindle
};

}  // namespace clearcut::verify
