#include <filesystem>
#include <system_error>

#include "base/file.h"
#include "read/gcode/program/program.h"

namespace clearcut::read::gcode {

SubprogramFiles files_beside(const std::string& program) {
  const std::filesystem::path folder = std::filesystem::path(program).parent_path();
  return [folder](const std::string& name) -> std::optional<std::string> {
    if (name.empty() || name[0] == '.' || name.find_first_of("/\\:") != std::string::npos)
      return std::nullopt;
    const std::filesystem::path path = folder / name;
    if (!is_file(path)) return std::nullopt;
    constexpr std::size_t kLargest = std::size_t{64} << 20;
    return read_file(path.generic_string(), kLargest);
  };
}

}  // namespace clearcut::read::gcode
