// Order of execution within a block as in RS274/NGC: modes, feed, speed, tool, spindle, coolant, motion,
// stop.
#include "read/gcode/control/interpreter.h"

#include "read/gcode/control/motion_words.h"
#include "read/gcode/control/stray_words.h"
#include "read/gcode/words/g_words.h"

namespace clearcut::read::gcode {

void Interpreter::execute(const Block& block) {
  control_.line = block.line;
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

}  // namespace clearcut::read::gcode
