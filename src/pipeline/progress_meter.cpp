#include "pipeline/progress_meter.h"

#include <algorithm>

namespace clearcut::pipeline {

void ProgressMeter::begin(Stage stage, std::size_t most) {
  const std::lock_guard lock(mutex_);
  progress_ = {stage, 0, most};
  tell();
}

/// Fallbacks may be planned beyond the candidates that were counted on.
void ProgressMeter::add() {
  const std::lock_guard lock(mutex_);
  progress_.done = std::min(progress_.done + 1, progress_.most);
  tell();
}

/// Nothing any more to those who asked to stop.
void ProgressMeter::tell() const {
  throw_if_cancelled(options_.cancel);
  if (options_.progress) options_.progress(progress_);
}

}  // namespace clearcut::pipeline
