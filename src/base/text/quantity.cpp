#include "base/text/quantity.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/inch.h"

namespace clearcut::inline base {
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

}  // namespace clearcut::inline base
