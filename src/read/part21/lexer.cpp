#include "read/part21/lexer.h"

#include <charconv>
#include <system_error>

#include "base/error.h"

namespace clearcut::read {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}
bool is_hex(char c) {
  return is_digit(c) || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
}

}  // namespace

void P21Lexer::fail(const std::string& what_and_what_to_do) const {
  throw InputError(*file_name_ + ":" + std::to_string(line), what_and_what_to_do);
}

std::string P21Lexer::shown() const {
  constexpr std::size_t kLongest = 40;
  std::string piece(text.substr(0, kLongest));
  for (char& c : piece)
    if (c >= '\0' && c < ' ') c = ' ';
  switch (token) {
    case P21Token::kEnd:
      return "the end of the file";
    case P21Token::kReference:
      return "#" + std::string(text);
    case P21Token::kEnum:
      return "." + piece + ".";
    default:
      return "'" + piece + "'";
  }
}

void P21Lexer::next() {
  skip_blank();
  line = line_;
  const char c = peek();
  if (at_ >= text_.size()) {
    token = P21Token::kEnd;
    text = {};
  } else if (c == '\'') {
    read_string();
  } else if (c == '"') {
    read_binary();
  } else if (c == '.' && !is_digit(peek(1))) {
    read_enum();
  } else if (c == '#') {
    read_reference();
  } else if (is_digit(c) || c == '+' || c == '-' || c == '.') {
    read_number();
  } else if (is_letter(c) || c == '!') {
    read_keyword();
  } else if (c == '<' || c == '@' || c == '{' || c == '}') {
    read_other();
  } else {
    switch (c) {
      case '(':
        return take_symbol(P21Token::kOpen);
      case ')':
        return take_symbol(P21Token::kClose);
      case ',':
        return take_symbol(P21Token::kComma);
      case ';':
        return take_symbol(P21Token::kSemicolon);
      case '=':
        return take_symbol(P21Token::kEquals);
      case '$':
        return take_symbol(P21Token::kUnset);
      case '*':
        return take_symbol(P21Token::kDerived);
      default:
        fail("a character (code " + std::to_string(static_cast<unsigned char>(c)) +
             ") that has no meaning in a Part 21 file; is this a STEP-NC text file?");
    }
  }
}

void P21Lexer::take_symbol(P21Token kind) {
  token = kind;
  text = text_.substr(at_, 1);
  ++at_;
}

void P21Lexer::skip_blank() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '\n') {
      ++line_;
      ++at_;
    } else if (c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '\0') {
      ++at_;
    } else if (c == '/' && peek(1) == '*') {
      skip_comment();
    } else if (at_ == 0 && text_.substr(0, 3) == "\xEF\xBB\xBF") {
      at_ = 3;  // byte order mark
    } else if (c == '\\' && (peek(1) == 'N' || peek(1) == 'F') && peek(2) == '\\') {
      at_ += 3;  // print control directives
    } else {
      return;
    }
  }
}

void P21Lexer::skip_comment() {
  line = line_;
  const std::size_t end = text_.find("*/", at_ + 2);
  if (end == std::string_view::npos) fail("a comment begins here and is never closed; close it with */");
  for (; at_ < end + 2; ++at_) line_ += text_[at_] == '\n';
}

void P21Lexer::read_string() {
  const std::size_t begin = at_ + 1;
  for (at_ = begin; at_ < text_.size(); ++at_) {
    if (text_[at_] == '\n') ++line_;
    if (text_[at_] != '\'') continue;
    if (peek(1) != '\'') {
      token = P21Token::kString;
      text = text_.substr(begin, at_ - begin);
      ++at_;
      return;
    }
    ++at_;
  }
  fail("a string begins here and is never closed; close it with '");
}

void P21Lexer::read_binary() {
  const std::size_t begin = ++at_;
  while (is_hex(peek())) ++at_;
  if (peek() != '"') fail("a binary value begins here and is never closed; close it with \"");
  token = P21Token::kBinary;
  text = text_.substr(begin, at_ - begin);
  ++at_;
}

void P21Lexer::read_enum() {
  const std::size_t begin = ++at_;
  while (is_letter(peek()) || is_digit(peek())) ++at_;
  if (peek() != '.' || at_ == begin)
    fail("an enumeration begins here and is never closed; write it as .NAME.");
  token = P21Token::kEnum;
  text = text_.substr(begin, at_ - begin);
  ++at_;
}

void P21Lexer::read_number() {
  const std::size_t begin = at_;
  bool real = false;
  if (peek() == '+' || peek() == '-') ++at_;
  while (is_digit(peek())) ++at_;
  if (peek() == '.') {
    real = true;
    ++at_;
    while (is_digit(peek())) ++at_;
  }
  const bool exponent = (peek() == 'E' || peek() == 'e') &&
                        (is_digit(peek(1)) || ((peek(1) == '+' || peek(1) == '-') && is_digit(peek(2))));
  if (exponent) {
    real = true;
    at_ += 2;
    while (is_digit(peek())) ++at_;
  }
  text = text_.substr(begin, at_ - begin);
  token = real ? P21Token::kReal : P21Token::kInteger;
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error == std::errc::result_out_of_range) fail("the number " + shown() + " is out of range; correct it");
  if (error != std::errc() || end != digits.data() + digits.size())
    fail(shown() + " is not a number; correct it");
}

void P21Lexer::read_reference() {
  const std::size_t begin = ++at_;
  while (is_digit(peek())) ++at_;
  text = text_.substr(begin, at_ - begin);
  token = P21Token::kReference;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (text.empty()) {
    if (is_letter(peek())) return read_keyword();  // constants of later editions: #NAME
    fail("'#' without a number; write an instance name such as #12");
  }
  if (error != std::errc() || end != text.data() + text.size())
    fail("instance name #" + std::string(text.substr(0, 40)) + " is too large; renumber the file");
}

void P21Lexer::read_keyword() {
  const std::size_t begin = at_;
  ++at_;
  while (is_letter(peek()) || is_digit(peek()) || peek() == '-') ++at_;
  token = P21Token::kKeyword;
  text = text_.substr(begin, at_ - begin);
}

void P21Lexer::read_other() {
  const std::size_t begin = at_;
  if (peek() == '<') {
    while (at_ < text_.size() && text_[at_] != '>' && text_[at_] != '\n') ++at_;
  }
  ++at_;
  if (at_ > text_.size()) at_ = text_.size();
  token = P21Token::kOther;
  text = text_.substr(begin, at_ - begin);
}

}  // namespace clearcut::read
