// What a word-address control holds before a line of a program, the words that bring it there from its start, and at which lines a
// program can be begun anew.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "read/gcode/control/control.h"

namespace clearcut::read::gcode {

/// Why a program cannot be begun anew at a block.
enum class Hindrance : unsigned char {
  kNone,
  kCycle,         ///< its places belong to a drilling or tapping cycle above
  kArcs,          ///< its places belong to an arc word above
  kUnplaced,      ///< its places belong to a motion word above, and no place was stated so far
  kCompensation,  ///< cutter radius compensation is on
  kMap,           ///< the program's places are shifted, turned, mirrored or polar
  kShift,         ///< the zero was moved to where the cutter stood
  kAddedLength,   ///< a length is added to the tool's
  kSavedModes,    ///< modes were kept that a later word brings back
  kOldLength,     ///< the length in force is that of the tool before
  kCorner,        ///< it goes on from the move before: at rounded corners, CT, between APPR and DEP
  kDefinition,    ///< it is one of several lines that define a cycle
  kMacro          ///< the program computes or calls before it
};
/// "within a drilling or tapping cycle"
const char* text_of(Hindrance hindrance);

/// One block with words, before it is executed.
struct StopBlock {
  int line = 0;
  Hindrance hindrance = Hindrance::kNone;
  bool moves = false;         ///< it has a place to go to
  bool changes_tool = false;  ///< M6
  bool is_placed = false;     ///< X, Y and Z are known
  double z = 0;               ///< mm, of the tip, where known
  int tool = 0;               ///< in the spindle
};

/// Words of a program that hold until another of their kind, each as text of a line: "G64 P0.01".
struct HeldWords {
  std::string plane, units, distance, centers, feed_mode, level;  ///< "G17" and so on; "" where none was said
  std::string path, smoothing, offset, compensation, cycle_end;
  std::vector<std::string> coolant;  ///< those that switched on what is on
  std::vector<std::string> zeros;    ///< lines that write work offsets into the control's table
  std::string home;                  ///< of the last way straight up to a place of the machine: "G91 G28 Z0"
  bool local_shift = false;          ///< G52 was said
  std::string tool_definitions;      ///< Klartext: lines that state lengths and radii of tools
  std::string tool_calls;            ///< Klartext: lines from the last change of tools on
  std::string cycle;                 ///< Klartext: lines of the definition of the last cycle for holes
  std::string length;                ///< Sinumerik: "D1"
  std::string tool_name,
      next_tool_name;  ///< Sinumerik: T="MILL6", where the tool in the spindle, or the one called last, has a name
  std::map<std::string, int> tool_numbers;  ///< Sinumerik: of all tools that were called by names so far
  std::vector<std::string>
      ways;  ///< lines of Sinumerik on how axes are driven and corners gone round, "SOFT", "FFWON", "G451"; of OSP the level of cycles
  bool feeds_in_mm = false;  ///< Sinumerik: G70 and G71 are for lengths alone
};

struct HeldState {
  Modes modes;
  int motion = -1;  ///< G word in tenths, as in Control
  int tool = 0, next_tool = 0;
  bool tool_said = false, changer = false;
  Target position;                ///< mm, in the frame of the work
  std::array<double, 3> shift{};  ///< mm; what leads from the program's words to there
  std::array<double, 3> local{};  ///< mm; of G52 alone
  bool at_home = false;           ///< at the height of the machine's own zero
  std::optional<Vec2> pole;       ///< mm, Klartext
  double spindle_wait = 0;        ///< s that the program waits after it has started the spindle
  HeldWords words;
};

/// Keeps M8 and M7 for the coolant that is on `now`, of languages in which these are the only words of flood and mist.
void keep_coolant(Coolant before, Coolant now, HeldWords& words);

/// s that a program waits between the last start of the spindle and the motion after it.
double wait_behind_spindle(const std::vector<ControlEvent>& events);

/// What of `b` is not as in `a`, by name: "feed"; "" where a program would go on alike. `position` is compared where both know it.
std::string difference(const HeldState& a, const HeldState& b);

struct StopScan {
  std::vector<StopBlock> blocks;  ///< all with words, in order
  std::optional<HeldState>
      held;  ///< before the first block with words at or after the line that was asked for
  std::optional<HeldState> moving;  ///< before the first block with a motion there
  int held_line = 0, moving_line = 0;
  int macro_line = 0;  ///< where the program begins to compute or call; 0: nowhere
};

/// Adds a block before it is executed, and what `held` says the control holds, if it is the first at or behind `line`.
template <typename Held>
void add_stop(const StopBlock& stop, int line, const Held& held, StopScan& scan) {
  scan.blocks.push_back(stop);
  if (stop.line < line) return;
  if (!scan.held) {
    scan.held = held();
    scan.held_line = stop.line;
  }
  if (stop.moves && !scan.moving) {
    scan.moving = held();
    scan.moving_line = stop.line;
  }
}

/// What a place without a motion word of its own needs from the lines above it.
enum class MotionNeed : unsigned char { kNothing, kPasses, kCycle, kArcs, kStraight };
/// For each block of `scan` what it needs. The first place behind a block decides whether the program can be begun anew at it: sets the
/// hindrances that are kNone so far.
void settle_motion_words(const std::vector<MotionNeed>& needs, StopScan& scan);

/// `text` is one that read_gcode() takes as `options.dialect`. Blocks behind macro_line are not listed.
StopScan scan_stops(std::string_view text, const std::string& file_name, const ReadControllerOptions& options,
                    int line);

}  // namespace clearcut::read::gcode
