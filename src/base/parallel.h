// Loops on several threads: the one place that asks for them.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace clearcut::inline base {

/// Calls work(i) for every i from `first` to below `last`, on the threads of the arena it is called in. Throws what the work
/// throws, when nothing of it runs any more. A loop around it that fails does not cut it short: TBB would else leave out the
/// rest and return as if all were done.
template <typename Index, typename Work>
void parallel_for(Index first, Index last, const Work& work) {
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(first, last, work, own);
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
