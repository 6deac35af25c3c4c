#include "read/gcode/gcode.h"

#include <cctype>
#include <charconv>

#include "base/error.h"
#include "read/gcode/interpreter.h"

namespace clearcut {

namespace {

using gcode::Block;

std::string_view trimmed_blanks(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

/// Own marker "OPERATION 3: POCKET1" or "OPERATION: POCKET1" opens a section; other comments say nothing.
void read_comment(std::string_view comment, gcode::ToolpathBuilder& builder) {
  constexpr std::string_view kMarker = "OPERATION";
  comment = trimmed_blanks(comment);
  const std::size_t colon = comment.find(':');
  if (comment.substr(0, kMarker.size()) != kMarker || colon == std::string_view::npos) return;
  const std::string_view number = trimmed_blanks(comment.substr(kMarker.size(), colon - kMarker.size()));
  int counted = 0;
  if (!number.empty()) {
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), counted);
    if (error != std::errc{} || end != number.data() + number.size() || counted < 1) return;
  }
  builder.begin_section(std::string(trimmed_blanks(comment.substr(colon + 1))), counted - 1);
}

/// A tape's text lies between two '%'; a single one ends it.
class TapeMarks {
 public:
  /// True when this block ends the program.
  bool ends(const Block& block) {
    const bool end = block.percent && begun_;
    begun_ = begun_ || block.percent || block.has_words();
    return end;
  }

 private:
  bool begun_ = false;
};

}  // namespace

Program read_gcode(std::string_view text, const std::string& file_name) {
  Program program;
  gcode::ToolpathBuilder builder(file_name, program.diagnostics);
  gcode::Interpreter interpreter(builder);
  gcode::BlockReader reader(text, file_name);
  TapeMarks marks;
  Block block;
  while (!interpreter.ended() && reader.next(block)) {
    for (const std::string_view comment : block.comments) read_comment(comment, builder);
    if (block.optional) builder.note(block.line, "blocks marked '/' are executed");
    if (marks.ends(block)) {
      program.ended = true;
      break;
    }
    if (block.has_words()) interpreter.execute(block);
  }
  program.ended = program.ended || interpreter.ended();
  if (!program.ended) program.diagnostics.warn(file_name, "the program has no end word (M2, M30)");
  program.toolpath = builder.take();
  return program;
}

}  // namespace clearcut
