#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

/// What of a line are words, up to a comment at its end, a checksum or a message.
struct Words {
  std::optional<FeedWord> feed;
  std::size_t end = 0;  ///< behind the last word
  bool has_checksum = false;
};

bool is_of_number(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '+' || c == '-';
}

FeedWord word_of(std::string_view line, std::size_t begin, std::size_t end) {
  std::string digits;
  for (const char c : line.substr(begin, end - begin))
    if (!is_blank(c) && c != '+') digits += c;
  FeedWord word{begin, end, 0, digits.find('.') != std::string::npos};
  std::from_chars(digits.data(), digits.data() + digits.size(), word.value, std::chars_format::fixed);
  return word;
}

/// M117 and M118 of Marlin, and text behind M0 and M1: the rest of the line is no word.
bool begins_message(char letter, std::string_view number, std::string_view rest) {
  if (letter != 'M') return false;
  if (number == "117" || number == "118") return true;
  const bool pauses = number == "0" || number == "1" || number == "00" || number == "01";
  return pauses && rest.size() > 1 && std::isalpha(static_cast<unsigned char>(rest[0])) != 0 &&
         std::isalpha(static_cast<unsigned char>(rest[1])) != 0;
}

Words words_of(std::string_view line) {
  Words words;
  for (std::size_t at = 0; at < line.size();) {
    const char c = line[at];
    if (c == ';' || c == '%') break;
    if (c == '*') {
      words.has_checksum = true;
      break;
    }
    if (c == '(') {
      const std::size_t close = line.find(')', at);
      if (close == std::string_view::npos) break;
      at = close + 1;
      continue;
    }
    ++at;
    if (is_blank(c) || c == '/') continue;
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const std::size_t begin = at;
    std::size_t end = at;
    for (; at < line.size() && (is_blank(line[at]) || is_of_number(line[at])); ++at)
      if (!is_blank(line[at])) end = at + 1;
    words.end = end;
    if (letter == 'F') words.feed = word_of(line, begin, end);
    if (begins_message(letter, line.substr(begin, end - begin), line.substr(at))) break;
  }
  return words;
}

/// As many digits as tell feeds apart by a thousandth; a number with a point keeps one, and none is rounded up.
std::string number_text(double value, bool has_point) {
  const int decimals = value >= 1000 ? 0 : value >= 100 ? 1 : value >= 10 ? 2 : value >= 1 ? 3 : 5;
  const double scale = base::pow(10.0, decimals);
  std::string text = fmt::format("{:.{}f}", std::floor(value * scale + 1e-9) / scale, decimals);
  if (decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return has_point && text.find('.') == std::string::npos ? text + "." : text;
}

}  // namespace

std::optional<FeedWord> feed_word_in(std::string_view line) {
  return words_of(line).feed;
}

std::string with_feed_word(std::string_view line, double value, const std::string& place) {
  const Words words = words_of(line);
  if (words.has_checksum)
    throw InputError(place,
                     "ends in a checksum, which another feed would make wrong; post the program without");
  std::string text(line);
  if (words.feed) {
    const FeedWord& word = *words.feed;
    return text.replace(word.begin, word.end - word.begin, number_text(value, word.has_point));
  }
  return text.insert(words.end, " F" + number_text(value, false));
}

}  // namespace clearcut::read::gcode
