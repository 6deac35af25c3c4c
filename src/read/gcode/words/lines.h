// The lines of a program's text, the percent signs of a tape, and the F word in the text of one block.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
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

/// A tape's text lies between two '%'; a single one behind words ends it.
class TapeMarks {
 public:
  /// True when this block ends the program.
  bool ends(bool is_percent, bool has_words) {
    const bool end = is_percent && begun_;
    begun_ = begun_ || is_percent || has_words;
    return end;
  }

 private:
  bool begun_ = false;
};

/// Where the number of an F word stands in a line, and its value as written.
struct FeedWord {
  std::size_t begin = 0, end = 0;
  double value = 0;
  bool has_point = false;
};

/// Of a line that BlockReader takes; nothing where it has none outside comments and messages.
std::optional<FeedWord> feed_word_in(std::string_view line);

/// The line with another feed: its F word rewritten, or one added behind its last word. Nothing else changes. Throws InputError at
/// `place` where the line ends in a checksum, which would no longer be right.
std::string with_feed_word(std::string_view line, double value, const std::string& place);

}  // namespace clearcut::read::gcode
