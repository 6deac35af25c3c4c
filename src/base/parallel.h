// Loops on several threads: the one place that asks for them.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <exception>
#include <vector>

namespace clearcut::inline base {

/// Calls work(i) for every i from `first` to below `last`, on the threads of the arena it is called in. Throws what the work
/// throws, when nothing of it runs any more. A loop around it that fails does not cut it short: TBB would else leave out the
/// rest and return as if all were done.
template <typename Index, typename Work>
void parallel_for(Index first, Index last, const Work& work) {
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(first, last, work, own);
}

/// The same for every i from 0 to below `count`; of what is thrown, what the smallest i threw: the same on any number of
/// threads. Nothing is cut short.
template <typename Work>
void parallel_in_order(std::size_t count, const Work& work) {
  std::vector<std::exception_ptr> thrown(count);
  parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    try {
      work(i);
    } catch (...) {
      thrown[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
}

/// How many threads there are for work that asks for as many as there are cores.
inline int available_threads() {
  return tbb::this_task_arena::max_concurrency();
}

/// Calls `work` so that its loops take at most `threads` threads, the caller's among them; 0: as many as there are cores.
template <typename Work>
void on_threads(int threads, const Work& work) {
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute(work);
}

/// The same as parallel_for; whoever waits for its end takes up nothing else meanwhile: what belongs to the thread stays as it
/// is.
template <typename Index, typename Work>
void isolated_parallel_for(Index first, Index last, const Work& work) {
  tbb::this_task_arena::isolate([&] { parallel_for(first, last, work); });
}

}  // namespace clearcut::inline base
