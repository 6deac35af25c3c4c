// The controllers whose programs are written and read, by their names in options, jobs and files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clearcut::inline model {

/// Their rows are in src/post/words/iso_dialect.cpp (Klartext has a writer of its own) and
/// src/read/gcode/program/dialect.cpp.
inline constexpr std::string_view kControllers[] = {"linuxcnc",   "grbl",  "fanuc",  "haas",
                                                    "heidenhain", "mach3", "mach4",  "marlin",
                                                    "siemens",    "mazak", "tormach"};

inline std::vector<std::string> controller_names() {
  return {std::begin(kControllers), std::end(kControllers)};
}

/// "linuxcnc, grbl, ..."
inline std::string controllers_text() {
  std::string text;
  for (const std::string_view name : kControllers) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

}  // namespace clearcut::inline model
