#include "pipeline/progress_meter.h"

#include <algorithm>

namespace clearcut::pipeline {

void ProgressMeter::begin(Stage stage, std::size_t most) {
  check();
  const std::lock_guard lock(mutex_);
  progress_ = {stage, 0, most};
  if (options_.progress) options_.progress(progress_);
}

/// Fallbacks may be planned beyond the candidates that were counted on.
void ProgressMeter::add() {
  check();
  const std::lock_guard lock(mutex_);
  progress_.done = std::min(progress_.done + 1, progress_.most);
  if (options_.progress) options_.progress(progress_);
}

}  // namespace clearcut::pipeline
