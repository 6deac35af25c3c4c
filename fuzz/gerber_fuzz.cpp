// Any text as a Gerber layer: read, or refused in one line.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "read/board/gerber_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  ReadOptions options;
  options.depth_if_missing = 1;
  try {
    read::read_gerber({reinterpret_cast<const char*>(data), size},
                      size % 2 == 1 ? "F_Cu.gbr" : "Edge_Cuts.gbr", options);
  } catch (const InputError&) {
  }
  return 0;
}
