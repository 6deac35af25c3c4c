// Differences of the word-address controls (all except Klartext), as data, and the words for setting up such a
// control and for its places.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "model/move.h"
#include "model/options/post_options.h"

namespace clearcut::post {

enum class CommentForm { kParentheses, kSemicolon };
enum class PathControl {
  kNone,
  kTolerance,       ///< G64 P- Q0
  kCornerRounding,  ///< G187 P- E-: P1 roughs, P3 finishes
  kContour,         ///< G642 CTOL=
  kExactStop        ///< G61: the control states no bound for its rounding in G64
};
enum class LengthOffset {
  kNone,
  kPlain,         ///< G43
  kNumbered,      ///< G43 H2
  kWithApproach,  ///< G43 H2 Z25. as the first move down
  kEdge           ///< D1 Z25. likewise: the length of the tool's first edge
};
/// Place of Z for tool changes and at the end.
enum class HomeForm {
  kSafeHeight,   ///< no machine place is used; home is the place stored for G28
  kSwitches,     ///< likewise, and G28 drives to the end switches
  kMachineZero,  ///< G53 G0 Z0.
  kReference,    ///< G91 G28 Z0. and G90
  kSuppressed,   ///< SUPA G0 Z0 D0: no frame and no length count in the block
  kHomePosition  ///< no place while it works; home is G30 P1, stored in the control
};
/// Form of tapping of a control.
enum class Tapping {
  kByWords,      ///< no cycle: down, M4, up; only with a floating holder
  kFloating,     ///< G84 does the same
  kRigid,        ///< G84 ties the feed to the spindle
  kRigidByM29,   ///< the same after M29
  kRigidByG33_1  ///< G33.1; G84 with a floating holder
};
enum class DwellForm { kPSeconds, kXSeconds, kSSeconds, kFSeconds };
/// What G41 says beside itself.
enum class RadiusWord {
  kNone,       ///< the control does not compensate
  kUnwritten,  ///< it does, and no words for it are written here
  kNumbered,   ///< D and the tool's number
  kOfEdge      ///< nothing: it takes the radius of the edge in force
};
/// How a program calls the cycles that make a hole.
enum class CycleForm {
  kNone,   ///< holes are moves
  kWords,  ///< G81 and its like, ended by G80
  kCalls   ///< MCALL CYCLE81(...), ended by MCALL
};

/// How a program calls subprograms that stand in it.
enum class SubprogramForm {
  kNone,
  kOWords,    ///< o101 sub ... o101 endsub before the calls, o101 call
  kPrograms,  ///< O7001 ... M99 behind the end, M98 P7001
  kBlocks,    ///< N7001 ... M99 behind the end, M97 P7001
  kRepeats    ///< COPY7001: ... COPY7001_END: where they are first run, REPEAT COPY7001 COPY7001_END
};

/// Flood is M8 and off by M9 on all of them.
struct MistWords {
  std::string_view on = "M7";
  std::string_view off = {};  ///< empty: M9 ends mist, too
};

/// Work offsets called by a P or H word, from `first` to `last`; last 0: none.
struct NumberedOffsets {
  int code = 0;  ///< G word in tenths
  int first = 1, last = 0;
};

struct IsoDialect {
  std::string_view name;
  std::string_view extension = ".nc";
  int mm_decimals = 4;
  int inch_decimals = 5;
  bool always_point = false;  ///< "10." not "10"
  bool tape = false;          ///< '%' as the first and the last line
  int program_digits = 0;     ///< digits of the O word; 0: none
  CommentForm comments = CommentForm::kParentheses;
  std::size_t line_length = 80;
  /// Length of a block without its blanks, as counted by senders; 0: length of the line.
  std::size_t packed_length = 0;
  bool named_in_header = false;  ///< a comment names the control, where its words are those of others, too
  std::string_view metric = "G21";
  std::string_view inches = "G20";
  std::string_view safe_start = "G17 G40 G49 G54 G80 G90 G91.1 G94";
  WorkOffset first_offset = {};     ///< where none is asked for
  int last_offset = 590;            ///< G54 to this, in tenths
  bool fractional_offsets = false;  ///< G59.1 to G59.3
  bool settable_offsets = false;    ///< G505 to G599
  std::array<NumberedOffsets, 2> numbered_offsets = {};
  PathControl path_control = PathControl::kNone;
  std::string_view exact_stop = "G61";  ///< empty: none
  /// Exact stop halts at the end of every block, else it only keeps to the path.
  bool exact_stop_halts = false;
  bool changer = true;           ///< M6; else a pause
  bool tool_word = true;         ///< T
  bool pause_says_tool = false;  ///< M0 shows the text after it
  LengthOffset length_offset = LengthOffset::kNone;
  std::string_view length_word = "G43";  ///< in front of H
  HomeForm home = HomeForm::kSafeHeight;
  DwellForm dwell = DwellForm::kPSeconds;
  double spindle_wait = 0;      ///< s
  bool rapid_feed = false;      ///< F rules G0 too
  bool repeats_motion = false;  ///< every block needs its G word
  MistWords mist = {};
  Tapping tapping = Tapping::kByWords;
  CycleForm cycles = CycleForm::kNone;
  RadiusWord radius = RadiusWord::kNumbered;
  bool entered_at_tools = false;  ///< shops begin at a tool after a reset, which ends the modes of the start
  bool modal_cycles = false;      ///< one cycle for holes alike, whose places follow it
  bool numbers_tools = false;     ///< N1, N2, ... where the work of a tool begins
  bool preselects = false;        ///< the next tool is called while one works
  bool table_forward = false;     ///< Y also goes home at the end, bringing the work to the operator
  bool optional_stop = true;      ///< M1, which stops if enabled by the operator
  bool block_numbers = true;      ///< N words contain only numbers
  bool dogleg_rapids = false;     ///< G0 need not be straight: z and plan move one after the other
  SubprogramForm subprograms = SubprogramForm::kNone;
  std::string_view end = "M30";   ///< last word; empty: replaced by a comment
  double largest_radius = 10000;  ///< mm
};

/// The row of this name, or nullptr.
const IsoDialect* iso_dialect_named(std::string_view name);
std::vector<std::string> iso_dialect_names();

/// Words for changing from `held` to `wanted`, each in its own block: Grbl accepts one of them per block.
std::vector<std::string_view> coolant_words(Coolant held, Coolant wanted, const MistWords& mist);

bool has_work_offset(const IsoDialect& dialect, const WorkOffset& offset);
/// For messages: "G54 to G59, G54.1 P1 to P300"; "" if its programs have none.
std::string work_offsets_of(const IsoDialect& dialect);

/// Mode blocks with the requested work offset in place of the first one; an offset with a P word has its own block,
/// the second.
std::vector<std::string> mode_blocks(const IsoDialect& dialect, const WorkOffset& offset);
/// The same at later tools. Without G49, which by itself may move Z by the active length; the next G43 replaces the
/// length.
std::vector<std::string> later_mode_blocks(const IsoDialect& dialect, const WorkOffset& offset);

/// To the home of all axes, Z first; G28 starts at the tool's position, without an intermediate point.
std::vector<std::string> home_blocks(const IsoDialect& dialect);

}  // namespace clearcut::post
