// Any text as a drill file: read, or refused in one line.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "read/board/excellon_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  ReadOptions options;
  options.depth_if_missing = 1;
  try {
    read::read_excellon({reinterpret_cast<const char*>(data), size}, "fuzz.drl", options);
  } catch (const InputError&) {
  }
  return 0;
}
