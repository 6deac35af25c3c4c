// Lines of a text that any system wrote.
#pragma once

#include <string_view>

namespace clearcut::inline base {

/// The character that ends the lines of a text: CR where there is no LF. Before an LF, CR is a blank.
constexpr char line_end_of(std::string_view text) {
  return text.find('\n') == std::string_view::npos ? '\r' : '\n';
}

}  // namespace clearcut::inline base
