// Order of execution within a block as in RS274/NGC: modes, feed, speed, tool, spindle, coolant, motion,
// stop.
#include "read/gcode/interpreter.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text/format.h"
#include "read/gcode/words/g_words.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kMmPerInch = 25.4;
/// M words in tenths that move nothing on a three-axis mill: stops, spindle, coolant, overrides, clamps, doors, chips,
/// signals.
constexpr int kStillWords[] = {0,   10,  20,  30,  40,  50,  60,  70,  80,  90,  100,  110, 130,
                               140, 190, 290, 300, 310, 330, 480, 490, 500, 510, 520,  530, 620,
                               630, 640, 650, 830, 840, 880, 890, 970, 980, 990, 1170, 1180};

}  // namespace

Interpreter::Interpreter(ToolpathBuilder& builder, const DialectRules& rules,
                         const ReadControllerOptions& options)
    : builder_(builder),
      rules_(rules),
      options_(options),
      frame_(options.places ? std::optional(options.places->origins) : std::nullopt) {
  modes_.return_to_level = !rules.returns_to_r;
  if (!rules.path_words) modes_.path.mode = PathMode::kExactPath;
  builder_.path_control = modes_.path;
  if (!options.hand_tools.empty()) builder_.drive.tool = options.hand_tools.front();
  if (!options.places) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    builder_.place_at(axis, options.places->start[axis] - frame_.machine_zero(axis));
  }
}

void Interpreter::refuse(const std::string& what) const {
  throw InputError(builder_.place(line_), what);
}

void Interpreter::execute(const Block& block) {
  line_ = block.line;
  if (block.optional) condition("block-delete", "blocks marked '/' are executed; block delete is off");
  check(block);
  for (const int m : block.m) {
    if (m >= 700 && m <= 730) save_or_restore(m);
  }
  const bool keeps_unit = rules_.dialect == Dialect::kLinuxCnc && units_said_;
  const double unit_before = modes_.unit;
  set_modes(block);
  set_feed_and_drive(block, keeps_unit ? unit_before : modes_.unit);
  if (has_g(block, 40)) dwell(block);
  move(block);
  for (const int m : block.m) end(m);
}

void Interpreter::check(const Block& block) const {
  std::uint32_t seen = 0;
  for (const int code : block.g) {
    const Group group = group_of(code);
    if (group != Group::kUnknown && !knows_g(rules_, code)) {
      refuse(g_word(code) + " is no word of " + std::string(name_of(rules_.dialect)) +
             "; post the program for this control, or name another");
    }
    if (!is_modal(group)) continue;
    const std::uint32_t bit = 1U << static_cast<unsigned>(group);
    if (seen & bit) refuse(g_word(code) + " contradicts another G word of its block; split the block");
    seen |= bit;
  }
  for (const char letter : {'A', 'B', 'C', 'U', 'V', 'W'}) {
    if (block.has(letter) && block.value(letter) != 0) {
      refuse(std::string("axis word ") + letter + "; only the three axes X, Y, Z are read");
    }
  }
}

void Interpreter::set_modes(const Block& block) {
  for (const int code : block.g) set_mode(code, block);
}

void Interpreter::use_units(double unit) {
  if (cycle_.code != 0 && unit != modes_.unit) {
    if (!rules_.rereads_cycle_numbers)
      refuse("units change within a drilling cycle; end it by G80 before G20 or G21");
    cycle_.scale(unit / modes_.unit);
  }
  modes_.unit = unit;
  units_said_ = true;
}

void Interpreter::set_mode(int code, const Block& block) {
  switch (code) {
    case 170:
    case 180:
    case 190:
      modes_.plane = code == 170 ? Plane::kXY : code == 180 ? Plane::kZX : Plane::kYZ;
      plane_said_ = true;
      break;
    case 200:
    case 210:
      use_units(code == 200 ? kMmPerInch : 1);
      break;
    case 900:
    case 910:
      modes_.absolute = code == 900;
      distance_said_ = true;
      break;
    case 901:
    case 911:
      modes_.absolute_centers = code == 901;
      centers_said_ = true;
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
      modes_.return_to_level = code == 980;
      return_said_ = true;
      break;
    default:
      set_other(code, block);
  }
}

/// Words that leave the path alone pass; those that would change it in ways not understood are refused.
void Interpreter::set_other(int code, const Block& block) {
  const Group group = group_of(code);
  if (group == Group::kOffset) {
    use_system(code, block);
  } else if (group == Group::kCompensation) {
    refuse(g_word(code) +
           " cutter radius compensation is not read; post the path of the tool's centre (G40)");
  } else if (code == 430 || code == 431 || code == 490) {
    set_length(code, block);
  } else if (code == 610 || code == 611 || code == 640 || code == 1870) {
    set_path(code, block);
  } else if (code == 51) {
    condition("blending",
              "G5.1 lets the control smooth the path within a bound of its own; the exact path is judged");
  } else if (group == Group::kUnknown) {
    refuse(g_word(code) + " is not read; post the program without it");
  }
}

void Interpreter::set_path(int code, const Block& block) {
  PathControl path;
  const bool fanuc_like = rules_.home_is_top;
  if (code == 610) {
    path.mode = fanuc_like ? PathMode::kExactStop : PathMode::kExactPath;
  } else if (code == 611) {
    path.mode = PathMode::kExactStop;
  } else if (code == 640) {
    const bool bounded = block.has('P') && rules_.dialect == Dialect::kLinuxCnc;
    path.mode = bounded ? PathMode::kTolerance : PathMode::kContinuous;
    if (bounded) path.tolerance_mm = mm(block.value('P'));
    if (bounded && block.has('Q')) path.merging_mm = mm(block.value('Q'));
  } else if (block.has('E')) {
    path.mode = PathMode::kTolerance;
    path.tolerance_mm = mm(block.value('E'));
  } else {
    path.mode = PathMode::kSmoothness;
  }
  modes_.path = builder_.path_control = path;
}

/// A feed of one kind means nothing in another.
void Interpreter::set_feed_mode(FeedMode mode) {
  if (mode != modes_.feed_mode) modes_.feed = 0;
  modes_.feed_mode = mode;
}

void Interpreter::save_or_restore(int m) {
  if (!rules_.saves_modes) return;
  modes_.system = frame_.system();
  if (m == 700 || m == 730) saved_ = modes_;
  if (m == 710) saved_.reset();
  if (m != 720) return;
  if (!saved_) refuse("M72 brings back modes that no M70 has kept; correct it");
  const ToolLength length = modes_.length;
  modes_ = *saved_;
  modes_.length = length;
  frame_.use_system(modes_.system);
  set_spindle(modes_.spindle);
  builder_.drive.coolant = modes_.coolant;
  builder_.path_control = modes_.path;
}

void Interpreter::set_feed_and_drive(const Block& block, double feed_unit) {
  if (block.has('F')) {
    if (block.value('F') < 0) refuse("F word below zero; correct it");
    modes_.feed = block.value('F') * (modes_.feed_mode == FeedMode::kInverseTime ? 1 : feed_unit);
  }
  const bool seconds = has_g(block, 40) && rules_.dwell_by_s;
  if (block.has('S') && !seconds) modes_.speed = std::abs(block.value('S'));
  if (block.has('T')) select_tool(block);
  for (const int m : block.m) set_drive(m, block);
  const bool turning = modes_.spindle != 5;
  builder_.drive.spindle_rpm = turning ? modes_.speed : 0;
  builder_.speed = modes_.speed;
}

/// Without a tool so far it is in the spindle already; otherwise it waits for M6 or a pause.
void Interpreter::select_tool(const Block& block) {
  if (block.value('T') < 0 || block.value('T') > 1e6) refuse("T word with an impossible tool; correct it");
  next_tool_ = static_cast<int>(block.value('T'));
  if (builder_.drive.tool == 0 || !tool_said_) builder_.drive.tool = next_tool_;
  tool_said_ = true;
}

void Interpreter::load_tool() {
  if (!rules_.changer)
    condition("m6", "M6 is no word of the control; what sends the program changes the tool");
  changer_ = true;
  builder_.change_tool(next_tool_, false, line_);
}

/// A pause is where tools are changed by hand.
void Interpreter::pause() {
  builder_.add_event(ControlEventKind::kPause, line_);
  if (changer_) return;
  if (tool_said_) {
    if (next_tool_ != builder_.drive.tool) builder_.change_tool(next_tool_, true, line_);
  } else if (!options_.hand_tools.empty()) {
    hand_tool_ = std::min(hand_tool_ + 1, options_.hand_tools.size() - 1);
    builder_.change_tool(options_.hand_tools[hand_tool_], true, line_);
  } else if (!rules_.changer) {
    condition("tool-by-hand", "the program pauses without naming a tool; the same tool stays in the spindle");
  }
}

void Interpreter::set_spindle(int m) {
  modes_.spindle = m;
  builder_.set_spindle(m, line_);
}

void Interpreter::set_drive(int m, const Block& block) {
  const bool switches_coolant = m == 70 || m == 80 || m == 90 || m == 130 || m == 140 || m == 880 || m == 890;
  if (switches_coolant) modes_.coolant = builder_.drive.coolant = m != 90 && m != 890;
  if (m == 30 || m == 40 || m == 50) return set_spindle(m / 10);
  if (m == 130 || m == 140) return set_spindle(m / 10 - 10);
  if (m == 60) return load_tool();
  if (m == 0 || m == 10) return pause();
  if (m == 960 || m == 970 || (m == 980 && block.has('P'))) {
    refuse("subprogram calls are not read; post the program without them");
  }
  if (m == 990 && block.has('P')) refuse("M99 P jumps to another block; post the program without it");
  if (rules_.saves_modes && m >= 700 && m <= 730) return;
  if (std::find(std::begin(kStillWords), std::end(kStillWords), m) != std::end(kStillWords)) return;
  condition("m" + trimmed(m / 10.0, 1), "M" + trimmed(m / 10.0, 1) + " is unknown here and moves nothing");
}

void Interpreter::end(int m) {
  if (m == 20 || m == 300) ended_ = true;
  if (m != 990) return;
  ended_ = true;
  condition("m99", "M99 begins the program again from where it ends; the first run is judged");
}

void Interpreter::dwell(const Block& block) {
  double seconds = 0;
  if (block.has('P')) {
    const bool ms = rules_.dwell_in_ms && (rules_.dialect != Dialect::kHaas || block.is_whole('P'));
    seconds = block.value('P') * (ms ? 0.001 : 1);
  } else if (rules_.dwell_by_x && block.has('X')) {
    seconds = block.value('X');
  } else if (rules_.dwell_by_s && block.has('S')) {
    seconds = block.value('S');
  }
  if (block.has_axis()) depends_on_dialect_ = true;
  builder_.add_event(ControlEventKind::kDwell, line_, seconds);
}

}  // namespace clearcut::read::gcode
