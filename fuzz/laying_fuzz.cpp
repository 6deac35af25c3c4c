// Any text as a program that lays a line: read, or refused in one line.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "read/gcode/laying.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  try {
    read::gcode::read_laying({reinterpret_cast<const char*>(data), size}, "fuzz.gcode");
  } catch (const InputError&) {
  }
  return 0;
}
