// Progress of long work: the share done so far, and a way for the caller to end the work early.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <stop_token>

namespace clearcut::inline base {

/// Stages of planning.
enum class Stage {
  kPlanning,   ///< candidates: one strategy on one workingstep each
  kCertifying  ///< checking the written program; another planning stage may follow if the check finds faults
};

/// Progress of a plan.
struct Progress {
  Stage stage = Stage::kPlanning;
  std::size_t done = 0;  ///< finished pieces of the stage
  std::size_t most = 0;  ///< greatest value that `done` can reach; candidates that cannot win are not counted
};

/// Called by the threads that plan, by one at a time. It should return quickly; an exception thrown by it ends the
/// plan.
using ProgressCallback = std::function<void(const Progress&)>;

/// Thrown out of work whose stop_token was asked to stop. Nothing was written and nothing is left behind.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Throws Cancelled if a stop was requested. Cost one atomic read.
inline void throw_if_cancelled(const std::stop_token& cancel) {
  if (cancel.stop_requested()) throw Cancelled();
}

}  // namespace clearcut::inline base
