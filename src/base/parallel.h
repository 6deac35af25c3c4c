// Loops on several threads.
#pragma once

#include <tbb/parallel_for.h>

namespace clearcut::inline base {

/// Calls work(i) for every i from `first` to below `last`, on the threads of the arena it is called in. Throws what the work
/// throws, when nothing of it runs any more. A loop around it that fails does not cut it short: TBB would else leave out the
/// rest and return as if all were done.
template <typename Index, typename Work>
void parallel_for(Index first, Index last, const Work& work) {
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(first, last, work, own);
}

}  // namespace clearcut::inline base
