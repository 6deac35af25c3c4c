// What each block does to a word-address control, and the words at which LinuxCNC and Grbl stop, since no other word
// of their block uses them.
#pragma once

#include "read/gcode/control/control.h"
#include "read/gcode/control/mode_words.h"

namespace clearcut::read::gcode {

class Interpreter {
 public:
  /// Keeps references to all three.
  Interpreter(ToolpathBuilder& builder, const DialectRules& rules, const ReadControllerOptions& options)
      : control_(builder, rules, options) {}
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  /// Throws InputError for words no control takes together and for words that cannot be understood.
  void execute(const Block& block);
  /// An end word was seen; what follows is not part of the program.
  bool ended() const { return control_.ended; }
  /// Something was read that other controls read otherwise.
  bool depends_on_dialect() const { return control_.depends_on_dialect; }
  Control& control() { return control_; }
  ModeWords& mode_words() { return mode_words_; }
  void note_block_delete();

 private:
  void execute_shared(const Block& block);
  void check(const Block& block) const;

  Control control_;
  ModeWords mode_words_{control_};
};

/// Called before the block is executed. What such a control stops at becomes the condition `stray-word`: a word lost its G word, or
/// a G word its axes.
void note_stray_words(Control& control, const Block& block);

}  // namespace clearcut::read::gcode
