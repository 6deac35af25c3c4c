#include <charconv>
#include <string>

#include "base/text.h"
#include "read/gcode/program/program.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {

namespace {

bool skip(std::string_view& text, std::string_view word) {
  if (text.substr(0, word.size()) != word) return false;
  text.remove_prefix(word.size());
  return true;
}

bool read_count(std::string_view& text, int& count) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc{} || count < 1) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

}  // namespace

void read_marker(std::string_view comment, ToolpathBuilder& builder) {
  comment = stripped(comment);
  if (!skip(comment, "OPERATION")) return;
  int counted = 0;
  if (skip(comment, " ") && !read_count(comment, counted)) return;
  if (skip(comment, ":")) builder.begin_section(std::string(stripped(comment)), counted - 1);
}

}  // namespace clearcut::read::gcode
