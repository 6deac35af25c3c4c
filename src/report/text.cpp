#include "report/text.h"

#include <fmt/format.h>

#include <cmath>

namespace clearcut {

namespace {

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

/// Length in bytes that the first byte of a UTF-8 sequence announces; 0 for a byte that cannot be first.
std::size_t announced_length(unsigned char first) {
  if (first < 0x80U) return 1;
  if (first >= 0xc2U && first < 0xe0U) return 2;
  if (first >= 0xe0U && first < 0xf0U) return 3;
  if (first >= 0xf0U && first < 0xf5U) return 4;
  return 0;
}

/// Length of the code point at the start of `text` when it is well-formed UTF-8 that XML 1.0 accepts;
/// otherwise 0.
std::size_t xml_code_point(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = announced_length(first);
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return 0;
  }
  if (length == 1) return first >= 0x20U || first == '\t' || first == '\n' ? 1 : 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool overlong = (first == 0xe0U && second < 0xa0U) || (first == 0xf0U && second < 0x90U);
  const bool surrogate_or_too_large =
      (first == 0xedU && second >= 0xa0U) || (first == 0xf4U && second >= 0x90U);
  const bool noncharacter = first == 0xefU && second == 0xbfU && static_cast<unsigned char>(text[2]) >= 0xbeU;
  return overlong || surrogate_or_too_large || noncharacter ? 0 : length;
}

}  // namespace

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "?";
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  if (is_zero && text[0] == '-') text.erase(0, 1);
  return text;
}

std::string clock_time(double seconds) {
  constexpr double kLongest = 3600.0 * 1e6;
  if (!std::isfinite(seconds) || seconds < 0 || seconds > kLongest) return "?";
  const long total = std::lround(seconds);
  const long hours = total / 3600, minutes = total / 60 % 60;
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, total % 60);
  return fmt::format("{}:{:02}", minutes, total % 60);
}

std::string ascii(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (is_continuation(c)) continue;
    const bool blank = c == '\n' || c == '\r' || c == '\t';
    result += blank ? ' ' : c >= ' ' && c <= '~' ? c : '?';
  }
  return result;
}

std::string shortened(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text;
  return width < 3 ? text.substr(0, width) : text.substr(0, width - 2) + "..";
}

std::string xml_escaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = xml_code_point(text.substr(i));
    const char c = text[i];
    if (length == 0) {
      result += '?';
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if (c == '\'') {
      result += "&#39;";
    } else {
      result.append(text.substr(i, length));
    }
    i += length == 0 ? 1 : length;
  }
  return result;
}

}  // namespace clearcut
