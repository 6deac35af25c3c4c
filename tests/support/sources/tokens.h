// The words and signs of a C++ text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clearcut::test_support {

struct Token {
  std::string text;
  int line = 1;
};

/// Words and single signs, "::" as one, literals as "\""; no comments and preprocessor lines. Cost O(length).
std::vector<Token> tokens_of(std::string_view text);

bool is_word(char c);

}  // namespace clearcut::test_support
