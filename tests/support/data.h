// The shared data folder: CLEARCUT_DATA, else ../shared/data beside the checkout. Absent: tests skip and say
// so.
#pragma once

#include <gtest/gtest.h>

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

#define CLEARCUT_SKIP_WITHOUT_DATA()                                                        \
  if (!clearcut::test_support::data_folder()) {                                             \
    GTEST_SKIP() << "the shared data folder is absent; set CLEARCUT_DATA to run this test"; \
  }
