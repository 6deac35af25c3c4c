// See parallel_for.h beside this file.
#pragma once

#include "tbb/parallel_for.h"

namespace tbb {

struct task_arena {
  static constexpr int automatic = -1;
  explicit task_arena(int = automatic) {}
  template <typename Work>
  auto execute(Work&& work) {
    return work();
  }
};

namespace this_task_arena {
template <typename Work>
auto isolate(Work&& work) {
  return work();
}
/// The page's worker has one.
inline int max_concurrency() {
  return 1;
}
}  // namespace this_task_arena

}  // namespace tbb
