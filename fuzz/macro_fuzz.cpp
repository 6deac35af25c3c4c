// Any bytes behind one that names a control: its program with macros is read in bounded time as a sound toolpath, or InputError
// is thrown. What stands behind a zero byte is a file with a subprogram.
#include <cstdint>
#include <string_view>

#include "sound_toolpath.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  if (size == 0) return 0;
  constexpr Dialect kDialects[] = {Dialect::kLinuxCnc, Dialect::kFanuc, Dialect::kHaas, Dialect::kMach3,
                                   Dialect::kSiemens};
  std::string_view text(reinterpret_cast<const char*>(data), size);
  read::gcode::ReadControllerOptions options;
  options.dialect = kDialects[data[0] % std::size(kDialects)];
  options.most_lines = 20'000;
  const std::string_view program = text.substr(0, text.find('\0'));
  const std::string_view other = program.size() < text.size() ? text.substr(program.size() + 1) : "";
  options.subprograms = [other](const std::string&) { return std::optional<std::string>(other); };
  try {
    fuzz::require_sound(read::gcode::read_gcode(program, "fuzz", options).toolpath);
  } catch (const InputError&) {
  }
  return 0;
}
