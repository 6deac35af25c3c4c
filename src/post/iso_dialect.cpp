#include "post/iso_dialect.h"

#include <array>

namespace clearcut {

namespace {

constexpr std::array kDialects{
    IsoDialect{.name = "linuxcnc",
               .line_length = 255,
               .safe_start = "G17 G40 G49 G54 G80 G90 G91.1 G94",
               .path_tolerance = true,
               .program_end = "M2"},
};

}  // namespace

const IsoDialect* iso_dialect_named(std::string_view name) {
  for (const IsoDialect& dialect : kDialects) {
    if (dialect.name == name) return &dialect;
  }
  return nullptr;
}

}  // namespace clearcut
