// The value of one option: read from text, checked, and shown.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::inline options {

enum class ValueKind : unsigned char {
  kFlag,      ///< bool
  kLength,    ///< double, mm
  kFeed,      ///< double, mm/min
  kNumber,    ///< double, in the row's unit
  kWhole,     ///< double without a fraction
  kSeed,      ///< text: a whole number of 64 bits
  kChoice,    ///< text: one of the row's names
  kText,      ///< text
  kStepover,  ///< text: "0.4", "45%", "3.5mm", "lom", several with commas
  kFile,      ///< text: the path of a file
  kPoint,     ///< Vec2, mm
  kPoints,    ///< several of them
  kTexts,     ///< several texts
  kFiles      ///< several paths
};

using Value = std::variant<bool, double, std::string, Vec2, std::vector<std::string>, std::vector<Vec2>>;

bool takes_several(ValueKind kind);
bool is_number(ValueKind kind);

/// The lowest and the highest valid number of a row.
struct Range {
  double least, most;
  bool above_least = false;  ///< the least itself is refused
};

/// mm; greater coordinates and lengths are mistakes.
inline constexpr double kLongestLength = 1e6;
inline constexpr double kLargestNumber = 1e9;

constexpr Range above(double least, double most = kLargestNumber) {
  return {least, most, true};
}
constexpr Range between(double least, double most) {
  return {least, most, false};
}

/// Why `value` is refused, in words that follow the option's name: "must be above 0 mm"; "" for values within.
std::string beyond_range(double value, const Range& range, const std::string& unit);

/// The name in `names` nearest to `word`; "" if none is near.
std::string nearest_name(const std::string& word, const std::vector<std::string>& names);

}  // namespace clearcut::inline options
