// Line ends of texts written on any operating system.
#pragma once

#include <string_view>

namespace clearcut::inline base {

/// The character that ends the lines of a text: CR if the text has no LF. Before an LF, CR is a blank.
constexpr char line_end_of(std::string_view text) {
  return text.find('\n') == std::string_view::npos ? '\r' : '\n';
}

}  // namespace clearcut::inline base
