// Any text as a machine file: read, or refused in one line; what is read has a sense.
#include <cmath>
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "read/job/machine_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  try {
    const Machine machine = read::read_machine_text({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
    CLEARCUT_ASSERT(machine.rapid.mm_per_min() > 0 && machine.acceleration > 0 &&
                    machine.junction_deviation > 0);
    CLEARCUT_ASSERT(std::isfinite(home_z(machine)));
    if (!machine.travel) return 0;
    for (const auto& range : *machine.travel) CLEARCUT_ASSERT(range[0] < range[1]);
  } catch (const InputError& error) {
    CLEARCUT_ASSERT(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
