#include "post/comment.h"

#include <cctype>

namespace clearcut {

std::string plain_comment(std::string_view text) {
  constexpr std::string_view kPunctuation = " +-=/.,:_<>#'";
  std::string plain;
  bool first_word = true;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ',' && first_word) {
      plain += ':';
    } else if (byte < 128 && (std::isalnum(byte) || kPunctuation.find(c) != std::string_view::npos)) {
      plain += static_cast<char>(std::toupper(byte));
    } else if (byte < 128 || byte >= 192) {  // one mark for a whole UTF-8 character
      plain += c == '(' || c == ')' || std::isspace(byte) ? ' ' : '.';
    }
    first_word = first_word && (std::isalnum(byte) || c == ' ' || c == '_');
  }
  return plain;
}

std::string operation_comment(int workingstep, std::string_view label) {
  const std::string number = workingstep >= 0 ? " " + std::to_string(workingstep + 1) : "";
  return "OPERATION" + number + ": " + plain_comment(label);
}

}  // namespace clearcut
