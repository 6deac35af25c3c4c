// Any text as Klartext, with or without its first line: read_gcode returns a sound toolpath or throws InputError; what
// it returns can be posted as Klartext and read again.
#include <cstdint>
#include <string>
#include <string_view>

#include "sound_toolpath.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  std::string text(data, data + size);
  if (text.find("BEGIN PGM") == std::string::npos) text = "0 BEGIN PGM A MM\n" + text;
  Toolpath toolpath;
  try {
    toolpath = read::gcode::read_gcode(text, "fuzz.h").toolpath;
  } catch (const InputError& error) {
    CLEARCUT_ASSERT(std::string_view(error.what()).find('\n') == std::string_view::npos);
    return 0;
  }
  fuzz::require_sound(toolpath);
  if (!fuzz::is_small(toolpath)) return 0;
  PostOptions options;
  options.dialect = "heidenhain";
  options.inch = size % 2 == 0;
  fuzz::post_and_read_again(toolpath, options);
  return 0;
}
