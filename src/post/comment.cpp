#include "post/comment.h"

#include <algorithm>
#include <cctype>

#include "base/text/format.h"

namespace clearcut::post {

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

std::string thread_words(const Tool& tool) {
  return (tool.pitch > 0 ? " PITCH " + trimmed(tool.pitch, 4) : "") + (tool.left_hand ? " LEFT HAND" : "") +
         (tool.floating ? " FLOATING HOLDER" : "");
}

std::string tool_change_comment(const Part& part, int number) {
  const std::string change = "TOOL CHANGE T" + std::to_string(number);
  const Tool* const tool = tool_numbered(part.tools, number);
  if (tool == nullptr) return change;
  return change + ": " + plain_comment(name_of(tool->kind)) + " D" + trimmed(tool->diameter, 4) + " MM" +
         thread_words(*tool);
}

int program_number(std::string_view name) {
  if (!name.empty() && (name.front() == 'O' || name.front() == 'o')) name.remove_prefix(1);
  const bool digits = !name.empty() && name.size() <= 4 &&
                      std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int number = digits ? std::stoi(std::string(name)) : 0;
  return number > 0 ? number : 1;
}

}  // namespace clearcut::post
