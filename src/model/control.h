// The control's state while a program runs, besides the tool's position, as the reader found it stated.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/machine.h"
#include "model/move.h"

namespace clearcut::inline model {

/// A fact about the machine not stated in the program; if the fact were otherwise, the cutter would move elsewhere.
struct Condition {
  std::string name;  ///< short and stable, accepted on the command line: "g55", "units", "tool-length-h5"
  std::string text;  ///< one sentence: the fact that must be true at the machine
  int line = 0;      ///< line of the program at which the condition first matters; 0: the whole program
  /// Source confirming the condition: "accepted", "machine file"; "" while the condition is open.
  std::string met_by{};
};

enum class SpindleState : unsigned char { kOff, kClockwise, kCounterClockwise };

/// Tool length that the control subtracts.
enum class LengthKind : unsigned char {
  kUnstated,     ///< no word so far
  kOff,          ///< G49
  kOfTool,       ///< length of the tool in the spindle: G43 without H, TOOL CALL
  kNumbered,     ///< G43 H
  kStatedHeight  ///< G43.1 Z, DL: a length in the program itself
};

struct ToolLength {
  LengthKind kind = LengthKind::kUnstated;
  int h = 0;             ///< kNumbered: the H word
  double stated_mm = 0;  ///< kStatedHeight: the length; already included in the moves' heights
  friend bool operator==(const ToolLength&, const ToolLength&) = default;
};

/// Rule for the deviation of the control from the path at corners.
enum class PathMode : unsigned char {
  kUnstated,    ///< no word so far: as the control was left or set up
  kExactPath,   ///< G61, and controls without deviation from the path
  kExactStop,   ///< G61.1; G61 on controls where G61 stops in every corner
  kTolerance,   ///< G64 P, cycle 32 T, G187 E: within `tolerance_mm`
  kContinuous,  ///< G64 without P, constant velocity: no bound is stated
  kSmoothness   ///< G187 P without E: a setting of the control
};

struct PathControl {
  PathMode mode = PathMode::kUnstated;
  std::optional<double> tolerance_mm;  ///< P word, T, E
  std::optional<double> merging_mm;    ///< Q word: short lines are merged within this distance
  friend bool operator==(const PathControl&, const PathControl&) = default;
};

/// State of the control during a run of moves.
struct ControlState {
  int tool = 0;  ///< 0: unknown
  SpindleState spindle = SpindleState::kOff;
  double spindle_rpm = 0;  ///< S word in force, also while the spindle is off; 0: never stated
  Coolant coolant = Coolant::kOff;
  ToolLength length;
  PathControl path;
  friend bool operator==(const ControlState&, const ControlState&) = default;
};

/// `state` holds from the move with this number until the next span. Moves are counted from 0 over all sections.
struct ControlSpan {
  std::size_t first_move = 0;
  int line = 0;  ///< program line of that move
  ControlState state;
};

enum class ControlEventKind : unsigned char {
  kToolChange,        ///< M6, TOOL CALL: `tool` is put in
  kToolChangeByHand,  ///< a pause after a T word: `tool` is put in
  kPause,             ///< M0, M1
  kDwell,             ///< `seconds`
  kSpindleStart,      ///< M3, M4 from standstill or reversal of the direction
  kSpindleStop,
  kTapTurnsBack  ///< at the bottom of a tapping cycle: the spindle reverses until the tap is out
};

/// Assumptions of a tapping cycle about its tap, and how the feed is synchronised with the spindle.
struct TapCycle {
  std::optional<bool> left_hand;  ///< absent: the cycle cuts as the spindle turns
  bool is_tied = true;            ///< the feed follows the spindle, with any holder
  bool turns_by_itself = false;   ///< the control turns the spindle as the cycle asks, regardless of M3 or M4
};

/// An event immediately before the move with the given number.
struct ControlEvent {
  ControlEventKind kind = ControlEventKind::kDwell;
  std::size_t before_move = 0;
  int line = 0;
  double seconds = 0;
  int tool = 0;
  TapCycle tap = {};  ///< tapping cycle of kTapTurnsBack
};

/// An arc whose words give two different radii: controls differ in their interpretation of the arc.
struct ArcDoubt {
  std::size_t move = 0;
  double apart_mm = 0;  ///< the tool may be anywhere within this of the move
};

/// The moves from this number until the next span come from one line of a subprogram.
struct CallSpan {
  std::size_t first_move = 0;
  int calls = -1;  ///< index into ControlTable::call_texts; -1: a line of the program itself
};

/// Statements of a read program other than its motion; all lists ascending.
struct ControlTable {
  std::vector<ControlSpan> spans;
  std::vector<ControlEvent> events;
  std::vector<ArcDoubt> arcs;
  std::vector<CallSpan> calls;
  /// Lines of subprograms, each with the calls that led there: "O1000.nc:4, O1000 called in part.nc:12".
  std::vector<std::string> call_texts;
  std::optional<MotionPlanner> planner;  ///< planner of the control in whose dialect the program was read
  /// The program contains a word that turns a spindle (M3, M4, M13, M14, M19), known to the control or not.
  bool spindle_said = true;
  bool speed_said = true;  ///< an S word is
  int inch_line = 0;       ///< line of the first word that selects inches (G20, INCH); 0: none
  int mm_line = 0;         ///< line of the first word that selects mm

  /// State at move number `index`, counted over all sections; nothing before the first span.
  const ControlState* at(std::size_t index) const;
  /// The line of the subprogram that move number `index` comes from; null: it is none.
  const std::string* calls_at(std::size_t index) const;
  /// Greatest deviation of move number `index` from the read coordinates, mm.
  double doubt_at(std::size_t index) const;
};

}  // namespace clearcut::inline model
