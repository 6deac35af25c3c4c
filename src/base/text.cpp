#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/units.h"

namespace clearcut::inline base {

std::string trimmed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

namespace {

using Unit = std::pair<std::string_view, double>;
constexpr std::array<Unit, 7> kLengths{{{"mm", 1},
                                        {"cm", 10},
                                        {"inches", kMmPerInch},
                                        {"inch", kMmPerInch},
                                        {"in", kMmPerInch},
                                        {"\"", kMmPerInch},
                                        {"m", 1000}}};
constexpr std::array<Unit, 6> kFeeds{{{"mm/min", 1},
                                      {"in/min", kMmPerInch},
                                      {"inch/min", kMmPerInch},
                                      {"ipm", kMmPerInch},
                                      {"mm/s", 60},
                                      {"m/min", 1000}}};

std::string_view without_blanks_before(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return text;
}

std::string_view without_blanks_behind(std::string_view text) {
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// "0.25" or "1/4".
std::optional<double> number_or_fraction(std::string_view text) {
  const auto bar = text.find('/');
  if (bar == std::string_view::npos) return plain_number(text);
  const auto above = plain_number(text.substr(0, bar)), below = plain_number(text.substr(bar + 1));
  if (!above || !below || *below == 0) return std::nullopt;
  return *above / *below;
}

/// If several units end the text, the longest one is taken.
template <std::size_t N>
std::optional<double> quantity_of(std::string_view text, const std::array<Unit, N>& units) {
  std::string_view number = text;
  double factor = 1;
  std::size_t longest = 0;
  for (const auto& [unit, value] : units) {
    if (!text.ends_with(unit) || unit.size() <= longest) continue;
    longest = unit.size();
    number = text.substr(0, text.size() - unit.size());
    factor = value;
  }
  const auto value = number_or_fraction(without_blanks_behind(number));
  if (!value) return std::nullopt;
  return *value * factor;
}

}  // namespace

std::optional<double> plain_number(std::string_view text) {
  text = without_blanks_before(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> length_in_mm(std::string_view text) {
  return quantity_of(text, kLengths);
}

std::optional<double> feed_in_mm_per_min(std::string_view text) {
  return quantity_of(text, kFeeds);
}

namespace {

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

/// Length in bytes of a UTF-8 sequence by its first byte; 0 if the byte cannot be a first one.
std::size_t announced_length(unsigned char first) {
  if (first < 0x80U) return 1;
  if (first >= 0xc2U && first < 0xe0U) return 2;
  if (first >= 0xe0U && first < 0xf0U) return 3;
  if (first >= 0xf0U && first < 0xf5U) return 4;
  return 0;
}

/// Length of the code point at the start of `text` if it is well-formed UTF-8 and accepted by XML 1.0;
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

}  // namespace clearcut::inline base
