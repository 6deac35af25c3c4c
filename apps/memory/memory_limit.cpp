#include "memory/memory_limit.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace clearcut::memory {
namespace {

constexpr double kGigabyte = 1e9;
/// Bytes a thread may allocate or free before the common count is updated.
constexpr std::ptrdiff_t kHeard = 1 << 16;

std::atomic<std::ptrdiff_t> in_common{0};
std::atomic<std::ptrdiff_t> most{PTRDIFF_MAX};
thread_local std::ptrdiff_t own = 0;  // not yet in the common count

[[maybe_unused]] bool is_too_much(std::size_t bytes) noexcept {
  const std::ptrdiff_t left =
      most.load(std::memory_order_relaxed) - in_common.load(std::memory_order_relaxed);
  return left < 0 || bytes > static_cast<std::size_t>(left);
}

/// Counts the real size of a block.
[[maybe_unused]] void count_taken(void* block) noexcept {
  own += static_cast<std::ptrdiff_t>(malloc_usable_size(block));
  if (own > kHeard) in_common.fetch_add(std::exchange(own, 0), std::memory_order_relaxed);
}

[[maybe_unused]] void count_given_back(void* block) noexcept {
  own -= static_cast<std::ptrdiff_t>(malloc_usable_size(block));
  if (own < -kHeard) in_common.fetch_add(std::exchange(own, 0), std::memory_order_relaxed);
}

}  // namespace

std::size_t limit_asked_for() {
  const char* wish = std::getenv("CLEARCUT_MEMORY");
  if (wish == nullptr || *wish == '\0') return kUsualLimit;
  const std::string_view text(wish);
  double gigabytes = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), gigabytes);
  if (error != std::errc{} || end != text.data() + text.size() || !(gigabytes > 0) || gigabytes > 1e6)
    throw std::invalid_argument("CLEARCUT_MEMORY=" + std::string(text) +
                                " is no number of GB; write for example CLEARCUT_MEMORY=4");
  return static_cast<std::size_t>(gigabytes * kGigabyte);
}

void limit_to(std::size_t bytes) {
  most = static_cast<std::ptrdiff_t>(bytes);
}

std::size_t held() {
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, in_common + own));
}

}  // namespace clearcut::memory

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CLEARCUT_OWN_ALLOCATOR 0
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__EMSCRIPTEN__)
#define CLEARCUT_OWN_ALLOCATOR 0
#endif

#ifndef CLEARCUT_OWN_ALLOCATOR

void* operator new(std::size_t bytes) {
  if (clearcut::memory::is_too_much(bytes)) throw clearcut::memory::LimitReached();
  void* block = std::malloc(bytes == 0 ? 1 : bytes);
  if (block == nullptr) throw std::bad_alloc();
  clearcut::memory::count_taken(block);
  return block;
}

void operator delete(void* block) noexcept {
  if (block == nullptr) return;
  clearcut::memory::count_given_back(block);
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept {
  operator delete(block);
}

#endif
