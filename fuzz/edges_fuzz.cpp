// Any text as lengths and angles: read, or refused in one line. What is read is written as an outline and read
// again.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "post/part/part_writers.h"
#include "read/outline/outline_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  try {
    const Part part =
        read::read_edges({reinterpret_cast<const char*>(data), size}, "fuzz.edges", ReadOptions{});
    read::read_outline_json(post::write_outline_json(part), "again.json", ReadOptions{});
  } catch (const InputError&) {
  }
  return 0;
}
