// A program that runs apart from this one, within limits.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace clearcut::process {

struct ChildLimits {
  double seconds = 0;            ///< wall clock; 0: none
  std::uint64_t bytes = 0;       ///< of address space; 0: none
  std::uint64_t file_bytes = 0;  ///< of each file that it writes; 0: none
};

struct ChildPlace {
  std::string log;        ///< file for what it says as errors
  std::string output;     ///< file for what it prints; "": `log`, too
  std::string folder;     ///< where it runs; "": here
  bool is_apart = false;  ///< it and what it starts end together, whoever ends it
};

struct ChildEnd {
  enum class How : unsigned char { kExited, kSignalled, kTimedOut, kStopped };
  How how = How::kExited;
  int code = 0;  ///< exit code or signal
};

/// Runs `words` (the first names the program by its path) and waits for it. `goes_on` is asked every few milliseconds; "no" ends the child.
/// The child ends with the calling thread. Throws InputError where it cannot be started.
ChildEnd run_child(const std::vector<std::string>& words, const ChildPlace& place, const ChildLimits& limits,
                   const std::function<bool()>& goes_on = {});

}  // namespace clearcut::process
