// Numbers, lengths and transforms as SVG writes them.
#pragma once

#include <optional>
#include <string_view>

#include "read/common/affine.h"

namespace clearcut::read {

/// How a number was written.
struct Written {
  double place = 1;            ///< value of one unit of its last digit: 0.001 for "4.568", 100 for "2e2"
  int significant_digits = 0;  ///< its digits from the first that is not 0: 4 for "0.04568"
};

/// Takes numbers and words off a text; white space and one comma between them are skipped.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : text_(text) {}

  bool at_end();
  /// The next number, or nothing (and no text is consumed) if none begins. "1.5.5" is 1.5 and .5.
  std::optional<double> number();
  /// How the last number was written.
  const Written& written() const { return written_; }
  /// A single 0 or 1, without need of a separator ("a1 1 0 01 5 5").
  std::optional<bool> flag();
  /// The next character after white space, not taken; 0 at the end.
  char peek();
  void skip() { ++at_; }
  /// Letters, as far as they go.
  std::string_view word();
  std::size_t position() const { return at_; }

 private:
  void skip_space();
  std::string_view text_;
  std::size_t at_ = 0;
  Written written_;
};

/// User units per unit: px 1, in 96, mm 96/25.4, ... ; "" 1.
std::optional<double> px_per_unit(std::string_view unit);

/// "12", "3.5mm", "50%" (of `whole`) in user units.
std::optional<double> svg_length(std::string_view text, double whole);

/// "12", "3px", "2mm" in user units, "" 0; nothing for anything else.
std::optional<double> svg_plain_length(std::string_view text);

/// A list of matrix(), translate(), scale(), rotate(), skewX(), skewY(), with the units of style
/// sheets ("5px", "45deg"); nothing if invalid.
std::optional<Affine> svg_transform(std::string_view text);

}  // namespace clearcut::read
