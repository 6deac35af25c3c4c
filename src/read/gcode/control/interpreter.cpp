// Order of execution within a block as in RS274/NGC: modes, feed, speed, tool, spindle, coolant, motion,
// stop.
#include "read/gcode/control/interpreter.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/text.h"
#include "read/gcode/control/motion_words.h"
#include "read/gcode/control/osp_words.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

void Interpreter::execute(const Block& block) {
  control_.line = block.line;
  if (control_.rules.osp_words) return execute_shared(without_osp_words(block, control_));
  if (block.names_program)
    control_.refuse("a name of letters behind O is a word of Okuma's OSP alone; give the program a number");
  execute_shared(block);
}

/// Words that mean the same on all word-address controls.
void Interpreter::execute_shared(const Block& block) {
  if (block.optional) note_block_delete();
  if (block.delete_level > 0 && control_.rules.macros != MacroLanguage::kFanuc)
    control_.refuse("'/" + std::to_string(block.delete_level) +
                    "' names a switch of Fanuc's and Haas's; write '/' alone");
  check(block);
  note_stray_words(control_, block);
  for (const int m : block.m) {
    if (m >= 700 && m <= 730) mode_words_.save_or_restore(m);
  }
  const bool keeps_unit = control_.rules.feed_in_unit_before && control_.units_said;
  const double unit_before = control_.modes.unit;
  mode_words_.set_modes(block);
  mode_words_.set_feed_and_drive(block, keeps_unit ? unit_before : control_.modes.unit);
  if (has_g(block, 40)) mode_words_.dwell(block);
  if (block.is_polar())
    MotionWords(control_).move(control_.without_polar_words(block));
  else
    MotionWords(control_).move(block);
  for (const int m : block.m) mode_words_.end(m);
}

void Interpreter::note_block_delete() {
  control_.condition("block-delete", "blocks marked '/' are executed; block delete is off");
}

void Interpreter::check(const Block& block) const {
  for (const int code : block.g) {
    if (code == 650 || code == 660)
      control_.macro(g_word(code) +
                     " calls a macro, which the control has no word for; post the program without it");
  }
  std::uint32_t seen = 0;
  for (const int code : block.g) {
    const Group group = group_of(code);
    if (group != Group::kUnknown && !knows_g(control_.rules, code)) {
      control_.refuse(g_word(code) + " is no word of " + std::string(control_.rules.name) +
                      "; post the program for this control, or name another");
    }
    if (!is_modal(group)) continue;
    const std::uint32_t bit = 1U << static_cast<unsigned>(group);
    if (seen & bit)
      control_.refuse(g_word(code) + " contradicts another G word of its block; split the block");
    seen |= bit;
  }
  for (const char letter : {'A', 'B', 'C', 'U', 'V', 'W'}) {
    if (block.has(letter) && block.value(letter) != 0) {
      control_.refuse(std::string("axis word ") + letter + "; only the three axes X, Y, Z are read");
    }
  }
}

namespace {

using Codes = std::vector<int>;

bool any_of(const Codes& said, const Codes& wanted) {
  return std::any_of(said.begin(), said.end(),
                     [&](int code) { return std::find(wanted.begin(), wanted.end(), code) != wanted.end(); });
}

bool is_arc(int motion) {
  return motion == 20 || motion == 30;
}

/// LinuxCNC's own words of the user, M100 to M199, may use any.
bool has_user_word(const Block& block) {
  return std::any_of(block.m.begin(), block.m.end(), is_user_word);
}

bool is_used_by_motion(char letter, int motion) {
  switch (letter) {
    case 'I':
    case 'J':
      return is_arc(motion);
    case 'K':
      return is_arc(motion) || motion == 330 || motion == 331;
    case 'R':
      return is_arc(motion) || is_drill_cycle(motion) || motion == 870 || motion == 880;
    case 'P':
      return is_arc(motion) || motion == 820 || motion == 860 || motion == 880 || motion == 890;
    case 'Q':
      return motion == 730 || motion == 830;
    case 'L':
      return is_drill_cycle(motion) || motion == 870 || motion == 880;
    default:
      return false;
  }
}

bool is_used_on_linuxcnc(char letter, const Block& block, int motion) {
  if (has_user_word(block) || any_of(block.g, {50, 51, 52, 760}) || is_used_by_motion(letter, motion))
    return true;
  switch (letter) {
    case 'D':
      return any_of(block.g, {410, 411, 420, 421, 700, 710, 960});
    case 'E':
      return any_of(block.g, {700}) || any_of(block.m, {660, 670, 680});
    case 'H':
      return any_of(block.g, {430, 432});
    case 'L':
      return any_of(block.g, {100}) || any_of(block.m, {660, 980});
    case 'P':
      return any_of(block.g, {40, 100, 640, 700, 710}) ||
             any_of(block.m, {190, 500, 510, 520, 530, 620, 630, 640, 650, 660, 980});
    case 'Q':
      return any_of(block.g, {100, 640, 700, 710}) || any_of(block.m, {190, 610, 660, 670, 680});
    case 'R':
      return any_of(block.g, {100, 700, 710}) || any_of(block.m, {190});
    default:
      return any_of(block.g, {100, 700, 710});
  }
}

bool is_used_on_grbl(char letter, const Block& block, int motion) {
  if (letter == 'P') return any_of(block.g, {40, 100}) || any_of(block.m, {560});
  if (letter == 'L') return any_of(block.g, {100});
  return letter != 'Q' && is_used_by_motion(letter, motion);
}

bool is_used_on_grblhal(char letter, const Block& block, int motion) {
  if (is_used_on_grbl(letter, block, motion) || is_used_by_motion(letter, motion)) return true;
  switch (letter) {
    case 'H':
      return any_of(block.g, {430, 432});
    case 'P':
      return any_of(block.m, {480, 490, 500, 510, 530, 620, 630, 640, 650});
    case 'Q':
      return any_of(block.m, {610});
    case 'R':
      return any_of(block.g, {100});
    default:
      return false;
  }
}

/// M words of which LinuxCNC takes one in a block, and how many of any kind.
const std::vector<Codes>& groups_of_m() {
  static const std::vector<Codes> groups{
      {0, 10, 20, 300, 600}, {30, 40, 50, 190, 700, 710, 720, 730}, {60, 610},
      {70, 80, 90},          {480, 490, 500, 510, 520, 530},        {620, 630, 640, 650, 660, 670, 680}};
  return groups;
}
constexpr std::size_t kMostMWords = 4;

/// G words of which LinuxCNC takes one in a block, beside the modal groups that hold for all controls.
const std::vector<Codes>& groups_of_g() {
  static const std::vector<Codes> groups{
      {40, 100, 280, 281, 300, 301, 520, 530, 920, 921, 922, 923}, {430, 431, 432, 490}, {610, 611, 640}};
  return groups;
}

bool has_two_of_one(const std::vector<Codes>& groups, const Codes& said) {
  return std::any_of(groups.begin(), groups.end(), [&](const Codes& group) {
    return std::count_if(said.begin(), said.end(), [&](int code) {
             return std::find(group.begin(), group.end(), code) != group.end();
           }) > 1;
  });
}

/// The G word that the control does not take without a place or a distance, "" if there is none.
std::string word_without_axes(const Block& block, int said, bool is_grbl) {
  if (block.has_axis() || block.is_polar()) return "";
  const bool has_center = block.has('I') || block.has('J') || block.has('K') || block.has('R');
  if (is_arc(said) && !has_center) return g_word(said);
  for (const int code : {382, 383, 384, 385, 920})
    if (has_g(block, code)) return g_word(code);
  if (is_grbl) return "";
  if (is_drill_cycle(said)) return g_word(said);
  for (const int code : {330, 331, 520, 760, 870, 880})
    if (has_g(block, code)) return g_word(code);
  if (has_g(block, 530) && said != 0 && said != 10) return g_word(530);
  return "";
}

/// What the control stops at, "" if it takes the block.
std::string stray_word(const Control& control, const Block& block) {
  const int said = motion_in(block), motion = said >= 0 ? said : control.motion;
  const StrayWords stray = control.rules.stray_words;
  const bool is_grbl = stray == StrayWords::kGrbl || stray == StrayWords::kGrblHal;
  for (const char letter : std::string_view("DEHIJKLPQR")) {
    const bool used = stray == StrayWords::kGrbl      ? is_used_on_grbl(letter, block, motion)
                      : stray == StrayWords::kGrblHal ? is_used_on_grblhal(letter, block, motion)
                                                      : is_used_on_linuxcnc(letter, block, motion);
    if (block.has(letter) && !used) return std::string(1, letter) + " word, which no word of its block uses";
  }
  const std::string word = word_without_axes(block, said, is_grbl);
  if (!word.empty()) return word + " without axis words";
  if (is_grbl) return "";
  if (any_of(block.m, {620, 630, 640, 650}) && !block.has('P'))
    return "a word of an output without its P word";
  if (has_two_of_one(groups_of_m(), block.m)) return "two M words of one kind in a block";
  if (block.m.size() > kMostMWords) return "more than four M words in a block";
  if (has_two_of_one(groups_of_g(), block.g)) return "two G words of one kind in a block";
  const bool has_feed =
      control.modes.feed > 0 || block.has('F') || control.modes.feed_mode == FeedMode::kInverseTime;
  if (said == 10 && !has_feed && !has_g(block, 930) && !has_g(block, 530)) return "G1 before any feed";
  if (is_arc(said) && has_g(block, 40)) return "G4 beside an arc, which takes its P as turns";
  return "";
}

/// R without its comma, and Q, beside the places of lines.
void note_words_beside_lines(Control& control, const Block& block) {
  const int said = motion_in(block), motion = said >= 0 ? said : control.motion;
  if ((motion != 0 && motion != 10) || !block.has_axis()) return;
  const bool uses_words_otherwise = std::any_of(block.g.begin(), block.g.end(), [](int code) {
    return group_of(code) == Group::kOnce || group_of(code) == Group::kUnknown || code == 51;
  });
  if (uses_words_otherwise) return;
  for (const char letter : {'R', 'Q'})
    if (block.has(letter))
      control.condition("stray-word",
                        std::string(1, letter) +
                            " stands beside a line, where the control does nothing with it; it is "
                            "no rounding of the corner whose comma is missing");
}

}  // namespace

void note_stray_words(Control& control, const Block& block) {
  if (control.rules.stray_words == StrayWords::kIgnored) return;
  if (control.rules.stray_words == StrayWords::kCorners) return note_words_beside_lines(control, block);
  const std::string stray = stray_word(control, block);
  if (stray.empty()) return;
  control.condition("stray-word", std::string(control.rules.title) + " stops at " + stray +
                                      "; something is missing there, or too much");
}

}  // namespace clearcut::read::gcode
