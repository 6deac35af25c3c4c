// What the control holds while a program runs, besides where the tool is: as the reader found it stated.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/coolant.h"
#include "model/motion_planner.h"

namespace clearcut::inline model {

/// Something about the machine that the program does not say and that would move the cutter elsewhere.
struct Condition {
  std::string name;      ///< short and stable, accepted on the command line: "g55", "units", "tool-length-h5"
  std::string text;      ///< one sentence: what must hold at the machine
  int line = 0;          ///< of the program, where it first matters; 0: all of it
  std::string met_by{};  ///< who says that it holds: "accepted", "machine file"; "" while it is open
};

enum class SpindleState : unsigned char { kOff, kClockwise, kCounterClockwise };

/// Which tool length the control takes off.
enum class LengthKind : unsigned char {
  kUnstated,     ///< no word so far
  kOff,          ///< G49
  kOfTool,       ///< that of the tool in the spindle: G43 without H, TOOL CALL
  kNumbered,     ///< G43 H
  kStatedHeight  ///< G43.1 Z, DL: a length in the program itself
};

struct ToolLength {
  LengthKind kind = LengthKind::kUnstated;
  int h = 0;             ///< kNumbered: the H word
  double stated_mm = 0;  ///< kStatedHeight: the length; it is in the moves' heights already
  friend bool operator==(const ToolLength&, const ToolLength&) = default;
};

/// How far the control may leave the path between its corners.
enum class PathMode : unsigned char {
  kUnstated,    ///< no word so far: as the control was left or set up
  kExactPath,   ///< G61, and controls that never leave the path
  kExactStop,   ///< G61.1; G61 where it stops in every corner
  kTolerance,   ///< G64 P, cycle 32 T, G187 E: within `tolerance_mm`
  kContinuous,  ///< G64 without P, constant velocity: no bound is stated
  kSmoothness   ///< G187 P without E: a setting of the control
};

struct PathControl {
  PathMode mode = PathMode::kUnstated;
  std::optional<double> tolerance_mm;  ///< P word, T, E
  std::optional<double> merging_mm;    ///< Q word: short lines are merged within it
  friend bool operator==(const PathControl&, const PathControl&) = default;
};

/// What holds during a run of moves.
struct ControlState {
  int tool = 0;  ///< 0: unknown
  SpindleState spindle = SpindleState::kOff;
  double spindle_rpm = 0;  ///< S word in force, also while the spindle is off; 0 never said
  Coolant coolant = Coolant::kOff;
  ToolLength length;
  PathControl path;
  friend bool operator==(const ControlState&, const ControlState&) = default;
};

/// `state` holds from the move with this number until the next span. Moves are counted from 0 over all sections.
struct ControlSpan {
  std::size_t first_move = 0;
  int line = 0;  ///< of that move
  ControlState state;
};

enum class ControlEventKind : unsigned char {
  kToolChange,        ///< M6, TOOL CALL: `tool` is put in
  kToolChangeByHand,  ///< a pause after a T word: `tool` is put in
  kPause,             ///< M0, M1
  kDwell,             ///< `seconds`
  kSpindleStart,      ///< M3, M4 from standstill or the other way round
  kSpindleStop,
  kTapTurnsBack  ///< at the bottom of a tapping cycle: the spindle turns the other way until the tap is out
};

/// What a tapping cycle takes its tap for, and who ties the feed to the spindle.
struct TapCycle {
  std::optional<bool> left_hand;  ///< absent: the cycle cuts as the spindle turns
  bool is_tied = true;            ///< the feed follows the spindle, whatever the holder
  bool turns_by_itself = false;   ///< the control turns the spindle as the cycle asks, whatever M3 or M4 said
};

/// Happens before the move with that number begins.
struct ControlEvent {
  ControlEventKind kind = ControlEventKind::kDwell;
  std::size_t before_move = 0;
  int line = 0;
  double seconds = 0;
  int tool = 0;
  TapCycle tap = {};  ///< of kTapTurnsBack
};

/// An arc whose words give two radii: controls differ in what they make of it.
struct ArcDoubt {
  std::size_t move = 0;
  double apart_mm = 0;  ///< the tool may be anywhere within this of the move
};

/// What a program that was read says besides its motion; all lists ascending.
struct ControlTable {
  std::vector<ControlSpan> spans;
  std::vector<ControlEvent> events;
  std::vector<ArcDoubt> arcs;
  std::optional<MotionPlanner> planner;  ///< of the control as which it was read
  bool spindle_said =
      true;  ///< a word that turns a spindle is somewhere in it (M3, M4, M13, M14, M19), known to the control or not
  bool speed_said = true;  ///< an S word is
  int inch_line = 0;       ///< line of the first word that begins inches (G20, INCH); 0: none
  int mm_line = 0;         ///< of the first that begins mm

  /// What holds at move number `index`, counted over all sections; nothing before the first span.
  const ControlState* at(std::size_t index) const;
  /// How far move number `index` may lie beside what was read, mm.
  double doubt_at(std::size_t index) const;
};

}  // namespace clearcut::inline model
