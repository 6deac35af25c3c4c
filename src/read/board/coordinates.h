// Coordinates as the files of circuit boards write them: digits without a decimal point, and zeros left out.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace clearcut::read {

struct CoordinateFormat {
  int whole = 3;                  ///< digits before the point
  int decimals = 3;               ///< digits after the decimal point
  bool trailing_omitted = false;  ///< zeros at the end are left out; else those at the beginning
};

/// "-1250" as -1.25 if three digits follow the point; numbers with a point are taken as written. Nothing for text
/// other than numbers.
std::optional<double> coordinate(std::string_view text, const CoordinateFormat& format);

/// A number as written: "0.8", "-3", ".5".
std::optional<double> plain_number(std::string_view text);
/// Number of a code or a tool, 0 to below 1e9, without its decimals; nothing for anything else.
std::optional<int> code_number(std::string_view text);

/// "X100Y-5D01" as X 100, Y -5, D 01. Nothing for any other text.
using Words = std::vector<std::pair<char, std::string_view>>;
std::optional<Words> words_of(std::string_view text);

}  // namespace clearcut::read
