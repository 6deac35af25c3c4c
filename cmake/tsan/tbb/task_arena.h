// See parallel_for.h beside this file.
#pragma once

#include <thread>

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
inline int max_concurrency() {
  return static_cast<int>(std::thread::hardware_concurrency());
}
}  // namespace this_task_arena

}  // namespace tbb
