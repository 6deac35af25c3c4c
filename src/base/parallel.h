// Loops on several threads; no other file starts threads.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <exception>
#include <vector>

namespace clearcut::inline base {

/// Calls work(i) for every i from `first` to below `last`, on the threads of the arena that the caller runs in.
/// Throws the exception of the work, once no call of it runs any more. A failing loop around this one does not cut it
/// short: without this care TBB would leave out the remaining calls and return as if all were done.
template <typename Index, typename Work>
void parallel_for(Index first, Index last, const Work& work) {
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(first, last, work, own);
}

/// The same for every i from 0 to below `count`. Of several exceptions, the one of the smallest i is thrown: the same
/// on any number of threads. No call is left out.
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

/// Number of available threads when the user asks for one thread per core.
inline int available_threads() {
  return tbb::this_task_arena::max_concurrency();
}

/// Calls `work` so that its loops take at most `threads` threads, including the caller's; 0: one thread per core.
template <typename Work>
void on_threads(int threads, const Work& work) {
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute(work);
}

/// The same as parallel_for, but a thread waiting for the end of the loop takes up no other work meanwhile:
/// thread-local values stay unchanged.
template <typename Index, typename Work>
void isolated_parallel_for(Index first, Index last, const Work& work) {
  tbb::this_task_arena::isolate([&] { parallel_for(first, last, work); });
}

}  // namespace clearcut::inline base
