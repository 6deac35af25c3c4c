#include "read/gcode/gcode.h"

#include "read/gcode/interpreter.h"
#include "read/gcode/klartext.h"
#include "read/gcode/marker.h"

namespace clearcut::read::gcode {

namespace {

using read::gcode::Block;

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

/// Returns whether an end was seen.
bool read_words(std::string_view text, const std::string& file_name, read::gcode::ToolpathBuilder& builder) {
  read::gcode::Interpreter interpreter(builder);
  read::gcode::BlockReader reader(text, file_name);
  TapeMarks marks;
  Block block;
  while (!interpreter.ended() && reader.next(block)) {
    for (const std::string_view comment : block.comments) interpreter.comment(comment);
    if (block.optional) builder.note(block.line, "blocks marked '/' are executed");
    if (marks.ends(block)) return true;
    if (block.has_words()) interpreter.execute(block);
  }
  return interpreter.ended();
}

}  // namespace

Program read_gcode(std::string_view text, const std::string& file_name, double home_z) {
  Program program;
  read::gcode::ToolpathBuilder builder(file_name, home_z, program.diagnostics);
  program.ended = read::gcode::is_klartext(text) ? read::gcode::read_klartext(text, builder)
                                                 : read_words(text, file_name, builder);
  if (!program.ended) program.diagnostics.warn(file_name, "the program has no end word (M2, M30, END PGM)");
  program.toolpath = builder.take();
  return program;
}

}  // namespace clearcut::read::gcode
