#include "support/sources/tokens.h"

#include <algorithm>
#include <cctype>

namespace clearcut::test_support {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

namespace {

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text) {}

  std::vector<Token> tokens() {
    for (bool line_start = true; at_ < text_.size();) {
      const char c = text_[at_];
      if (c == '\n' || std::isspace(static_cast<unsigned char>(c)) != 0) {
        line_start = line_start || c == '\n';
        ++at_;
        continue;
      }
      if (c == '#' && line_start) {
        skip_directive();
      } else if (count_lines(); !skip_comment() && !skip_literal()) {
        take();
      }
      line_start = false;
    }
    return std::move(tokens_);
  }

 private:
  bool starts(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  void count_lines() {
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
    counted_ = at_;
  }
  void skip_past(std::string_view end, std::size_t from) {
    const std::size_t found = text_.find(end, from);
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }
  void skip_directive() {
    do {
      skip_past("\n", at_);
    } while (at_ >= 2 && text_[at_ - 2] == '\\' && at_ < text_.size());
    --at_;  // the line break begins the next line
  }
  bool skip_comment() {
    if (starts("//")) return skip_past("\n", at_), --at_, true;
    if (starts("/*")) return skip_past("*/", at_ + 2), true;
    return false;
  }
  bool skip_literal() {
    if (starts("R\"")) {
      const std::size_t open = text_.find('(', at_);
      skip_past(")" + std::string(text_.substr(at_ + 2, open - at_ - 2)) + "\"", open);
      return true;
    }
    const char quote = text_[at_];
    if (quote != '"' && quote != '\'') return false;
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    ++at_;
    add("\"");
    return true;
  }
  void add(std::string_view token) { tokens_.push_back({std::string(token), line_}); }
  void take() {
    std::size_t end = at_ + 1;
    if (is_word(text_[at_])) {
      // Numbers may hold apostrophes between their digits.
      const bool number = std::isdigit(static_cast<unsigned char>(text_[at_])) != 0;
      while (end < text_.size() && (is_word(text_[end]) || (number && text_[end] == '\''))) ++end;
    } else if (starts("::")) {
      ++end;
    }
    add(text_.substr(at_, end - at_));
    at_ = end;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
  int line_ = 1;
  std::size_t counted_ = 0;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view text) {
  return Tokenizer(text).tokens();
}

}  // namespace clearcut::test_support
