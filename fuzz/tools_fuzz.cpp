// Any text as a tool library of every kind: read, or refused in one line.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "read/tools/tool_library.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const char* name :
       {"/nowhere/t.toml", "/nowhere/t.tbl", "/nowhere/t.json", "/nowhere/t.fctb", "/nowhere/t.fctl"}) {
    try {
      read::read_tool_library_text(text, name, ToolOptions{});
    } catch (const InputError&) {
    }
  }
  return 0;
}
