// One line of a program with macros, cleaned of blanks and comments, with its words computed, and whether a program
// has such lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "read/gcode/macros/expression.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

/// A line as controls see it: upper case, no blanks, no comments, no block number.
struct CleanLine {
  std::string text;
  std::vector<std::string_view> comments;
  bool is_optional = false;  ///< begins with '/'
  int delete_level = 0;      ///< n of "/n"; 0: none is said
  bool is_percent = false;   ///< begins with '%'
  int number = -1;           ///< N word; -1 without one
};

/// Throws InputError(place, ...) for a comment without its end.
CleanLine cleaned(std::string_view line, const std::string& place);

/// A parameter that a line sets.
struct Assignment {
  std::string name;  ///< "" where it has a number
  int number = 0;
  MacroValue value;
};

/// What takes the parameters that lines set.
class MacroStore : public MacroVariables {
 public:
  virtual void assign(const Assignment& assignment) = 0;
};

/// Arguments of a macro's call: every word in the order of the line, also those that stand there twice.
struct ArgumentWord {
  char letter = 'A';
  double value = 0;
};

/// Computes the words of `line` from `at` on. LinuxCNC sets parameters behind the line's last word, others at once. Vacant
/// values leave their word out. `words`: all of them besides, where wanted; then the block takes no word twice, and says nothing.
void compute_words(const CleanLine& line, std::size_t at, MacroStyle style, MacroStore& store,
                   const std::string& place, Block& block, std::vector<ArgumentWord>* words = nullptr);

/// Line of the first parameter, expression, jump, loop or call of a subprogram in a word-address program; 0: it has none.
int first_macro_line(std::string_view text);

}  // namespace clearcut::read::gcode
