#include "read/common/text.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.h"
#include "base/units.h"

namespace clearcut::read {
namespace {

/// Characters of the bytes 0x80 to 0x9f; all other bytes represent themselves. Unassigned ones are the replacement
/// character.
constexpr std::array<char32_t, 32> kWindows = {
    0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};

/// Number of bytes of a character beginning with `first`; 0 if none does.
std::size_t bytes_of(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

}  // namespace

std::optional<std::u32string> characters_of_utf8(std::string_view text) {
  constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t count = bytes_of(first);
    if (count == 0 || i + count > text.size()) return std::nullopt;
    char32_t letter = count == 1 ? first : first & (0x7FU >> count);
    for (std::size_t k = 1; k < count; ++k) {
      const auto byte = static_cast<unsigned char>(text[i + k]);
      if ((byte & 0xC0U) != 0x80) return std::nullopt;
      letter = letter << 6 | (byte & 0x3FU);
    }
    const bool surrogate = letter >= 0xD800 && letter < 0xE000;
    if (letter < kLeast[count] || letter > 0x10FFFF || surrogate) return std::nullopt;
    out += letter;
    i += count;
  }
  return out;
}

std::u32string characters_of(std::string_view text) {
  if (auto characters = characters_of_utf8(text)) return *characters;
  std::u32string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte >= 0x80 && byte < 0xA0 ? kWindows[byte - 0x80U] : byte;
  }
  return out;
}

std::string utf8_of(std::u32string_view characters) {
  std::string out;
  const auto add = [&](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  for (const char32_t c : characters) {
    if (c < 0x80) {
      add(c);
      continue;
    }
    const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    add((0xF00U >> more & 0xF0U) | c >> (6 * more));
    for (int k = more - 1; k >= 0; --k) add(0x80U | (c >> (6 * k) & 0x3FU));
  }
  return out;
}

bool needs_shaping(char32_t letter) {
  return (letter >= 0x0300 && letter < 0x0370) || (letter >= 0x0590 && letter < 0x0E00) ||
         (letter >= 0x1780 && letter < 0x1800) || (letter >= 0xFB1D && letter < 0xFE00) ||
         (letter >= 0xFE70 && letter < 0xFF00);
}

std::string capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return out;
}

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  // No character is cut in two.
  std::size_t end = std::min(text.size(), kLongest);
  while (end < text.size() && end > kLongest - 4 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
    --end;
  std::string out(text.substr(0, end));
  const bool is_utf8 = characters_of_utf8(out).has_value();
  for (char& c : out) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f || (byte > 0x7f && !is_utf8)) c = '?';
  }
  return text.size() > kLongest ? out + "..." : out;
}

namespace {

constexpr std::array<std::pair<std::string_view, double>, 16> kUnits{{
    {"mm", 1},
    {"millimeter", 1},
    {"millimeters", 1},
    {"cm", 10},
    {"m", 1000},
    {"um", 0.001},
    {"in", kMmPerInch},
    {"inch", kMmPerInch},
    {"inches", kMmPerInch},
    {"ft", 12 * kMmPerInch},
    {"mil", kMmPerInch / 1000},
    {"thou", kMmPerInch / 1000},
    {"pt", kMmPerInch / 72},
    {"pc", kMmPerInch / 6},
    {"px", kMmPerInch / 96},
    {"q", 0.25},
}};

}  // namespace

std::optional<double> mm_per_unit(std::string_view name) {
  const std::string wanted = capitals(name);
  for (const auto& [unit, mm] : kUnits) {
    if (wanted == capitals(unit)) return mm;
  }
  return std::nullopt;
}

const std::string& known_units() {
  static const std::string names = "mm, cm, m, um, in, ft, mil, pt, pc, px";
  return names;
}

double require_unit(std::string_view name, const std::string& place) {
  const auto unit = mm_per_unit(name);
  if (!unit) {
    throw InputError(place, "unknown unit '" + printable(name) + "'; use one of " + known_units());
  }
  return *unit;
}

}  // namespace clearcut::read
