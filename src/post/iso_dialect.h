// What the word-address controls (everything but Klartext) do differently, as data.
#pragma once

#include <string_view>

namespace clearcut {

enum class CommentForm { kParentheses, kSemicolon };
enum class ToolChangeForm { kChanger, kPause };

struct IsoDialect {
  std::string_view name;
  int mm_decimals = 4;
  int inch_decimals = 5;
  bool always_point = false;  ///< "10." not "10"
  CommentForm comments = CommentForm::kParentheses;
  std::size_t line_length = 80;
  std::string_view safe_start;  ///< modal words of the first block, after the unit word
  bool path_tolerance = false;  ///< writes G64 P- Q0
  ToolChangeForm tool_change = ToolChangeForm::kChanger;
  std::string_view program_end;   ///< last word
  double largest_radius = 10000;  ///< mm
};

/// The row of that name, or nullptr.
const IsoDialect* iso_dialect_named(std::string_view name);

}  // namespace clearcut
