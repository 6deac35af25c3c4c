// Text of files: characters, comparisons, names of units of length.
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

/// ASCII letters in capitals.
std::string capitals(std::string_view text);
/// At most 40 characters of the text, without control characters: for messages.
std::string printable(std::string_view text);

/// mm per unit for "mm", "cm", "m", "um", "in" (also "inch", "inches"), "ft", "mil"/"thou", "pt", "pc",
/// "px" (96 per inch); upper or lower case. Exact: an inch is 25.4 mm.
std::optional<double> mm_per_unit(std::string_view name);
/// The names accepted by mm_per_unit, for messages.
const std::string& known_units();
/// mm per unit of `name`; throws InputError at `place` when the unit is unknown.
double require_unit(std::string_view name, const std::string& place);

}  // namespace clearcut::read
