// Any bytes: read_gcode returns a sound toolpath or throws InputError; what it returns can be posted in every
// dialect and read again.
#include <cstdint>
#include <string_view>

#include "sound_toolpath.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Toolpath toolpath;
  try {
    toolpath = read::gcode::read_gcode(text, "fuzz").toolpath;
  } catch (const InputError&) {
    return 0;
  }
  fuzz::require_sound(toolpath);
  if (!fuzz::is_small(toolpath)) return 0;
  PostOptions options;
  options.dialect = post::post_dialects()[size % post::post_dialects().size()];
  options.inch = size % 3 == 0;
  fuzz::post_and_read_again(toolpath, options);
  return 0;
}
