#include "report/motion_text.h"

#include "base/text/stripped.h"

namespace clearcut::report {
namespace {

std::string without_comments(std::string_view line) {
  std::string text;
  bool inside = false;
  for (const char c : line) {
    if (!inside && c == ';') break;
    inside = inside || c == '(';
    if (!inside) text += c;
    if (c == ')') inside = false;
  }
  return text;
}

std::string_view without_number(std::string_view line) {
  const std::size_t digits = line.find_first_not_of("0123456789");
  return digits == 0 ? line : line.substr(std::min(digits, line.size()));
}

}  // namespace

std::string motion_text(std::string_view program) {
  std::string text;
  while (!program.empty()) {
    const std::size_t end = std::min(program.find('\n'), program.size());
    const std::string line = without_comments(program.substr(0, end));
    const std::string_view words = stripped(without_number(stripped(line)));
    if (!words.empty()) text.append(words).append("\n");
    program.remove_prefix(std::min(end + 1, program.size()));
  }
  return text;
}

}  // namespace clearcut::report
