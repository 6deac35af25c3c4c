// The controllers whose programs are read, and what they take differently.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/motion_planner.h"

namespace clearcut::read::gcode {

enum class Dialect : unsigned char { kLinuxCnc, kGrbl, kFanuc, kHaas, kHeidenhain, kMach3, kMach4, kMarlin };

/// "linuxcnc", "grbl", "fanuc", "haas", "heidenhain", "mach3", "mach4", "marlin".
std::string_view name_of(Dialect dialect);
std::optional<Dialect> dialect_named(std::string_view name);
/// Whose rules of motion the control has.
MotionPlanner planner_of(Dialect dialect);

/// How G74 and G84 tap.
enum class TapRule : unsigned char {
  kAsItTurns,  ///< as the spindle turns, which has to be the way of the cycle; the feed is its own
  kTiedByM29,  ///< the control turns the spindle; the feed is tied to it after M29
  kTied        ///< the control turns the spindle and ties the feed to it
};

/// What a word-address control does where others do otherwise.
struct DialectRules {
  Dialect dialect = Dialect::kLinuxCnc;
  bool cycles = true;  ///< G73, G81 and so on exist
  bool tool_lengths = true;
  bool lengths_by_number = false;  ///< G43 without H takes the H word before it, not the tool's own
  bool changer = true;             ///< M6 and T exist
  bool path_words = true;          ///< G61, G64; without them the control keeps to the path
  bool returns_to_r = false;       ///< cycles return to R until a G98 is seen
  bool cycle_rises_over =
      false;  ///< the way over the next hole goes up to the height before the cycles at once
  bool feeds_out_to_clear = false;  ///< G89, G74, G84 feed up to the clear height, not to R
  TapRule taps = TapRule::kAsItTurns;
  bool keeps_cycle_words = true;  ///< Z, R and Q hold from one cycle word to another
  bool rereads_cycle_numbers =
      false;                         ///< G20, G21 within a cycle: the numbers it holds count in the new units
  bool radius_beats_center = false;  ///< R with I, J: R is taken
  bool home_is_top = false;          ///< machine Z zero is the upper end of the travel
  bool resets_modes = false;         ///< begins in G17, G90, G94, G54, G80 whatever ran before
  bool always_mm = false;            ///< begins in mm
  bool points_matter = false;        ///< X10 may mean 10 increments
  bool centers_set_up = false;       ///< without G90.1, G91.1 its set-up says which
  bool dwell_by_x = false;           ///< G4 X: seconds
  bool dwell_in_ms = false;          ///< G4 P: milliseconds
  bool dwell_by_s = false;           ///< G4 S: seconds
  bool saves_modes = false;          ///< M70 to M73
  bool has_old_units = false;        ///< G70 and G71 are G20 and G21
  int numbered_offsets = 0;          ///< most P of G54.1, G154, G59
  int mist_on = 70;                  ///< M word in tenths
  int mist_off = 90;                 ///< where it is not M9, that ends flood alone
  std::string_view inch_needs = {};  ///< what must hold for G20; empty: nothing
  bool pause_says_text = false;      ///< M0 and M1 show the text behind them
  std::string_view mist_needs = {};  ///< what must hold for them; empty: every such control has them
};

const DialectRules& rules_of(Dialect dialect);
/// All but Klartext.
std::vector<Dialect> word_address_dialects();
/// Whether the control has the G word; codes in tenths. True for words that are nobody's business here.
bool knows_g(const DialectRules& rules, int code);
/// The same of M words. Where it is false a control stops, does nothing or something that is no business of milling.
bool knows_m(const DialectRules& rules, int code);

}  // namespace clearcut::read::gcode
