// Published files that are no part of the project: the folder CLEARCUT_DATA, else ../shared/data beside the checkout. Every
// test has shapes, drawings, parts or instances of its own (shapes.h, drawings.h, plate.h, order/test_support.h); where the
// folder is there, its files are tried, too.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace clearcut::test_support {

inline std::optional<std::filesystem::path> data_folder() {
  const char* set = std::getenv("CLEARCUT_DATA");
  const std::filesystem::path folder =
      set ? std::filesystem::path(set) : std::filesystem::path(CLEARCUT_SOURCE_DIR) / "../shared/data";
  if (!std::filesystem::is_directory(folder)) return std::nullopt;
  return folder;
}

}  // namespace clearcut::test_support
