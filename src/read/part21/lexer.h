// Tokens of ISO 10303-21.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace clearcut::read {

enum class P21Token : unsigned char {
  kKeyword,    ///< also !USER_DEFINED and ISO-10303-21
  kReference,  ///< #12
  kInteger,
  kReal,
  kString,
  kEnum,
  kBinary,
  kUnset,
  kDerived,
  kOpen,
  kClose,
  kComma,
  kSemicolon,
  kEquals,
  kOther,  ///< <...> and @ words of later editions: only passed over
  kEnd
};

/// Cuts the text into tokens, one at a time.
class P21Lexer {
 public:
  P21Lexer(std::string_view source, const std::string& file_name) : text_(source), file_name_(&file_name) {}

  /// Moves to the next token. Throws InputError for characters that begin no token and for unfinished tokens.
  void next();

  P21Token token = P21Token::kEnd;
  std::string_view text;  ///< content: without quotes, points or '#'
  double number = 0;
  std::uint64_t id = 0;
  int line = 1;  ///< line of the token's beginning

  [[noreturn]] void fail(const std::string& what_and_what_to_do) const;
  /// The token as shown in messages.
  std::string shown() const;

 private:
  void skip_blank();
  void skip_comment();
  void read_string();
  void read_binary();
  void read_enum();
  void read_number();
  void read_reference();
  void read_keyword();
  void read_other();
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  void take_symbol(P21Token kind);

  std::string_view text_;
  const std::string* file_name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace clearcut::read
