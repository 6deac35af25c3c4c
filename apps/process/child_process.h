// A program run in a separate process, within limits.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace clearcut::process {

/// Sanitizers reserve more address space than any limit leaves: builds with them have none.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kLimitsMemory = false;
#else
inline constexpr bool kLimitsMemory = true;
#endif

struct ChildLimits {
  double seconds = 0;            ///< wall clock; 0: none
  std::uint64_t bytes = 0;       ///< limit of the address space; 0: none
  std::uint64_t file_bytes = 0;  ///< limit of each written file; 0: none
};

struct ChildPlace {
  std::string log;        ///< file for its error messages
  std::string output;     ///< file for its output; "": also `log`
  std::string folder;     ///< working folder; "": the current one
  bool is_apart = false;  ///< the child and its own children end together, however it is ended
};

struct ChildEnd {
  enum class How : unsigned char { kExited, kSignalled, kTimedOut, kStopped };
  How how = How::kExited;
  int code = 0;  ///< exit code or signal
};

/// Runs `words` (the first names the program by its path) and waits for it. `goes_on` is called every few
/// milliseconds; false ends the child. The child ends with the calling thread. Throws InputError if it cannot be
/// started.
ChildEnd run_child(const std::vector<std::string>& words, const ChildPlace& place, const ChildLimits& limits,
                   const std::function<bool()>& goes_on = {});

}  // namespace clearcut::process
