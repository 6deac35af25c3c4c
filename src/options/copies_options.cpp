#include "options/copies_options.h"

#include <charconv>
#include <string_view>

#include "base/text.h"

namespace clearcut::inline options {
namespace {

std::optional<int> count_in(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 1) return std::nullopt;
  return value;
}

/// The texts before and behind the first x.
std::optional<std::pair<std::string_view, std::string_view>> sides_of(std::string_view text) {
  const auto x = text.find_first_of("xX");
  if (x == std::string_view::npos) return std::nullopt;
  return std::pair(text.substr(0, x), text.substr(x + 1));
}

}  // namespace

std::optional<std::pair<int, int>> counts_of_copies(const std::string& text) {
  const auto sides = sides_of(text);
  if (!sides) return std::nullopt;
  const auto across = count_in(sides->first), up = count_in(sides->second);
  if (!across || !up || *across > kMostCopies / *up) return std::nullopt;
  return std::pair(*across, *up);
}

std::optional<std::pair<double, double>> size_of_sheet(const std::string& text) {
  const auto sides = sides_of(text);
  if (!sides) return std::nullopt;
  const auto width = length_in_mm(sides->first), height = length_in_mm(sides->second);
  if (!width || !height || !(*width > 0) || !(*height > 0)) return std::nullopt;
  return std::pair(*width, *height);
}

std::optional<NestedFile> nested_file(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const std::string number = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (number.empty() || number.find_first_not_of("-0123456789") != std::string::npos)
    return text.empty() ? std::nullopt : std::optional(NestedFile{text, {}});
  const auto count = count_in(number);
  if (colon == 0 || !count || *count > kMostCopies) return std::nullopt;
  return NestedFile{text.substr(0, colon), count};
}

}  // namespace clearcut::inline options
