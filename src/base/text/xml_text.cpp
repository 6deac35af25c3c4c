#include "base/text/xml_text.h"

namespace clearcut::inline base {

namespace {

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
}

/// Length in bytes of a UTF-8 sequence by its first byte; 0 if the byte cannot be a first one.
std::size_t announced_length(unsigned char first) {
  if (first < 0x80U) return 1;
  if (first >= 0xc2U && first < 0xe0U) return 2;
  if (first >= 0xe0U && first < 0xf0U) return 3;
  if (first >= 0xf0U && first < 0xf5U) return 4;
  return 0;
}

/// Length of the code point at the start of `text` if it is well-formed UTF-8 and accepted by XML 1.0;
/// otherwise 0.
std::size_t xml_code_point(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = announced_length(first);
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) return 0;
  }
  if (length == 1) return first >= 0x20U || first == '\t' || first == '\n' ? 1 : 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool overlong = (first == 0xe0U && second < 0xa0U) || (first == 0xf0U && second < 0x90U);
  const bool surrogate_or_too_large =
      (first == 0xedU && second >= 0xa0U) || (first == 0xf4U && second >= 0x90U);
  const bool noncharacter = first == 0xefU && second == 0xbfU && static_cast<unsigned char>(text[2]) >= 0xbeU;
  return overlong || surrogate_or_too_large || noncharacter ? 0 : length;
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = xml_code_point(text.substr(i));
    const char c = text[i];
    if (length == 0) {
      result += '?';
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if (c == '\'') {
      result += "&#39;";
    } else {
      result.append(text.substr(i, length));
    }
    i += length == 0 ? 1 : length;
  }
  return result;
}

}  // namespace clearcut::inline base
