// Stands in for own_program.cpp on Windows.
#include <windows.h>

#include <filesystem>

#include "base/programs.h"

namespace clearcut::inline base {

std::string own_program() {
  std::wstring name(MAX_PATH, L'\0');
  for (;;) {
    const DWORD size = GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
    if (size < name.size()) return std::filesystem::path(name.substr(0, size)).string();
    name.resize(2 * name.size());
  }
}

std::string program_file(const std::string& name) {
  return name + ".exe";
}

}  // namespace clearcut::inline base
