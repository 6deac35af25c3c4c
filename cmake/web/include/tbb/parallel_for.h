// Stands in for TBB's header in the preset web: a page has one thread to plan on, so loops run one turn after the other.
#pragma once

namespace tbb {

struct task_group_context {
  enum kind_type { isolated };
  task_group_context() = default;
  explicit task_group_context(kind_type) {}
};

template <typename Index, typename Last, typename Work>
void parallel_for(Index first, Last last, const Work& work) {
  for (Index i = first; i < static_cast<Index>(last); ++i) work(i);
}

template <typename Index, typename Work>
void parallel_for(Index first, Index last, const Work& work, task_group_context&) {
  // Qualified: an unqualified call would find the caller's own parallel_for() through the type of the work.
  tbb::parallel_for(first, last, work);
}

}  // namespace tbb
