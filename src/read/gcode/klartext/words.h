// Klartext, cut into words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clearcut::read::gcode {

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// mm/min in the unit of F: millimetres, or in inch programs tenths of an inch. `unit`: mm in the program's unit of length.
inline double feed_unit(double unit) {
  return unit == 1 ? 1 : unit / 10;
}

/// A block without its number: upper-case words and the comment.
struct Words {
  std::vector<std::string> words;
  std::string_view comment;
};

/// The mark ~ of a block that goes on in the next line is no word.
Words words_of(std::string_view line);

/// Whether the text's first line that says anything is "BEGIN PGM".
bool is_klartext(std::string_view text);

}  // namespace clearcut::read::gcode
