// For tests: what a program means to the reader, told as text.
#pragma once

#include <string>

#include "base/error.h"
#include "base/text.h"
#include "read/gcode/gcode.h"

namespace clearcut::read::gcode {

inline std::string point(Vec2 p, double z) {
  return trimmed(p.x, 4) + " " + trimmed(p.y, 4) + " " + trimmed(z, 4);
}

inline std::string told(const Move& move) {
  std::string text = std::string(name_of(move.kind)) + " to " + point(move.path.to, move.z_to);
  if (move.path.is_arc()) {
    text += move.path.turn == Turn::kClockwise ? " cw about " : " ccw about ";
    text += trimmed(move.path.center.x, 4) + " " + trimmed(move.path.center.y, 4);
  }
  return is_rapid(move.kind) ? text : text + " F" + trimmed(move.feed.mm_per_min(), 3);
}

/// All moves as text, one a line, after "from" the place where the first begins.
inline std::string moves_of(const std::string& program) {
  const Program read = read_gcode(program, "test.ngc");
  std::string text;
  for (const Section& section : read.toolpath.sections) {
    for (const Move& move : section.moves) {
      if (text.empty()) text = "from " + point(move.path.from, move.z_from);
      text += "\n" + told(move);
    }
  }
  return text;
}

/// The first line begins a program at 0 0 5 without making a move.
inline std::string from_origin(const std::string& program) {
  return moves_of("G90 G0 X0 Y0\nZ5\nF100\n" + program);
}

inline std::string message_of(const std::string& program) {
  try {
    read_gcode(program, "test.ngc");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

inline std::string noticed(const std::string& program) {
  const Program read = read_gcode(program, "test.ngc");
  std::string text;
  for (const Diagnostic& item : read.diagnostics.items()) {
    text += item.where + ": " + item.what + "\n";
  }
  return text;
}

inline Program read_as(Dialect dialect, const std::string& program) {
  ReadControllerOptions options;
  options.dialect = dialect;
  return read_gcode(program, "test.ngc", options);
}

/// "name@line" of each condition, in order.
inline std::string names_of(const Program& program) {
  std::string text;
  for (const Condition& one : program.conditions) {
    text += (text.empty() ? "" : " ") + one.name + "@" + std::to_string(one.line);
  }
  return text;
}
inline std::string conditions(const std::string& program) {
  return names_of(read_gcode(program, "test.ngc"));
}
inline std::string conditions_as(Dialect dialect, const std::string& program) {
  return names_of(read_as(dialect, program));
}

inline std::string moves_as(Dialect dialect, const std::string& program) {
  std::string text;
  for (const Section& section : read_as(dialect, program).toolpath.sections) {
    for (const Move& move : section.moves) text += "\n" + told(move);
  }
  return text;
}

}  // namespace clearcut::read::gcode
