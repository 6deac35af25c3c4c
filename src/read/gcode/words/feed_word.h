// The F word in the text of one block of G-code.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace clearcut::read::gcode {

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
