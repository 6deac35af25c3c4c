// The lines of a program's text.
#pragma once

#include <string_view>

namespace clearcut::read::gcode {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// Ends may be LF, CR LF or CR; a byte order mark is skipped.
class Lines {
 public:
  explicit Lines(std::string_view text);
  /// False at the end of the text.
  bool next(std::string_view& line);
  int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

}  // namespace clearcut::read::gcode
