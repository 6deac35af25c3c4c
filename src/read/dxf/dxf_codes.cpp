#include "read/dxf/dxf_codes.h"

#include <algorithm>

#include "base/text/format.h"
#include "base/text/quantity.h"
#include "read/common/characters.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

/// The value of `digits`, all of them of `base`; nothing else.
std::optional<char32_t> value_of(std::u32string_view digits, char32_t base) {
  char32_t value = 0;
  for (const char32_t c : digits) {
    const char32_t digit = c >= U'0' && c <= U'9'   ? c - U'0'
                           : c >= U'A' && c <= U'F' ? c - U'A' + 10
                           : c >= U'a' && c <= U'f' ? c - U'a' + 10
                                                    : base;
    if (digit >= base) return std::nullopt;
    value = value * base + digit;
  }
  return digits.empty() ? std::nullopt : std::optional(value);
}

class CodeReader {
 public:
  CodeReader(std::string_view text, bool formatted) : text_(characters_of(text)), formatted_(formatted) {
    words_.paragraphs.emplace_back();
  }

  DxfWords read() {
    while (at_ < text_.size()) {
      const char32_t c = text_[at_];
      if (c == U'%' && rest().starts_with(U"%%") && at_ + 2 < text_.size()) {
        percent_code();
      } else if (c == U'^' && at_ + 1 < text_.size()) {
        caret_code();
      } else if (c == U'\\' && unicode_code()) {
        continue;
      } else if (formatted_ && c == U'\\' && at_ + 1 < text_.size()) {
        format_code();
      } else if (formatted_ && (c == U'{' || c == U'}')) {
        ++at_;
      } else {
        put(c);
        ++at_;
      }
    }
    return std::move(words_);
  }

 private:
  std::u32string_view rest() const { return std::u32string_view(text_).substr(at_); }

  void put(char32_t c) {
    words_.paragraphs.back() += c;
    begun_ = true;
  }

  void percent_code() {
    const char32_t c = text_[at_ + 2];
    const auto number = value_of(rest().substr(2, 3), 10);
    if (number && rest().size() >= 5) {
      put(*number);
      at_ += 5;
      return;
    }
    at_ += 3;
    if (c == U'c' || c == U'C') return put(U'\u00D8');
    if (c == U'd' || c == U'D') return put(U'\u00B0');
    if (c == U'p' || c == U'P') return put(U'\u00B1');
    if (std::u32string_view(U"uUoOkK").find(c) != std::u32string_view::npos) {
      words_.ignored.insert("%%" + utf8_of({&c, 1}));
    } else {
      put(c);
    }
  }

  void caret_code() {
    const char32_t c = text_[at_ + 1];
    at_ += 2;
    if (c == U' ') return put(U'^');
    if (c == U'I') return put(U' ');
    if (c == U'J') return words_.paragraphs.emplace_back(), void();
    if (c == U'M') return;
    put(U'^');
    --at_;
  }

  /// \U+XXXX, in every text.
  bool unicode_code() {
    if (!rest().starts_with(U"\\U+") && !rest().starts_with(U"\\u+")) return false;
    const auto letter = value_of(rest().substr(3, 4), 16);
    if (!letter || rest().size() < 7) return false;
    put(*letter);
    at_ += 7;
    return true;
  }

  void format_code() {
    constexpr std::u32string_view kWithValue = U"fFHACcWTQpS";
    const char32_t c = text_[at_ + 1];
    at_ += 2;
    if (kWithValue.find(c) != std::u32string_view::npos) {
      const std::size_t end = std::min(text_.find(U';', at_), text_.size());
      const std::u32string value = text_.substr(at_, end - at_);
      at_ = std::min(end + 1, text_.size());
      value_code(c, value);
    } else if (c == U'P' || c == U'N') {
      words_.paragraphs.emplace_back();
    } else if (c == U'~') {
      put(U'\u00A0');
    } else if (std::u32string_view(U"LOK").find(c) != std::u32string_view::npos) {
      words_.ignored.insert("\\" + utf8_of({&c, 1}));
    } else if (std::u32string_view(U"lok").find(c) == std::u32string_view::npos) {
      put(c);
    }
  }

  void value_code(char32_t c, const std::u32string& value) {
    if (c == U'S') {
      for (const char32_t one : value) put(one == U'^' || one == U'#' ? U'/' : one);
    } else if ((c == U'f' || c == U'F') && !begun_) {
      return font(utf8_of(value));
    } else if (c == U'H' && !begun_) {
      return height(utf8_of(value));
    } else if (c == U'A' || c == U'C' || c == U'c') {
      return;  // colours, and the alignment of stacked fractions
    }
    words_.ignored.insert("\\" + utf8_of({&c, 1}));
  }

  /// "Arial|b1|i0|c0|p34"; "txt,bigfont".
  void font(const std::string& value) {
    const std::vector<std::string> parts = split(value, '|');
    words_.font = split(parts.front(), ',').front();
    for (const std::string& part : parts) {
      if (part == "b1") words_.bold = true;
      if (part == "i1") words_.italic = true;
    }
  }

  void height(std::string value) {
    const bool relative = !value.empty() && (value.back() == 'x' || value.back() == 'X');
    if (relative) value.pop_back();
    const auto number = plain_number(value);
    if (number && *number > 0) (relative ? words_.height_factor : words_.height) = *number;
  }

  std::u32string text_;
  bool formatted_;
  std::size_t at_ = 0;
  bool begun_ = false;
  DxfWords words_;
};

}  // namespace

DxfWords words_of_text(std::string_view text) {
  return CodeReader(text, false).read();
}

DxfWords words_of_mtext(std::string_view text) {
  return CodeReader(text, true).read();
}

}  // namespace clearcut::read
