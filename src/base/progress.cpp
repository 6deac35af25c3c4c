#include "base/progress.h"

#include <algorithm>

namespace clearcut::inline base {
namespace {

/// Steps that are reported to the callback are at least this part of the stage apart.
constexpr std::size_t kSteps = 1000;

}  // namespace

void ProgressMeter::begin(Stage stage, std::size_t most) {
  const std::lock_guard lock(mutex_);
  progress_ = {stage, 0, most};
  tell();
}

/// Fallbacks may be planned in addition to the counted candidates.
void ProgressMeter::add(std::size_t pieces) {
  const std::lock_guard lock(mutex_);
  advance_to(std::min(progress_.done + pieces, progress_.most));
}

void ProgressMeter::finish() {
  const std::lock_guard lock(mutex_);
  if (progress_.done < progress_.most) advance_to(progress_.most);
}

void ProgressMeter::advance_to(std::size_t done) {
  progress_.done = done;
  const bool is_step = done == progress_.most || done - told_ >= progress_.most / kSteps;
  if (is_step) tell();
}

/// Nothing any more to those who asked to stop.
void ProgressMeter::tell() {
  throw_if_cancelled(cancel_);
  told_ = progress_.done;
  if (callback_) callback_(progress_);
}

}  // namespace clearcut::inline base
