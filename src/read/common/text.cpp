#include "read/common/text.h"

#include <algorithm>

#include "read/common/characters.h"

namespace clearcut::read {

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

}  // namespace clearcut::read
