// LinuxCNC's O words: which line belongs to which.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "read/gcode/macros/macro_run.h"

namespace clearcut::read::gcode {

enum class OKeyword : unsigned char {
  kProgram,  ///< no keyword: where M98 goes
  kSub,
  kEndSub,
  kCall,
  kReturn,
  kWhile,
  kEndWhile,
  kDo,
  kDoWhile,  ///< the WHILE that ends a DO
  kIf,
  kElseIf,
  kElse,
  kEndIf,
  kRepeat,
  kEndRepeat,
  kBreak,
  kContinue,
  kComputed  ///< the name is an expression
};

/// A line that begins with an O word. Lines count from 0; -1 where there is none.
struct OLine {
  OKeyword keyword = OKeyword::kProgram;
  std::string name;      ///< lower case, without brackets
  std::size_t rest = 0;  ///< in the cleaned line, behind the keyword
  int start = -1;        ///< line that begins the structure; of BREAK and CONTINUE, too
  int next = -1;         ///< of IF and ELSEIF: where it goes on when they do not hold
  int end = -1;          ///< line that ends the structure
  int last = -1;         ///< of IF: its last branch so far
  int twin = -1;         ///< an earlier structure of the same name
};

/// All O words of a source. Labels within a subroutine are its own.
class OWords {
 public:
  explicit OWords(const MacroSource& source);
  const OLine* at(int line) const;
  /// Line of "o<name> sub", -1 where there is none; of "oN" alone.
  int sub(const std::string& name) const { return found(subs_, name); }
  int program(const std::string& name) const { return found(programs_, name); }

 private:
  using Places = std::map<std::string, int>;

  static int found(const Places& places, const std::string& name);
  void enter(int line, OLine& word);
  void open(int line, OLine& word);
  void close(int line, OLine& word);

  std::map<int, OLine> words_;
  Places subs_, programs_;
  Places open_;  ///< by label
  Places seen_;  ///< structures that began before, by label
  std::string sub_;
};

}  // namespace clearcut::read::gcode
