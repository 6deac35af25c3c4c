#include "read/gcode/control/mode_words.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "read/gcode/control/compensation_words.h"
#include "read/gcode/control/place_words.h"
#include "read/gcode/motion/cycle.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

namespace {

/// M words in tenths that move nothing on a three-axis mill: stops, spindle, tool, coolant, overrides, clamps, doors,
/// chips, signals.
constexpr int kStillWords[] = {0,   10,  20,  30,  40,  50,  60,  70,  80,  90,  100,  110, 130,
                               140, 190, 290, 300, 310, 330, 480, 490, 500, 510, 520,  530, 620,
                               630, 640, 650, 830, 840, 880, 890, 970, 980, 990, 1170, 1180};

/// "M10"
std::string m_word(int tenths) {
  return "M" + trimmed(tenths / 10.0, 1);
}

}  // namespace

void ModeWords::set_modes(const Block& block) {
  CompensationWords compensation(control_);
  if (has_g(block, 400)) compensation.set(400, block);
  compensation.note_number(block);
  for (const int code : block.g) set_mode(code, block);
  for (const int code : block.g)
    if (group_of(code) == Group::kCompensation) compensation.set(code, block);
}

void ModeWords::use_units(double unit) {
  if (control_.cycle.code != 0 && unit != control_.modes.unit) {
    if (!control_.rules.rereads_cycle_numbers)
      control_.refuse("units change within a drilling cycle; end it by G80 before G20 or G21");
    control_.cycle.scale(unit / control_.modes.unit);
  }
  control_.modes.unit = unit;
  control_.units_said = true;
  control_.builder.say_units(unit != 1, control_.line);
  if (unit != 1 && !control_.rules.inch_needs.empty())
    control_.condition("g20", std::string(control_.rules.inch_needs));
}

void ModeWords::set_mode(int code, const Block& block) {
  switch (code) {
    case 170:
    case 180:
    case 190:
      if (code != 170) CompensationWords(control_).refuse_while_on(g_word(code));
      control_.modes.plane = code == 170 ? Plane::kXY : code == 180 ? Plane::kZX : Plane::kYZ;
      control_.plane_said = true;
      break;
    case 200:
    case 210:
      use_units(code == 200 ? kMmPerInch : 1);
      break;
    case 700:
    case 710:
      if (!control_.rules.has_old_units) return set_other(code, block);
      use_units(code == 700 ? kMmPerInch : 1);
      break;
    case 900:
    case 910:
      control_.modes.absolute = code == 900;
      control_.distance_said = true;
      break;
    case 901:
    case 911:
      control_.modes.absolute_centers = code == 901;
      control_.centers_said = true;
      break;
    case 930:
      set_feed_mode(FeedMode::kInverseTime);
      break;
    case 940:
      set_feed_mode(FeedMode::kPerMinute);
      break;
    case 950:
      set_feed_mode(FeedMode::kPerTurn);
      break;
    case 980:
    case 990:
      control_.modes.return_to_level = code == 980;
      control_.return_said = true;
      break;
    default:
      set_other(code, block);
  }
}

/// Words that leave the path alone pass; those that would change it in ways not understood are refused.
void ModeWords::set_other(int code, const Block& block) {
  const Group group = group_of(code);
  if (group == Group::kOffset) {
    CompensationWords(control_).refuse_while_on(g_word(code));
    PlaceWords(control_).use_system(code, block);
  } else if (group == Group::kCompensation || code == 400) {
    return;  // see set_modes
  } else if (code == 430 || code == 431 || code == 432 || code == 490) {
    if (control_.rules.compensation.begins_in_plan) CompensationWords(control_).refuse_while_on(g_word(code));
    PlaceWords(control_).set_length(code, block);
  } else if (code == 610 || code == 611 || code == 640 || code == 1870) {
    set_path(code, block);
  } else if (code == 150 || code == 160) {
    CompensationWords(control_).refuse_while_on(g_word(code));
    control_.polar_mode = code == 160;
    control_.polar_place = {};
  } else if (code == 690) {
    PlaceWords(control_).end_map(code, 680);
  } else if (code == 500) {
    PlaceWords(control_).end_map(code, 510);
  } else if (code == 51) {
    const bool smooths = control_.rules.macros == MacroLanguage::kFanuc && !block.has('I') && !block.has('J');
    if (!smooths && (block.has_axis() || block.has('I') || block.has('J')))
      control_.refuse("G5.1 is a spline, which is not read; post lines and arcs");
    if (smooths && block.has('Q') && block.value('Q') == 0) return;  // off
    control_.condition(
        "blending",
        "G5.1 lets the control smooth the path within a bound of its own; the exact path is checked");
  } else if (code == 700 || code == 710) {
    control_.refuse(g_word(code) + " says " + (code == 700 ? "inches" : "mm") +
                    " on Mach alone (Vectric's posts write it): name --dialect mach3, or post " +
                    (code == 700 ? "G20" : "G21"));
  } else if (code == 1500) {
    control_.refuse(
        "G150 is not read: it clears its pocket by passes that the control chooses and nobody states; post "
        "the passes themselves");
  } else if (group == Group::kUnknown) {
    control_.refuse(g_word(code) + " is not read; post the program without it");
  }
}

void ModeWords::set_path(int code, const Block& block) {
  PathControl path;
  if (code == 610) {
    path.mode = control_.rules.g61_halts ? PathMode::kExactStop : PathMode::kExactPath;
  } else if (code == 611) {
    path.mode = PathMode::kExactStop;
  } else if (code == 640) {
    // Without P, and with P0, LinuxCNC keeps no distance from the path.
    const bool bounded = block.has('P') && block.value('P') > 0 && control_.rules.bounded_blending;
    path.mode = bounded ? PathMode::kTolerance : PathMode::kContinuous;
    if (bounded) path.tolerance_mm = control_.mm(block.value('P'));
    if (bounded && block.has('Q')) path.merging_mm = control_.mm(block.value('Q'));
  } else if (block.has('E') && block.value('E') > 0) {
    path.mode = PathMode::kTolerance;
    path.tolerance_mm = control_.mm(block.value('E'));
  } else {
    path.mode = PathMode::kSmoothness;
  }
  control_.modes.path = control_.builder.path_control = path;
}

/// A feed of one kind means nothing in another; LinuxCNC asks for another one even where the mode stays the same.
void ModeWords::set_feed_mode(FeedMode mode) {
  if (mode != control_.modes.feed_mode || control_.rules.feed_mode_drops_feed) control_.modes.feed = 0;
  control_.modes.feed_mode = mode;
}

void ModeWords::save_or_restore(int m) {
  if (!control_.rules.saves_modes) return;
  control_.modes.system = control_.frame.system();
  if (m == 700 || m == 730) saved_ = control_.modes;
  if (m == 710) saved_.reset();
  if (m != 720) return;
  if (!saved_) control_.refuse("M72 brings back modes that no M70 has kept; correct it");
  const ToolLength length = control_.modes.length;
  control_.modes = *saved_;
  control_.modes.length = length;
  control_.frame.use_system(control_.modes.system);
  control_.turn_spindle(control_.modes.spindle);
  control_.builder.drive.coolant = control_.modes.coolant;
  control_.builder.path_control = control_.modes.path;
}

void ModeWords::set_feed_and_drive(const Block& block, double feed_unit) {
  if (block.has('F')) {
    if (block.value('F') < 0) control_.refuse("F word below zero; correct it");
    control_.modes.feed =
        block.value('F') * (control_.modes.feed_mode == FeedMode::kInverseTime ? 1 : feed_unit);
  }
  if (block.has('S') && block.value('S') < 0) control_.refuse("S word below zero; correct it");
  const bool seconds = has_g(block, 40) && control_.rules.dwell_by_s;
  if (block.has('S') && !seconds) {
    control_.modes.speed = block.value('S');
    control_.builder.say_speed();
  }
  if (block.has('T')) select_tool(block);
  if (std::find(block.m.begin(), block.m.end(), 60) != block.m.end()) load_tool();
  for (const int m : block.m) set_drive(m, block);
  const bool turning = control_.modes.spindle != 5;
  control_.builder.drive.spindle_rpm = turning ? control_.modes.speed : 0;
  control_.builder.speed = control_.modes.speed;
}

/// Without a tool so far it is in the spindle already; otherwise it waits for M6 or a pause.
void ModeWords::select_tool(const Block& block) {
  if (block.value('T') < 0 || block.value('T') > 1e6)
    control_.refuse("T word with an impossible tool; correct it");
  control_.next_tool = static_cast<int>(block.value('T'));
  if (control_.builder.drive.tool == 0 || !control_.tool_said)
    control_.builder.drive.tool = control_.next_tool;
  control_.tool_said = true;
}

/// A changer stops the spindle and leaves it so: the M3 counts that comes in this block or later.
void ModeWords::load_tool() {
  if (!control_.rules.changer) {
    control_.condition("m6", "M6 is no word of the control; what sends the program changes the tool");
  } else {
    const bool changes = control_.builder.drive.tool != control_.next_tool;
    if (changes && !control_.rules.change_needs.empty())
      control_.condition("m6", std::string(control_.rules.change_needs));
    control_.turn_spindle(5);
  }
  control_.put_tool_in();
  control_.changer = true;
  control_.builder.change_tool(control_.next_tool, false, control_.line);
}

/// A pause is where tools are changed by hand.
void ModeWords::pause(const Block& block) {
  if (block.has_text && !control_.rules.pause_says_text)
    control_.refuse("text behind a pause, which " + std::string(control_.rules.name) +
                    " reads as words; make it a comment");
  control_.tool_put_in = true;
  control_.builder.add_event(ControlEventKind::kPause, control_.line);
  if (control_.changer) return;
  if (control_.tool_said) {
    if (control_.next_tool != control_.builder.drive.tool)
      control_.builder.change_tool(control_.next_tool, true, control_.line);
  } else if (!control_.options.hand_tools.empty()) {
    hand_tool_ = std::min(hand_tool_ + 1, control_.options.hand_tools.size() - 1);
    control_.builder.change_tool(control_.options.hand_tools[hand_tool_], true, control_.line);
  } else if (!control_.rules.changer) {
    control_.condition("tool-by-hand",
                       "the program pauses without naming a tool; the same tool stays in the spindle");
  }
}

/// Flood and mist go on one by one and may both be on; M9 ends both, but for mist that has a word of its own.
void ModeWords::switch_coolant(int m) {
  const DialectRules& rules = control_.rules;
  bool flood = has_flood(control_.modes.coolant), mist = has_mist(control_.modes.coolant);
  if (m == rules.mist_on) {
    mist = true;
    if (!rules.mist_needs.empty())
      control_.condition("m" + m_word(m).substr(1), std::string(rules.mist_needs));
  } else if (m == 70 || m == 80 || m == 130 || m == 140 || m == 880) {
    flood = true;
  }
  if (m == 90 || m == 890) flood = false;
  if (m == rules.mist_off) mist = false;
  control_.modes.coolant = control_.builder.drive.coolant = coolant_of(flood, mist);
}

void ModeWords::set_drive(int m, const Block& block) {
  if (m == 30 || m == 40 || m == 130 || m == 140 || m == 190) control_.builder.say_spindle();
  if (m != 60 && !knows_m(control_.rules, m)) return note_unknown(m);
  switch_coolant(m);
  if (m == 30 || m == 40 || m == 50) return control_.turn_spindle(m / 10);
  if (m == 190) return control_.turn_spindle(5);
  if (m == 130 || m == 140) return turn_spindle_and_flood(m);
  if (m == 0 || m == 10) return pause(block);
  if (m == 970 && control_.rules.macros != MacroLanguage::kNone && !control_.rules.calls_blocks)
    control_.refuse("M97 is a word of Haas's; name --dialect haas");
  if (m == 1980 && control_.rules.macros == MacroLanguage::kFanuc)
    control_.refuse(
        "M198 calls a subprogram from another device, which is not read; put it into the program and call it "
        "by M98");
  if (m == 610 && control_.rules.states_tool) return state_tool(block);
  if (m == 960 || m == 970 || (m == 980 && block.has('P'))) {
    control_.macro("subprogram calls are no words of the control; post the program without them");
  }
  if (m == 990 && block.has('P'))
    control_.macro("M99 P jumps to another block, which the control has no word for; post without it");
  if (m == 290) control_.tied_by_m29 = true;
  if (control_.rules.saves_modes && m >= 700 && m <= 730) return;
  const bool of_user = control_.rules.m.user_words && is_user_word(m);
  if (!of_user && std::find(std::begin(kStillWords), std::end(kStillWords), m) != std::end(kStillWords))
    return;
  const std::string word = m_word(m);
  control_.condition("m" + word.substr(1), word + " is unknown here and moves nothing");
}

/// M61 Q: the tool in the spindle is that one, put in by nobody now.
void ModeWords::state_tool(const Block& block) {
  const double number = block.has('Q') ? block.value('Q') : -1;
  if (!(number >= 0) || number > 1e6 || std::floor(number) != number)
    control_.refuse("M61 without the number of a tool in its Q word; correct it");
  const int tool = static_cast<int>(number);
  if (tool == control_.builder.drive.tool) return;
  control_.next_tool = tool;
  control_.tool_said = true;
  control_.builder.change_tool(tool, true, control_.line);
  control_.condition("m61", "M61 says that the tool in the spindle is T" + std::to_string(tool) +
                                "; it has been put in before this line");
}

/// A word that the control does not have.
void ModeWords::note_unknown(int m) {
  const std::string word = m_word(m);
  control_.condition("m" + word.substr(1),
                     word + " is no word of the control" + std::string(control_.rules.m.at_others));
}

/// Not a word of Fanuc's own, but what most builders give it.
void ModeWords::turn_spindle_and_flood(int m) {
  const std::string word = m_word(m);
  control_.condition("m" + word.substr(1),
                     "what " + word +
                         " does is the machine builder's choice; it turns the spindle and "
                         "switches the coolant on");
  control_.turn_spindle(m / 10 - 10);
}

void ModeWords::end(int m) {
  if (m == 20 || m == 300) control_.ended = true;
  if (m != 990) return;
  control_.ended = true;
  control_.condition("m99", "M99 begins the program again from where it ends; the first run is checked");
}

void ModeWords::dwell(const Block& block) {
  double written = 0;
  bool in_ms = false;
  const DialectRules& rules = control_.rules;
  if (block.has('P')) {
    written = block.value('P');
    in_ms = rules.dwell_in_ms && (!rules.dwell_with_point_in_s || block.is_whole('P'));
  } else if (rules.dwell_by_x && block.has('X')) {
    written = block.value('X');
  } else if (rules.dwell_by_s && block.has('S')) {
    written = block.value('S');
  } else if (!rules.dwell_in_ms) {
    control_.refuse("G4 without its P word, which the control asks for; add the seconds of the dwell");
  }
  if (block.has_axis()) control_.depends_on_dialect = true;
  add_dwell(control_.builder, control_.line, written, in_ms);
}

}  // namespace clearcut::read::gcode
