// Limit of this process' memory: larger needs are refused in one line, before the machine is affected.
#pragma once

#include <cstddef>
#include <new>

namespace clearcut::memory {

/// Default limit of a command's allocated bytes. The process takes more: its code, and memory kept by its heap
/// between uses.
inline constexpr std::size_t kUsualLimit = 900'000'000;

/// An allocation would have gone beyond the limit.
class LimitReached : public std::bad_alloc {
 public:
  const char* what() const noexcept override { return "the limit of memory is reached"; }
};

/// The limit in CLEARCUT_MEMORY in GB, else the usual one. Throws std::invalid_argument if it is no number above 0.
std::size_t limit_asked_for();

/// From now on `new` throws LimitReached if the total allocation would exceed this number of bytes. Builds with
/// sanitizers keep their own allocator and have no limit.
void limit_to(std::size_t bytes);

/// Allocated bytes, to about 100 kB for each thread.
std::size_t held();

}  // namespace clearcut::memory
