// Any text as lengths and angles: read, or refused in one line. What is read is written as an outline and read
// again.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "post/outline_writer.h"
#include "read/edges/edges_reader.h"
#include "read/outline/outline_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  try {
    const Part part = read_edges({reinterpret_cast<const char*>(data), size}, "fuzz.edges", ReadOptions{});
    read_outline_json(write_outline_json(part), "again.json", ReadOptions{});
  } catch (const InputError&) {
  }
  return 0;
}
