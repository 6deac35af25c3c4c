#include <fmt/format.h>

#include <cmath>

#include "report/words/text_table.h"

namespace clearcut::report {

namespace {

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
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

}  // namespace clearcut::report
