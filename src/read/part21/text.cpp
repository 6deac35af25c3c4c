// String parameters of ISO 10303-21 (clause 6.4.3) as UTF-8.
#include <charconv>
#include <utility>

#include "read/part21/part21.h"

namespace clearcut::read {

namespace {

void append_utf8(std::uint32_t code, std::string& out) {
  const auto byte = [&](std::uint32_t value) { out += static_cast<char>(static_cast<unsigned char>(value)); };
  if (code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) code = 0xFFFD;
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | (code >> 6));
    byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | (code >> 12));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | (code >> 18));
    byte(0x80 | ((code >> 12) & 0x3F));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

std::optional<std::uint32_t> hex_value(std::string_view digits) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

/// Length of the well-formed UTF-8 sequence at the front of `text`, 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead >= 0xC2 && lead < 0xE0   ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return 0;
  return length;
}

/// Code point of byte `c` of ISO 8859-`page` (A = 1). Only pages 1 and 5 (Cyrillic), the ones seen, are
/// mapped; others are read as page 1.
std::uint32_t page_code(unsigned char c, char page) {
  if (page == 'E' && c >= 0xA1 && c != 0xAD)
    return c == 0xF0 ? 0x2116U : c == 0xFD ? 0xA7U : 0x400U + (c - 0xA0U);
  return c;
}

/// Undoes the escapes; each handler takes a known escape from the front of rest_ and returns whether there was one.
class Decoder {
 public:
  explicit Decoder(std::string_view raw) : rest_(raw) {}

  std::string decode() {
    while (!rest_.empty()) {
      const char c = rest_[0];
      if (c == '\n' || c == '\r') {
        rest_.remove_prefix(1);
      } else if (c == '\'' && rest_.size() > 1 && rest_[1] == '\'') {
        take(1, "'");
      } else if (c != '\\' || !escape()) {
        plain();
      }
    }
    return std::move(out_);
  }

 private:
  void take(std::size_t extra, std::string_view meaning) {
    out_ += meaning;
    rest_.remove_prefix(1 + extra);
  }
  bool begins(std::string_view prefix) const { return rest_.substr(0, prefix.size()) == prefix; }

  void plain() {
    const auto c = static_cast<unsigned char>(rest_[0]);
    const std::size_t length = c < 0x80 ? 1 : utf8_length(rest_);
    if (length == 0)
      append_utf8(c, out_);
    else
      out_ += rest_.substr(0, length);
    rest_.remove_prefix(length == 0 ? 1 : length);
  }

  bool escape() {
    if (begins("\\\\")) {
      take(1, "\\");
      return true;
    }
    if (begins("\\X2\\")) return wide(4);
    if (begins("\\X4\\")) return wide(8);
    if (begins("\\X\\")) return narrow();
    if (begins("\\S\\") && rest_.size() > 3) {
      append_utf8(page_code(static_cast<unsigned char>(static_cast<unsigned char>(rest_[3]) | 0x80U), page_),
                  out_);
      rest_.remove_prefix(4);
      return true;
    }
    if (begins("\\P") && rest_.size() > 3 && rest_[3] == '\\') {
      page_ = rest_[2];
      rest_.remove_prefix(4);
      return true;
    }
    if (begins("\\N\\") || begins("\\F\\")) {
      rest_.remove_prefix(3);
      return true;
    }
    return false;
  }

  bool narrow() {
    const auto code = rest_.size() >= 5 ? hex_value(rest_.substr(3, 2)) : std::nullopt;
    if (!code) return false;
    append_utf8(*code, out_);
    rest_.remove_prefix(5);
    return true;
  }

  /// \X2\ or \X4\: groups of `digits` until \X0\. Pairs of UTF-16 surrogates are joined.
  bool wide(std::size_t digits) {
    const std::size_t end = rest_.find("\\X0\\");
    if (end == std::string_view::npos || (end - 4) % digits != 0) return false;
    std::string decoded;
    std::uint32_t high = 0;
    for (std::size_t at = 4; at < end; at += digits) {
      const auto code = hex_value(rest_.substr(at, digits));
      if (!code) return false;
      if (*code >= 0xD800 && *code < 0xDC00) {
        high = *code;
        continue;
      }
      const bool pair = high != 0 && *code >= 0xDC00 && *code < 0xE000;
      append_utf8(pair ? 0x10000 + ((high - 0xD800) << 10) + (*code - 0xDC00) : *code, decoded);
      high = 0;
    }
    out_ += decoded;
    rest_.remove_prefix(end + 4);
    return true;
  }

  std::string_view rest_;
  std::string out_;
  char page_ = 'A';
};

}  // namespace

std::string p21_decoded(std::string_view raw) {
  return Decoder(raw).decode();
}

}  // namespace clearcut::read
