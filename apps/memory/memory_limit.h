// How much memory this process may hold: what needs more is refused in one line, before the machine suffers.
#pragma once

#include <cstddef>
#include <new>

namespace clearcut::memory {

/// Bytes that a command holds at most where nothing else is said. The process takes some more: its code, and what its heap
/// keeps between two uses.
inline constexpr std::size_t kUsualLimit = 900'000'000;

/// An allocation would have gone beyond the limit.
class LimitReached : public std::bad_alloc {
 public:
  const char* what() const noexcept override { return "the limit of memory is reached"; }
};

/// The limit that CLEARCUT_MEMORY names in GB, else the usual one. Throws std::invalid_argument where it is no number above 0.
std::size_t limit_asked_for();

/// From now on `new` throws LimitReached where all that is held would come to more than so many bytes. Builds with sanitizers
/// keep their own allocator and have no limit.
void limit_to(std::size_t bytes);

/// Bytes that are held, to some 100 kB for each thread.
std::size_t held();

}  // namespace clearcut::memory
