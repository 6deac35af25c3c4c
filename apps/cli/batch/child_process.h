// A program that runs apart from this one, within limits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace clearcut::cli {

struct ChildLimits {
  double seconds = 0;       ///< wall clock; 0: none
  std::uint64_t bytes = 0;  ///< of address space; 0: none
};

struct ChildEnd {
  enum class How : unsigned char { kExited, kSignalled, kTimedOut };
  How how = How::kExited;
  int code = 0;  ///< exit code or signal
};

/// Runs `words` with its output in `log_file` and waits for it. Throws InputError where it cannot be started.
ChildEnd run_child(const std::vector<std::string>& words, const std::string& log_file,
                   const ChildLimits& limits);

}  // namespace clearcut::cli
