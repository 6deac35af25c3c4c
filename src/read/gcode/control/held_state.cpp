#include "read/gcode/control/held_state.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/text.h"
#include "read/gcode/control/interpreter.h"
#include "read/gcode/words/block.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {

namespace {

/// mm; places that a program writes with all of its digits agree to this.
constexpr double kSameHeldPlace = 1e-4;
/// Share by which a feed or a speed may differ after it was written with six digits.
constexpr double kSameHeldValue = 1e-6;

struct HindranceText {
  Hindrance hindrance;
  const char* text;
};
constexpr HindranceText kHindranceTexts[] = {
    {Hindrance::kNone, ""},
    {Hindrance::kCycle, "within a drilling or tapping cycle"},
    {Hindrance::kArcs, "among arcs whose word stands in a line before"},
    {Hindrance::kUnplaced, "before the program has stated where the cutter is"},
    {Hindrance::kCompensation, "under cutter radius compensation"},
    {Hindrance::kMap,
     "while places are shifted, turned, mirrored or polar (G68, G51.1, G16, TRANS, ROT, cycles 7 and 10)"},
    {Hindrance::kShift, "while the zero is where the cutter stood when it was set (G92, G10)"},
    {Hindrance::kAddedLength, "while a length is added to the tool's (G43.2)"},
    {Hindrance::kSavedModes, "while modes are kept for later (M70)"},
    {Hindrance::kOldLength, "between a change of tools and the word for the new length (G43)"},
    {Hindrance::kCorner,
     "where it goes on from the move before (a corner that is rounded or chamfered, CT, APPR, DEP)"},
    {Hindrance::kDefinition, "within the definition of a cycle"},
    {Hindrance::kMacro, "after lines that compute or call subprograms"}};

/// A word of coolant as it is written: "M8".
std::string m_text(int tenths) {
  return "M" + trimmed(tenths / 10.0, 1);
}

/// The G word with those of the letters that the block has: "G64 P0.01".
std::string with_letters(const Block& block, int code, std::string_view letters) {
  std::string text = g_word(code);
  for (const char letter : letters)
    if (block.has(letter)) text += std::string(" ") + letter + trimmed(block.value(letter), 6);
  return text;
}

/// As controls that take whole numbers as increments want it.
std::string with_point(const std::string& words) {
  return words.find('.') == std::string::npos ? words + "." : words;
}

bool is_coolant_on(int m, const DialectRules& rules) {
  return m == 70 || m == 80 || m == 880 || m == rules.mist_on;
}

/// Whether the axis words of the block are places that a motion word leads to.
bool has_places(const Block& block, int motion) {
  const bool arcs = motion == 20 || motion == 30;
  const bool arc_words = block.has('I') || block.has('J') || block.has('K') || block.has('R');
  if (!block.has_axis() && !block.is_polar() && !(arcs && arc_words)) return false;
  return std::none_of(block.g.begin(), block.g.end(), [](int code) {
    return code == 40 || (group_of(code) == Group::kOnce && code != 280 && code != 300);
  });
}

/// Follows a program and keeps what its words leave behind.
class Follower {
 public:
  Follower(std::string_view text, const std::string& file_name, const ReadControllerOptions& options)
      : rules_(rules_of(*options.dialect)),
        builder_({file_name, options.home_z, options.safe_z}, diagnostics_, conditions_),
        interpreter_(builder_, rules_, options),
        reader_(text, file_name) {}

  StopScan run(int line) {
    StopScan scan;
    try {
      follow(line, scan);
    } catch (const MacroError&) {
      scan.macro_line = block_.line;
      if (scan.blocks.empty() || scan.blocks.back().line != block_.line)
        scan.blocks.push_back({.line = block_.line});
    }
    settle_motion_words(needs_, scan);
    return scan;
  }

 private:
  void follow(int line, StopScan& scan) {
    TapeMarks marks;
    while (!interpreter_.ended() && reader_.next(block_)) {
      if (marks.ends(block_.percent, block_.has_words())) return;
      if (!block_.has_words()) continue;
      const StopBlock stop = now();
      needs_.push_back(need_of(stop));
      add_stop(
          stop, line, [this] { return held(); }, scan);
      execute();
    }
  }

  StopBlock now() {
    Control& control = interpreter_.control();
    StopBlock stop;
    stop.line = block_.line;
    const bool is_level = rules_.osp_words && has_g(block_, 710);
    stop.moves = !is_level && has_places(block_, said_or(control.motion));
    stop.changes_tool = std::find(block_.m.begin(), block_.m.end(), 60) != block_.m.end();
    const Target& at = builder_.position();
    stop.is_placed = at[0] && at[1] && at[2];
    stop.z = at[2].value_or(0);
    stop.tool = builder_.drive.tool;
    stop.hindrance = hindrance();
    return stop;
  }

  int said_or(int motion) const {
    const int said = motion_in(block_);
    return said >= 0 ? said : motion;
  }

  Hindrance hindrance() {
    const Control& control = interpreter_.control();
    if (compensates_) return Hindrance::kCompensation;
    if (builder_.waits_at_corner()) return Hindrance::kCorner;
    if (control.plan_map.is_on || control.polar_mode) return Hindrance::kMap;
    if (control.adds_length) return Hindrance::kAddedLength;
    if (zero_moved_) return Hindrance::kShift;
    if (keeps_modes_) return Hindrance::kSavedModes;
    return old_length_ ? Hindrance::kOldLength : Hindrance::kNone;
  }

  MotionNeed need_of(const StopBlock& stop) {
    if (motion_in(block_) >= 0) return MotionNeed::kNothing;
    if (!stop.moves) return MotionNeed::kPasses;
    const int motion = interpreter_.control().motion;
    if (motion == 0 || motion == 10) return stop.is_placed ? MotionNeed::kNothing : MotionNeed::kStraight;
    return motion == 20 || motion == 30 ? MotionNeed::kArcs : MotionNeed::kCycle;
  }

  void execute() {
    Control& control = interpreter_.control();
    const Coolant coolant = control.modes.coolant;
    const int tool = builder_.drive.tool;
    interpreter_.execute(block_);
    if (builder_.drive.tool != tool) old_length_ = control.modes.length.kind == LengthKind::kNumbered;
    for (const int code : block_.g)
      if (!rules_.osp_words || !keep_osp(code)) keep(code);
    for (const int m : block_.m) keep_m(m);
    keep_coolant(coolant);
  }

  void keep(int code) {
    const Control& control = interpreter_.control();
    HeldWords& words = words_;
    switch (group_of(code)) {
      case Group::kPlane:
        words.plane = g_word(code);
        break;
      case Group::kUnits:
        words.units = g_word(code);
        break;
      case Group::kDistance:
        words.distance = g_word(code);
        break;
      case Group::kCenters:
        words.centers = g_word(code);
        break;
      case Group::kFeedMode:
        words.feed_mode = g_word(code);
        break;
      case Group::kReturn:
        words.level = g_word(code);
        break;
      case Group::kOffset:
        words.offset = with_letters(block_, code, "P");
        break;
      case Group::kCompensation:
        compensates_ = true;
        break;
      case Group::kOnce:
        keep_once(code);
        break;
      default:
        if (code == 700 || code == 710) words.units = g_word(code);
        if (code == 610 || code == 611) words.path = g_word(code);
        if (code == 640) words.path = with_letters(block_, code, "PQ");
        if (code == 1870) words.path = with_letters(block_, code, "PE");
        if (code == 51) words.smoothing = with_letters(block_, code, "QPR");
        if (code == 430 || code == 431 || code == 490) old_length_ = false;
        if (code == 800) words.cycle_end = g_word(code);
        if (code == 400) {
          compensates_ = false;
          words.compensation = g_word(code);
        }
        if (code == 530) keep_home(code, control.modes.absolute);
    }
  }

  /// Whether the word is one of OSP's, which says something else on other controls.
  bool keep_osp(int code) {
    if (code == kOkumaOffset) words_.offset = with_letters(block_, code, "H");
    if (code == 560) old_length_ = false;
    if (code == 710) words_.ways = {with_point(with_letters(block_, code, "Z"))};
    return code == kOkumaOffset || code == 160 || code == 530 || code == 560 || code == 710;
  }

  void keep_once(int code) {
    const Control& control = interpreter_.control();
    if (code == 280 || code == 300) keep_home(code, control.modes.absolute);
    if (code == 920 || code == 923) zero_moved_ = true;
    if (code == 921 || code == 922) zero_moved_ = false;
    if (code == 520) words_.local_shift = true;
    if (code != 100) return;
    const bool writes_offset = block_.has('L') && block_.value('L') == 2 && control.modes.absolute &&
                               !block_.has('R') && block_.m.empty();
    if (!writes_offset) {
      zero_moved_ = true;
      return;
    }
    words_.zeros.push_back(with_letters(block_, code, "LPXYZ"));
  }

  /// Only straight up: by G28 in G91, and by G53 to a height.
  void keep_home(int code, bool absolute) {
    if (!block_.has('Z') || block_.has('X') || block_.has('Y')) return;
    if (code == 530)
      words_.home = "G0 " + with_letters(block_, code, "Z");
    else if (!absolute && block_.value('Z') == 0)
      words_.home = "G91 " + with_letters(block_, code, "Z");
  }

  void keep_m(int m) {
    if (!rules_.saves_modes) return;
    if (m == 700 || m == 730) keeps_modes_ = true;
    if (m == 710 || m == 720) keeps_modes_ = false;
  }

  void keep_coolant(Coolant before) {
    const Coolant now = interpreter_.control().modes.coolant;
    if (now == Coolant::kOff) words_.coolant.clear();
    if (now == before || now == Coolant::kOff) return;
    const bool goes_down = before == Coolant::kBoth;
    if (goes_down) {
      const bool mist = has_mist(now);
      std::erase_if(words_.coolant,
                    [&](const std::string& word) { return (word == m_text(rules_.mist_on)) != mist; });
      return;
    }
    for (const int m : block_.m) {
      if (is_coolant_on(m, rules_)) words_.coolant.push_back(m_text(m));
      if (m == 130 || m == 140) words_.coolant.push_back(m_text(80));
    }
  }

  HeldState held() {
    Control& control = interpreter_.control();
    HeldState state;
    state.modes = control.modes;
    state.modes.system = control.frame.system();
    state.motion = control.motion;
    state.tool = builder_.drive.tool;
    state.next_tool = control.next_tool;
    state.tool_said = control.tool_said;
    state.changer = control.changer;
    state.position = builder_.position();
    for (std::size_t axis = 0; axis < 3; ++axis) state.shift[axis] = control.frame.shift(axis);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Frame without = control.frame;
      without.clear_local(false);
      state.local[axis] = state.shift[axis] - without.shift(axis);
    }
    state.at_home = builder_.at_home_height();
    state.spindle_wait = wait_behind_spindle(builder_.events());
    state.words = words_;
    return state;
  }

  const DialectRules& rules_;
  Diagnostics diagnostics_;
  std::vector<Condition> conditions_;
  ToolpathBuilder builder_;
  Interpreter interpreter_;
  BlockReader reader_;
  Block block_;
  std::vector<MotionNeed> needs_;
  HeldWords words_;
  bool old_length_ = false;
  bool compensates_ = false, zero_moved_ = false, keeps_modes_ = false;
};

bool same_value(double a, double b) {
  return std::abs(a - b) <= kSameHeldValue * std::max(std::abs(a), std::abs(b));
}

bool same_place(const Target& a, const Target& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (a[axis] && b[axis] && std::abs(*a[axis] - *b[axis]) > kSameHeldPlace) return false;
  return true;
}

/// The tool's own length is that of the tool in the spindle, whichever was there when the word came.
bool same_length(const ToolLength& a, const ToolLength& b) {
  return a == b || (a.kind == LengthKind::kOfTool && b.kind == LengthKind::kOfTool);
}

bool same_shift(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double one, double other) { return std::abs(one - other) <= kSameHeldPlace; });
}

bool same_pole(const std::optional<Vec2>& a, const std::optional<Vec2>& b) {
  return !a || (b && distance(*a, *b) <= kSameHeldPlace);
}

}  // namespace

const char* text_of(Hindrance hindrance) {
  return kHindranceTexts[static_cast<std::size_t>(hindrance)].text;
}

void settle_motion_words(const std::vector<MotionNeed>& needs, StopScan& scan) {
  MotionNeed need = MotionNeed::kNothing;
  for (std::size_t i = needs.size(); i-- > 0;) {
    if (needs[i] != MotionNeed::kPasses) need = needs[i];
    Hindrance& found = scan.blocks[i].hindrance;
    if (found != Hindrance::kNone) continue;
    if (need == MotionNeed::kCycle) found = Hindrance::kCycle;
    if (need == MotionNeed::kArcs) found = Hindrance::kArcs;
    if (need == MotionNeed::kStraight) found = Hindrance::kUnplaced;
  }
}

void keep_coolant(Coolant before, Coolant now, HeldWords& words) {
  if (before == now) return;
  words.coolant.clear();
  if (has_flood(now)) words.coolant.emplace_back("M8");
  if (has_mist(now)) words.coolant.emplace_back("M7");
}

double wait_behind_spindle(const std::vector<ControlEvent>& events) {
  const auto start = std::find_if(events.rbegin(), events.rend(), [](const ControlEvent& event) {
    return event.kind == ControlEventKind::kSpindleStart;
  });
  if (start == events.rend()) return 0;
  double seconds = 0;
  for (auto event = start.base(); event != events.end(); ++event)
    if (event->kind == ControlEventKind::kDwell && event->before_move == start->before_move)
      seconds += event->seconds;
  return seconds;
}

std::string difference(const HeldState& a, const HeldState& b) {
  const Modes &m = a.modes, &n = b.modes;
  const bool feed_holds = m.feed_mode != FeedMode::kInverseTime && m.feed > 0;
  const struct {
    const char* name;
    bool same;
  } rows[] = {{"units", m.unit == n.unit},
              {"G90 or G91", m.absolute == n.absolute},
              {"arc centres", m.absolute_centers == n.absolute_centers},
              {"G98 or G99", m.return_to_level == n.return_to_level},
              {"plane", m.plane == n.plane},
              {"feed mode", m.feed_mode == n.feed_mode},
              {"feed", !feed_holds || same_value(m.feed, n.feed)},
              {"speed", same_value(m.speed, n.speed)},
              {"spindle", m.spindle == n.spindle},
              {"coolant", m.coolant == n.coolant},
              {"work offset", m.system == n.system},
              {"zero", same_shift(a.shift, b.shift)},
              {"tool length", same_length(m.length, n.length)},
              {"path control", m.path == n.path},
              {"tool", a.tool == b.tool},
              {"next tool", a.next_tool == b.next_tool},
              {"call of the tool", a.words.tool_calls == b.words.tool_calls},
              {"cycle", a.words.cycle == b.words.cycle},
              {"pole", same_pole(a.pole, b.pole)},
              {"place", same_place(a.position, b.position)}};
  for (const auto& row : rows)
    if (!row.same) return row.name;
  return "";
}

StopScan scan_stops(std::string_view text, const std::string& file_name, const ReadControllerOptions& options,
                    int line) {
  return Follower(text, file_name, options).run(line);
}

}  // namespace clearcut::read::gcode
