// Font properties from SVG's attributes and style sheets.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::read {

/// Inherited properties of text.
struct SvgFont {
  std::vector<std::string> families;
  double size = 16;        ///< user units
  double outer_size = 16;  ///< size of the enclosing element, for percentages
  std::string spacing;     ///< a length between letters, as written
  std::string anchor = "start";
  bool bold = false;
  bool italic = false;
  bool vertical = false;
  bool keeps_space = false;           ///< white space is not collapsed
  std::set<std::string> not_applied;  ///< unsupported properties that move or change letters
  std::string problem;                ///< "" or the unsupported value

  /// `value` must have no surrounding blanks.
  void set(std::string_view property, std::string_view value);
};

/// The attributes known to SvgFont::set.
inline constexpr const char* kSvgFontProperties[] = {"font",
                                                     "font-family",
                                                     "font-size",
                                                     "font-weight",
                                                     "font-style",
                                                     "text-anchor",
                                                     "letter-spacing",
                                                     "writing-mode",
                                                     "white-space",
                                                     "xml:space",
                                                     "font-stretch",
                                                     "font-variant",
                                                     "dominant-baseline",
                                                     "baseline-shift",
                                                     "alignment-baseline",
                                                     "word-spacing",
                                                     "text-decoration",
                                                     "text-transform",
                                                     "direction",
                                                     "textLength",
                                                     "font-size-adjust"};

/// Lengths between blanks and commas; "em" is `em` user units, percentages are of `whole`. Ends before the first text
/// that is no length.
std::vector<double> svg_lengths(std::string_view text, double whole, double em);

}  // namespace clearcut::read
