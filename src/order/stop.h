// Stopping rule of a search, and reports of its intermediate results.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>

#include "order/problem.h"

namespace clearcut::order {

/// A best-so-far tour. Called on the thread that called solve(), or under a lock; return quickly.
struct Progress {
  const Tour& tour;
  double objective = 0;
  double seconds = 0;  ///< since the start
};

struct StopRule {
  double seconds = 10;  ///< wall clock; infinity: no limit
  /// Seconds of one core for which the method plans its work (sizes of populations); below 0: `seconds`. With
  /// `rounds` and no clock a run repeats exactly, regardless of the machine's load.
  double effort = -1;
  /// Rounds of the method; makes runs repeat exactly.
  long long rounds = std::numeric_limits<long long>::max();
  double gap = 0;                             ///< stop when (objective - bound) / bound is at most this
  const std::atomic<bool>* cancel = nullptr;  ///< checked every few milliseconds
  double planned_seconds() const { return effort < 0 ? seconds : effort; }
};

/// Reads the clock so seldom that its cost is negligible.
class StopWatch {
 public:
  explicit StopWatch(const StopRule& rule) : rule_(rule), start_(Clock::now()) {}

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  bool over() const {
    if (rule_.cancel && rule_.cancel->load(std::memory_order_relaxed)) return true;
    return seconds() >= rule_.seconds;
  }

 private:
  using Clock = std::chrono::steady_clock;
  StopRule rule_;
  Clock::time_point start_;
};

}  // namespace clearcut::order
