#include "read/board/coordinates.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

namespace clearcut::read {
namespace {

/// Whole numbers of so many digits are exact.
constexpr std::size_t kMostDigits = 15;

}  // namespace

std::optional<double> plain_number(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<int> code_number(std::string_view text) {
  const auto number = plain_number(text);
  if (!number || !(*number >= 0 && *number < 1e9)) return std::nullopt;
  return static_cast<int>(*number);
}

std::optional<double> coordinate(std::string_view text, const CoordinateFormat& format) {
  if (text.find('.') != std::string_view::npos) return plain_number(text);
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  std::string digits(text);
  const auto all = static_cast<std::size_t>(format.whole + format.decimals);
  if (format.trailing_omitted && digits.size() < all) digits.resize(all, '0');
  if (text.empty() || digits.size() > kMostDigits ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  double scale = 1;
  for (int i = 0; i < format.decimals; ++i) scale *= 10;
  const double value = static_cast<double>(std::stoll(digits)) / scale;
  return negative ? -value : value;
}

std::optional<Words> words_of(std::string_view text) {
  Words words;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ' || text[at] == '\t') {
      ++at;
      continue;
    }
    if (std::isupper(static_cast<unsigned char>(text[at])) == 0) return std::nullopt;
    const std::size_t end = text.find_first_not_of("+-.0123456789", at + 1);
    const std::size_t length = (end == std::string_view::npos ? text.size() : end) - at - 1;
    words.emplace_back(text[at], text.substr(at + 1, length));
    at += 1 + length;
  }
  return words;
}

}  // namespace clearcut::read
