// The controllers whose programs are read, and what they take differently. Each is one row of dialect.cpp; nothing else compares
// controllers. docs/adding-a-controller.md tells how one is added.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "model/dialect.h"
#include "model/machine.h"
#include "model/options/post_options.h"
#include "read/gcode/motion/compensation.h"

namespace clearcut::read::gcode {

/// As options say it, one of kControllers: "linuxcnc", "grbl" and so on.
std::string_view name_of(Dialect dialect);
std::optional<Dialect> dialect_named(std::string_view name);
/// Whose rules of motion the control has.
MotionPlanner planner_of(Dialect dialect);

/// The language of a program; each has a reader of its own.
enum class Language : unsigned char { kWordAddress, kKlartext, kSinumerik };

/// How programs of the control compute, loop and call; each language has a reader of its own.
enum class MacroLanguage : unsigned char {
  kNone,
  kLinuxCnc,  ///< parameters with names, O words
  kFanuc,     ///< Custom Macro: IF, GOTO, WHILE, G65, M98
  kMach,      ///< parameters, M98
  kSinumerik  ///< R parameters, GOTOF, WHILE, subprograms by name
};

/// How a program of the control ends.
enum class ProgramEnd : unsigned char {
  kWord,        ///< by M2 or M30; without one the text may have been cut short
  kWordOrText,  ///< the same words, and many programs leave them out
  kText         ///< the control has no word for it
};

/// How G74 and G84 tap.
enum class TapRule : unsigned char {
  kAsItTurns,  ///< as the spindle turns, which has to be the way of the cycle; the feed is its own
  kTiedByM29,  ///< the control turns the spindle; the feed is tied to it after M29
  kTied        ///< the control turns the spindle and ties the feed to it
};

/// How a control bores by G76, G87 and G88.
enum class BoringWords : unsigned char {
  kNone,       ///< by none of them; LinuxCNC takes G87 and G88 and leaves open what they do
  kManualOut,  ///< G88 stops at the bottom, and the operator takes the tool out
  kFanuc,      ///< and G76 turns the bar and goes aside before it comes out; G87 bores from below
  kHaas        ///< as Fanuc's, but G87 is as G88, and G77 bores from below
};

/// What the numbers beside G51 are.
enum class ScalingWords : unsigned char {
  kNone,         ///< none that is read
  kThousandths,  ///< centre X Y Z and factor P, or I J K for the axes one by one; whole numbers are thousandths
  kFactor,       ///< centre X Y Z and factor P
  kAxes          ///< X Y Z are the factors themselves, about the zero
};

/// Which words a control stops at where no other word of their block uses them.
enum class StrayWords : unsigned char {
  kIgnored,
  kLinuxCnc,
  kGrbl,
  kGrblHal,  ///< as Grbl, and P beside arcs is their turns
  kCorners   ///< none; R and Q beside lines do nothing, where a comma before R would round the corner
};

/// G words that only some controls have, by what they are for. A row adds those that its control has.
enum GWordSet : unsigned {
  kDrillCycles = 1U << 0U,          ///< G73, G74, G76, G77, G81 to G89
  kToolLengths = 1U << 1U,          ///< G43
  kStatedLengths = 1U << 2U,        ///< G43.1, G43.2
  kHaasWords = 1U << 3U,            ///< G110 to G129, G154, G187
  kOffsetsByNumber = 1U << 4U,      ///< G54.1
  kFractionalOffsets = 1U << 5U,    ///< G59.1 to G59.3
  kKeptShifts = 1U << 6U,           ///< G92.2, G92.3
  kExactStopBesidePath = 1U << 7U,  ///< G61.1
  kStoredPlaces = 1U << 8U,         ///< G28.1, G30.1
  kAbsoluteCenters = 1U << 9U,      ///< G90.1
  kPlanMaps = 1U << 10U,            ///< G16, G68, G51.1, G50.1
  kSkipMoves = 1U << 11U,           ///< G31
  kProbing = 1U << 12U,             ///< G38.2 to G38.5
  kCompensation = 1U << 13U,        ///< G41, G42
  kStatedRadii = 1U << 14U          ///< G41.1, G42.1
};

/// Which G words a control has.
struct GWords {
  unsigned sets = 0;                  ///< of GWordSet
  std::span<const int> only = {};     ///< in tenths; not empty: all that it has, whatever `sets` says
  std::span<const int> missing = {};  ///< in tenths, of the words that most controls have
};

/// Which M words a control has. Where both lists are empty it has all.
struct MWords {
  std::span<const int> only = {};     ///< in tenths; not empty: all that it has
  bool user_words = false;            ///< and M100 to M199, which are programs of the user's
  std::span<const int> missing = {};  ///< in tenths
  /// What the control does at a word that it does not have.
  std::string_view at_others = " that milling needs; it does nothing there";
};

/// What a control does where others do otherwise.
struct DialectRules {
  Dialect dialect = Dialect::kLinuxCnc;
  std::string_view name = {};   ///< as options say it
  std::string_view title = {};  ///< as people say it
  MotionPlanner planner = MotionPlanner::kJerkLimited;
  Language language = Language::kWordAddress;
  ProgramEnd end = ProgramEnd::kWord;
  MacroLanguage macros = MacroLanguage::kNone;

  // What conditions name where nothing is said.
  std::string_view unit_words = "neither G20 nor G21";
  std::string_view no_path_word = "neither G61 nor a path tolerance";
  std::string_view blends_freely = "G64 without P";
  std::string_view blends_by_setting = "G187 without E above 0";

  // What the verdict asks of its programs.
  bool needs_lengths = false;       ///< without a word for the tool's length it cuts at wrong heights
  bool changer_alone = false;       ///< changes tools with nobody there
  bool speed_may_be_power = false;  ///< S may be a share of the full power and no rpm
  bool names_no_tools = false;      ///< its programs have no words for tools

  GWords g = {};
  MWords m = {};
  StrayWords stray_words = StrayWords::kIgnored;
  bool lengths_by_number = false;      ///< G43 without H takes the H word before it, not the tool's own
  bool zero_length_is_off = true;      ///< G43 H0 is G49; else it is the length of the tool
  bool changer = true;                 ///< M6 and T exist
  std::string_view change_needs = {};  ///< what must hold for M6 to change the tool; empty: nothing
  bool states_tool = false;            ///< M61 Q: which tool is in the spindle
  bool path_words = true;              ///< G61, G64; without them the control keeps to the path
  bool bounded_blending = false;       ///< P of G64 bounds what it rounds
  bool returns_to_r = false;           ///< cycles return to R until a G98 is seen
  bool cycle_rises_over =
      false;  ///< the way over the next hole goes up to the height before the cycles at once
  bool cycle_goes_over_below_r = false;  ///< from below R it goes over the hole at that height, and up there
  bool cycle_needs_dwell = false;        ///< G82, G86, G88 and G89 stop the control without their P word
  bool feeds_out_to_clear = false;       ///< G89, G74, G84 feed up to the clear height, not to R
  TapRule taps = TapRule::kAsItTurns;
  bool taps_peck = false;  ///< Q of G74 and G84 breaks chips
  BoringWords boring = BoringWords::kNone;
  ScalingWords scaling = ScalingWords::kNone;
  bool keeps_cycle_words = true;  ///< Z, R and Q hold from one cycle word to another
  bool rereads_cycle_numbers =
      false;                         ///< G20, G21 within a cycle: the numbers it holds count in the new units
  bool feed_in_unit_before = false;  ///< F beside G20 or G21 counts in the unit before them
  bool feed_mode_drops_feed = false;  ///< G93, G94, G95 end the feed in force, also in the same mode
  bool radius_beats_center = false;   ///< R with I, J: R is taken
  bool home_is_top = false;           ///< machine Z zero is the upper end of the travel
  bool g61_halts = false;             ///< G61 halts at the end of every block, else it only keeps to the path
  bool home_is_switches = false;      ///< G28 drives to the end switches, past no place on the way
  bool no_home_in_cycle = false;      ///< G28 and G30 within a drilling cycle are an alarm
  bool adds_to_offsets = false;       ///< G10 L2 in G91 adds to the offset
  bool resets_modes = false;          ///< begins in G17, G90, G94, G54, G80 whatever ran before
  bool always_in_xy = false;          ///< arcs and cycles are in the XY plane unless a word says otherwise
  bool always_mm = false;             ///< begins in mm
  bool points_matter = false;         ///< X10 may mean 10 increments
  bool centers_set_up = false;        ///< without G90.1, G91.1 its set-up says which
  bool dwell_by_x = false;            ///< G4 X: seconds
  bool dwell_in_ms = false;           ///< G4 P: milliseconds
  bool dwell_with_point_in_s = false;    ///< where P has a decimal point: seconds
  bool dwell_by_s = false;               ///< G4 S: seconds
  bool saves_modes = false;              ///< M70 to M73
  bool polar_words = false;              ///< '@' and '^'
  bool count_in_program_number = false;  ///< M98 P0031234 runs O1234 three times
  bool calls_blocks = false;             ///< M97
  bool corner_words = false;             ///< ",R" and ",C", or RND=, CHF= and CHR=
  std::string_view corner_needs = {};    ///< what must hold for them; empty: every such control has them
  bool corner_feeds_as_next = false;     ///< a rounding or chamfer runs at the feed of the move behind it
  int most_calls = 9;                    ///< subprograms within each other
  bool has_old_units = false;            ///< G70 and G71 are G20 and G21
  int numbered_offsets = 0;              ///< most P of G54.1, G154, G59
  int offset_with_number = 0;            ///< plain work offset, in tenths, that takes a P word, too; 0: none
  int mist_on = 70;                      ///< M word in tenths
  int mist_off = 90;                     ///< where it is not M9, that ends flood alone
  std::string_view inch_needs = {};      ///< what must hold for G20; empty: nothing
  bool pause_says_text = false;          ///< M0 and M1 show the text behind them
  std::string_view mist_needs = {};      ///< what must hold for them; empty: every such control has them
  CompensationRules compensation = {};
  bool radius_number_stays = false;  ///< D holds until another: G41 takes the last one
  bool osp_words = false;            ///< G15 H, G56 H, G53, G4 F, G71 with M53, as in control/osp_words.h
  std::string_view length_on = "G43", length_off = "G49";
  bool radius_of_edge = false;  ///< G41 takes the radius of the tool in the spindle, whatever D says
};

const DialectRules& rules_of(Dialect dialect);
/// The control whose programs are in that language; of several the first.
Dialect dialect_of(Language language);
/// All whose programs are words of one letter each.
std::vector<Dialect> word_address_dialects();
/// G76, G87 and G88 where the control bores by them; codes in tenths.
bool is_boring_cycle(const DialectRules& rules, int code);
/// G77 or G87, where the control bores from below by it.
bool bores_from_below(const DialectRules& rules, int code);
/// Whether the control has the G word; codes in tenths. True for words that are nobody's business here.
bool knows_g(const DialectRules& rules, int code);
/// The same of M words. Where it is false a control stops, does nothing or something that is no business of milling.
bool knows_m(const DialectRules& rules, int code);
/// M100 to M199, in tenths: on LinuxCNC programs of the user's.
bool is_user_word(int code);

}  // namespace clearcut::read::gcode
