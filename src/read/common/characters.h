// Text of drawings as characters.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace clearcut::read {

/// `text` as UTF-8; nothing if it is not valid UTF-8.
std::optional<std::u32string> characters_of_utf8(std::string_view text);

/// `text` as UTF-8, else as Windows' code page 1252 (Western Europe), in which every byte is valid text.
std::u32string characters_of(std::string_view text);

std::string utf8_of(std::u32string_view characters);

/// Whether a letter takes its shape or place from its neighbours (Arabic, Hebrew, Devanagari, ...), so that setting
/// letters one by one from left to right is wrong.
bool needs_shaping(char32_t letter);

}  // namespace clearcut::read
