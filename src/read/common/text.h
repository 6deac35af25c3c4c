// Text of files in messages and comparisons.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::read {

/// ASCII letters in capitals.
std::string capitals(std::string_view text);
/// At most 40 characters of the text, without control characters: for messages.
std::string printable(std::string_view text);

}  // namespace clearcut::read
