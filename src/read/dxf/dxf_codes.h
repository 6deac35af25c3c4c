// Codes between the letters of TEXT and MTEXT.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::read {

/// Text without its codes.
struct DxfWords {
  std::vector<std::u32string> paragraphs;  ///< at least one
  /// Font named by a code before the first letter: "Arial", "txt.shx".
  std::optional<std::string> font;
  bool bold = false, italic = false;    ///< stated with the font
  std::optional<double> height;         ///< height of capitals stated there, in units of the drawing
  std::optional<double> height_factor;  ///< the same, of the entity's height
  std::set<std::string> ignored;        ///< unsupported codes that change the appearance: "\\S"
};

/// For TEXT: %%c, %%d, %%p, %%nnn, %%%, \U+XXXX, ^I. One paragraph.
DxfWords words_of_text(std::string_view text);

/// For MTEXT: these codes, \P, \~, {}, \\, \{, \}, \S, \f, \H; all others are removed.
/// Source: DXF reference, "MTEXT format codes".
DxfWords words_of_mtext(std::string_view text);

}  // namespace clearcut::read
