// Any text as a job of design elements: read, or refused in one line.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "read/outline/read_elements.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  try {
    read::read_elements_text({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
  } catch (const InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) __builtin_trap();
  }
  return 0;
}
