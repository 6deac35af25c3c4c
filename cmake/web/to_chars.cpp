#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <string>

namespace {

std::string fixed(const std::string& digits, int point) {
  const int count = static_cast<int>(digits.size());
  if (point <= 0) return "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  if (point >= count) return digits + std::string(static_cast<std::size_t>(point - count), '0');
  const auto at = static_cast<std::size_t>(point);
  return digits.substr(0, at) + "." + digits.substr(at);
}

std::string scientific(const std::string& digits, int point) {
  const std::string fraction = digits.size() > 1 ? "." + digits.substr(1) : "";
  const int exponent = point - 1;
  return fmt::format("{}{}e{}{:02}", digits[0], fraction, exponent < 0 ? '-' : '+', std::abs(exponent));
}

std::string shortest(double value) {
  if (!std::isfinite(value) || value == 0) return fmt::format("{:g}", value);
  const auto decimal = fmt::detail::dragonbox::to_decimal(std::fabs(value));
  const std::string digits = fmt::format("{}", decimal.significand);
  const int point = static_cast<int>(digits.size()) + decimal.exponent;
  const std::string plain = fixed(digits, point), power = scientific(digits, point);
  return (std::signbit(value) ? "-" : "") + (plain.size() <= power.size() ? plain : power);
}

}  // namespace

std::to_chars_result std::to_chars(char* first, char* last, double value) {
  const std::string text = shortest(value);
  if (text.size() > static_cast<std::size_t>(last - first)) return {last, errc::value_too_large};
  std::memcpy(first, text.data(), text.size());
  return {first + text.size(), errc()};
}
