// The controllers whose programs are written and read, and their names in options, jobs and files.
#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::inline model {

/// A controller whose programs are written and read. docs/adding-a-controller.md tells how one is added.
enum class Dialect : unsigned char {
  kLinuxCnc,
  kGrbl,
  kFanuc,
  kHaas,
  kHeidenhain,
  kMach3,
  kMach4,
  kMarlin,
  kSiemens,
  kMazak,
  kTormach,
  kOkuma,
  kGrblHal
};

/// In the order of Dialect. Their rows are in src/post/words/iso_dialect.cpp (Klartext has a writer of its own) and
/// src/read/gcode/program/dialect.cpp.
inline constexpr std::string_view kControllers[] = {"linuxcnc", "grbl",  "fanuc",  "haas",    "heidenhain",
                                                    "mach3",    "mach4", "marlin", "siemens", "mazak",
                                                    "tormach",  "okuma", "grblhal"};

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
