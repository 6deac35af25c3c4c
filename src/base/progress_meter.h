// Counts the finished pieces of a long work, reports them to a callback, and ends the work when the callback asks for
// an end.
#pragma once

#include <mutex>
#include <stop_token>

#include "base/progress.h"

namespace clearcut::inline base {

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

}  // namespace clearcut::inline base
