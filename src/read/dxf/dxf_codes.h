// What TEXT and MTEXT write between their letters.
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
  std::optional<std::string> font;         ///< that a code before the first letter names: "Arial", "txt.shx"
  bool bold = false, italic = false;       ///< said with it
  std::optional<double> height;            ///< of capitals, said there, in units of the drawing
  std::optional<double> height_factor;     ///< the same, of the entity's height
  std::set<std::string> ignored;           ///< codes that change the looks and are not followed: "\\S"
};

/// Of TEXT: %%c, %%d, %%p, %%nnn, %%%, \U+XXXX, ^I. One paragraph.
DxfWords words_of_text(std::string_view text);

/// Of MTEXT: those, \P, \~, {}, \\, \{, \}, \S, \f, \H and all others, which are taken out.
/// Source: DXF reference, "MTEXT format codes".
DxfWords words_of_mtext(std::string_view text);

}  // namespace clearcut::read
