// Numbers and text for people and programs, without locale: quantities as people write them, a number with a unit or
// without, text for XML and HTML, line ends of texts written on any operating system.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::inline base {

/// Fixed notation with `decimals` digits, trailing zeros and a trailing point removed, never "-0".
std::string trimmed(double value, int decimals);

/// The parts between separators: one more than there are separators, empty ones included.
std::vector<std::string> split(const std::string& text, char separator);

/// The text without the characters of `blanks` at either end; a view into the same text.
constexpr std::string_view stripped(std::string_view text, std::string_view blanks = " \t\r\n\v\f") {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The character that ends the lines of a text: CR if the text has no LF. Before an LF, CR is a blank.
constexpr char line_end_of(std::string_view text) {
  return text.find('\n') == std::string_view::npos ? '\r' : '\n';
}

/// A plain finite number, the whole text.
std::optional<double> plain_number(std::string_view text);

/// mm. "6", "6mm", "0.25in", "1/4in", "0.6cm"; nothing for other text.
std::optional<double> length_in_mm(std::string_view text);

/// mm/min. "800", "800mm/min", "40in/min", "40ipm", "15mm/s", "1.2m/min"; nothing for other text.
std::optional<double> feed_in_mm_per_min(std::string_view text);

/// For XML and HTML text and attributes: & < > " ' escaped, characters forbidden by XML and broken UTF-8
/// replaced by '?'.
std::string xml_escaped(std::string_view text);

}  // namespace clearcut::inline base
