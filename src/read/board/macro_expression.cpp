#include "read/board/macro_expression.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

namespace clearcut::read {
namespace {

constexpr int kDeepest = 100;  // parentheses within parentheses

class Parser {
 public:
  Parser(std::string_view text, const MacroVariables& variables) : text_(text), variables_(variables) {}

  std::optional<double> whole() {
    const double value = sum();
    return is_good_ && at_ == text_.size() && std::isfinite(value) ? std::optional(value) : std::nullopt;
  }

 private:
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  double fail() {
    is_good_ = false;
    at_ = text_.size();
    return 0;
  }

  double sum() {
    double value = product();
    while (true) {
      if (take('+')) {
        value += product();
      } else if (take('-')) {
        value -= product();
      } else {
        return value;
      }
    }
  }

  double product() {
    double value = factor();
    while (true) {
      if (take('x') || take('X')) {
        value *= factor();
      } else if (take('/')) {
        value /= factor();
      } else {
        return value;
      }
    }
  }

  double factor() {
    double sign = 1;
    while (next() == '-' || next() == '+') sign = text_[at_++] == '-' ? -sign : sign;
    if (take('(')) {
      if (++depth_ > kDeepest) return fail();
      const double value = sum();
      --depth_;
      return take(')') ? sign * value : fail();
    }
    if (take('$')) return sign * variable();
    double value = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value, std::chars_format::fixed);
    if (error != std::errc{}) return fail();
    at_ = static_cast<std::size_t>(end - text_.data());
    return sign * value;
  }

  double variable() {
    int number = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
    if (error != std::errc{}) return fail();
    at_ = static_cast<std::size_t>(end - text_.data());
    const auto found = variables_.find(number);
    return found == variables_.end() ? 0 : found->second;
  }

  std::string_view text_;
  const MacroVariables& variables_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool is_good_ = true;
};

std::string without_blanks(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' && c != '\t') out += c;
  return out;
}

}  // namespace

std::optional<double> macro_value(std::string_view text, const MacroVariables& variables) {
  return Parser(without_blanks(text), variables).whole();
}

}  // namespace clearcut::read
