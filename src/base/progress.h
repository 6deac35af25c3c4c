// Progress of long work: the share done so far, and a way for the caller to end the work early. Counts the finished
// pieces of a long work, reports them to a callback, and ends the work when the callback asks for an end.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
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

/// Safe from several threads; the callback is called by one at a time, with counts that only grow within a stage,
/// about a thousand times at most for each stage. Keeps references to both arguments, which must outlive the meter.
class ProgressMeter {
 public:
  ProgressMeter(const ProgressCallback& callback, const std::stop_token& cancel)
      : callback_(callback), cancel_(cancel) {}

  /// A stage of at most `most` pieces of work begins. Throws Cancelled.
  void begin(Stage stage, std::size_t most);
  /// Counts further finished pieces. Throws Cancelled.
  void add(std::size_t pieces = 1);
  /// Ends the stage, regardless of its counts. Throws Cancelled.
  void finish();

 private:
  void advance_to(std::size_t done);
  void tell();

  const ProgressCallback& callback_;
  const std::stop_token& cancel_;
  std::mutex mutex_;
  Progress progress_;
  std::size_t told_ = 0;  ///< pieces of the stage done at the last call of the callback
};

/// Called before each of several plans and after the last: how many are done, of how many.
using CountCallback = std::function<void(std::size_t done, std::size_t of)>;

}  // namespace clearcut::inline base
