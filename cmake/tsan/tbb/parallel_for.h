// Stands in for TBB's header in the preset tsan: the library is not built with the thread sanitizer, which therefore does not
// see how its tasks are handed over and reports all of them. Two threads and an atomic counter do what is used here.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace tbb {

/// How many loops the thread is in.
inline thread_local int loop_depth = 0;

template <typename Index, typename Last, typename Work>
void parallel_for(Index first, Last last, Work&& work) {
  const Index end = static_cast<Index>(last);
  std::atomic<Index> next{first};
  std::exception_ptr error;
  std::mutex guard;
  const int depth = loop_depth + 1;
  const auto take = [&] {
    const int before = loop_depth;
    loop_depth = depth;
    for (Index i = next.fetch_add(1); i < end; i = next.fetch_add(1)) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(guard);
        if (!error) error = std::current_exception();
      }
    }
    loop_depth = before;
  };
  if (depth > 2) {  // threads enough
    take();
  } else {
    std::thread other(take);
    take();
    other.join();
  }
  if (error) std::rethrow_exception(error);
}

struct task_group_context {
  enum kind_type { isolated };
  task_group_context() = default;
  explicit task_group_context(kind_type) {}
  bool cancel_group_execution() { return true; }
};

template <typename Index, typename Work>
void parallel_for(Index first, Index last, Work&& work, task_group_context&) {
  tbb::parallel_for(first, last, work);
}

}  // namespace tbb
